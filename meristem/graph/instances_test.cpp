// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/instances.h"

#include <map>

#include <gtest/gtest.h>

#include "meristem/graph/expand.h"
#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::instances_test {

Scene still_scene() {
  Scene scene;
  scene.fingerprint = 1;
  return scene;
}

/// Poles on a star, sticks along them; every third stick is left out.
Graph poles_with_sticks() {
  GraphBuilder graph(test_components());
  graph.component("view", "camera").component("star", "star", {{"number", 300}, {"step", 0.5}});
  graph.component("pole", "pole", {{"height", "1 + i/300"}, {"nodes", 5}});
  graph.component("leaf", "stick", {{"length", "0.1*rand(0.5, 1)"}, {"omit", Value::List{"i % 3 == 0"}}});
  graph.link("view", "star").link("star", "pole");
  graph.link("pole", "leaf", LinkKind::branch, {{"density", 6}});
  return graph.sound_graph();
}

TEST(Instances, TreeHasEachInstanceOnItsParent) {
  const Graph graph = poles_with_sticks();
  Progress progress;
  const InstanceTree tree = instance_tree(graph, still_scene(), 0, 1'000'000, progress);
  std::map<std::string, std::size_t> counts;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> siblings;
  for (std::uint32_t k = 0; k < tree.instances.size(); ++k) {
    const InstanceTree::Instance& instance = tree.instances[k];
    ++counts[graph.components[instance.component].id];
    if (k == 0) {
      EXPECT_EQ(instance.parent, kNoIndex);
      continue;
    }
    ASSERT_LT(instance.parent, k);
    EXPECT_EQ(graph.links[instance.link].to, instance.component);
    EXPECT_EQ(graph.links[instance.link].from, tree.instances[instance.parent].component);
    EXPECT_EQ(instance.i, (siblings[{instance.parent, instance.link}]++));
    EXPECT_LT(instance.i, instance.n);
  }
  EXPECT_EQ(counts["pole"], 300U);
  EXPECT_GE(counts["leaf"], 300U * 6);
}

TEST(Instances, EachOrganAndStemHasItsInstance) {
  const Graph graph = poles_with_sticks();
  const Scene scene = still_scene();
  Progress progress;
  Cache cache;
  const Plant plant = expand(graph, scene, 0, progress, &cache);
  std::size_t organs = 0;
  for (const Organ& organ : plant.organs) organs += plant.prototypes[organ.prototype].component == "leaf" ? 1 : 0;
  std::map<std::string, std::size_t> first;
  for (std::size_t k = 0; k < plant.organs.size(); ++k) {
    first.try_emplace(plant.prototypes[plant.organs[k].prototype].component, k);
  }
  for (const std::size_t number : {std::size_t{0}, std::size_t{1}, organs / 2, organs - 1}) {
    const auto found = find_instance(graph, scene, 0, {.component = "leaf", .number = number}, progress, &cache);
    ASSERT_TRUE(found) << number;
    EXPECT_NE(found->site.i % 3, 0U);
    const Frame& frame = plant.organs[first["leaf"] + number].frame;
    EXPECT_LT(glm::length(found->site.frame.origin - frame.origin), 1e-5F) << number;
    ASSERT_EQ(found->values.size(), 1U);
    EXPECT_EQ(found->values[0].first, "components.leaf.length");
    EXPECT_GE(found->values[0].second, 0.05);
    EXPECT_LE(found->values[0].second, 0.1);
  }
  EXPECT_FALSE(find_instance(graph, scene, 0, {.component = "leaf", .number = organs}, progress, &cache));
  EXPECT_FALSE(find_instance(graph, scene, 0, {.component = "nobody"}, progress, &cache));
  const auto third = find_instance(
      graph, scene, 0, {.component = "pole", .of = InstanceQuery::Of::instance, .number = 2}, progress, &cache);
  ASSERT_TRUE(third);
  EXPECT_EQ(third->site.i, 2U);
  EXPECT_FALSE(find_instance(graph, scene, 0, {.component = "pole", .of = InstanceQuery::Of::instance, .number = 300},
                             progress, &cache));
  const auto pole = find_instance(graph, scene, 0, {.component = "pole", .of = InstanceQuery::Of::stem, .number = 271},
                                  progress, &cache);
  ASSERT_TRUE(pole);
  EXPECT_EQ(pole->site.i, 271U);
  EXPECT_DOUBLE_EQ(pole->values[0].second, 1 + 271.0 / 300);
}

TEST(Instances, AreCountedWithoutThoseThatAreLeftOut) {
  const Graph graph = poles_with_sticks();
  const Scene scene = still_scene();
  Progress progress;
  Cache cache;
  const Plant plant = expand(graph, scene, 0, progress, &cache);
  const std::vector<std::uint64_t> counts = instance_counts(graph, scene, 0, progress, &cache);
  EXPECT_EQ(counts, (std::vector<std::uint64_t>{1, 1, 300, organs_of(plant, "leaf").size()}));
}

TEST(Instances, AskingLeavesTheCacheAsItWas) {
  const Graph graph = poles_with_sticks();
  const Scene scene = still_scene();
  Progress progress;
  Cache cache;
  expand(graph, scene, 0, progress, &cache);
  const std::uint64_t bytes = cache.bytes();
  find_instance(graph, scene, 0, {.component = "pole", .of = InstanceQuery::Of::stem}, progress, &cache);
  EXPECT_EQ(cache.bytes(), bytes);
}

}  // namespace meristem::instances_test
