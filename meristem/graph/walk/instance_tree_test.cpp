// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "meristem/graph/instances.h"
#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::instance_tree_test {

/// 300 bushes, with one stick on bushes of an even index and two on the others. Some sticks are omitted.
Graph bushes_with_sticks() {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("field", "star", {{"number", 300}});
  builder.component("bush", "star", {{"number", "1 + i % 2"}});
  builder.component("leaf", "stick", {{"omit", Value::List{"i == 1"}}});
  return builder.link("view", "field").link("field", "bush").link("bush", "leaf").sound_graph();
}

InstanceTree tree_of(const Graph& graph, std::uint64_t max = 1'000'000) {
  Progress progress;
  return instance_tree(graph, Scene(), 0, max, progress);
}

TEST(InstanceTree, HasEachInstanceOnItsParent) {
  const Graph graph = bushes_with_sticks();
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
  EXPECT_EQ(counts, (std::map<std::string, std::size_t>{{"view", 1}, {"field", 1}, {"bush", 300}, {"leaf", 450}}));
  std::map<std::uint32_t, std::uint32_t> leaves;
  for (const InstanceTree::Instance& instance : tree.instances) {
    if (graph.components[instance.component].id == "leaf") ++leaves[instance.parent];
  }
  for (const auto& [bush, count] : leaves) EXPECT_EQ(count, 1 + tree.instances[bush].i % 2) << bush;
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
  const Graph graph = bushes_with_sticks();
  EXPECT_EQ(tree_of(graph, 752).instances.size(), 752U);
  const std::vector<Diagnostic> errors = errors_of([&] { tree_of(graph, 751); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].message, "there are more than 751 instances");
  EXPECT_EQ(errors[0].path, "components.leaf");
  EXPECT_EQ(errors_of([&] { tree_of(graph, 0); }).at(0).path, "components.view");
}

}  // namespace meristem::instance_tree_test
