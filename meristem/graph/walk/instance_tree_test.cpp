// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "meristem/graph/instances.h"
#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::instance_tree_test {

/// 300 poles on a star, with sticks along them.
Graph poles_with_sticks() {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("star", "star", {{"number", 300}});
  builder.component("pole", "pole", {{"nodes", 5}}).component("leaf", "stick", {{"omit", Value::List{"i % 3 == 0"}}});
  builder.link("view", "star").link("star", "pole").link("pole", "leaf", LinkKind::branch, {{"count", "1 + i % 2"}});
  return builder.sound_graph();
}

InstanceTree tree_of(const Graph& graph, std::uint64_t max = 1'000'000) {
  Progress progress;
  return instance_tree(graph, Scene(), 0, max, progress);
}

TEST(InstanceTree, HasEachInstanceOnItsParent) {
  const Graph graph = poles_with_sticks();
  const InstanceTree tree = tree_of(graph);
  std::map<std::string, std::size_t> counts;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> siblings;
  for (std::uint32_t k = 0; k < tree.instances.size(); ++k) {
    const InstanceTree::Instance& instance = tree.instances[k];
    ++counts[graph.components[instance.component].id];
    if (k == 0) {
      EXPECT_EQ(instance.parent, kNoIndex);
      EXPECT_EQ(instance.link, kNoIndex);
      continue;
    }
    ASSERT_LT(instance.parent, k);
    EXPECT_EQ(graph.links[instance.link].to, instance.component);
    EXPECT_EQ(graph.links[instance.link].from, tree.instances[instance.parent].component);
    EXPECT_EQ(instance.i, (siblings[{instance.parent, instance.link}]++));
    EXPECT_LT(instance.i, instance.n);
  }
  EXPECT_EQ(counts, (std::map<std::string, std::size_t>{{"view", 1}, {"star", 1}, {"pole", 300}, {"leaf", 450}}));
  // A pole with an odd index bears two sticks, all others bear one.
  std::map<std::uint32_t, std::uint32_t> leaves;
  for (const InstanceTree::Instance& instance : tree.instances) {
    if (graph.components[instance.component].id == "leaf") ++leaves[instance.parent];
  }
  for (const auto& [pole, count] : leaves) EXPECT_EQ(count, 1 + tree.instances[pole].i % 2) << pole;
}

TEST(InstanceTree, ChildrenOfGrownPlantsStandOnTheirOwnPlant) {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("star", "star", {{"number", 5}}).component("sprout", "sprout");
  builder.component("tip", "stick").component("stick", "stick");
  builder.link("view", "star").link("star", "sprout").link("star", "stick");
  builder.link("sprout", "tip", LinkKind::leaf);
  const Graph graph = builder.sound_graph();
  const InstanceTree tree = tree_of(graph);
  ASSERT_EQ(tree.instances.size(), 1 + 1 + 5 + 5 + 5U);
  std::set<std::uint32_t> sprouts;
  for (const InstanceTree::Instance& instance : tree.instances) {
    if (graph.components[instance.component].id != "tip") continue;
    sprouts.insert(tree.instances[instance.parent].i);
    EXPECT_EQ(graph.components[tree.instances[instance.parent].component].id, "sprout");
  }
  EXPECT_EQ(sprouts, (std::set<std::uint32_t>{0, 1, 2, 3, 4}));
}

TEST(InstanceTree, MoreInstancesThanRequestedAreRefused) {
  const Graph graph = poles_with_sticks();
  EXPECT_EQ(tree_of(graph, 752).instances.size(), 752U);
  const std::vector<Diagnostic> errors = errors_of([&] { tree_of(graph, 751); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].message, "there are more than 751 instances");
  EXPECT_EQ(errors[0].path, "components.leaf");
  EXPECT_EQ(errors_of([&] { tree_of(graph, 0); }).at(0).path, "components.view");
}

}  // namespace meristem::instance_tree_test
