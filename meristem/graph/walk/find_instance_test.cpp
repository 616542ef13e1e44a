// SPDX-License-Identifier: Apache-2.0
#include <map>

#include <gtest/gtest.h>

#include "meristem/graph/expand.h"
#include "meristem/graph/instances.h"
#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::find_instance_test {

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

TEST(FindInstance, EachOrganAndStemHasItsInstance) {
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

TEST(FindInstance, AskingLeavesTheCacheAsItWas) {
  const Graph graph = poles_with_sticks();
  const Scene scene = still_scene();
  Progress progress;
  Cache cache;
  expand(graph, scene, 0, progress, &cache);
  const std::uint64_t bytes = cache.bytes();
  find_instance(graph, scene, 0, {.component = "pole", .of = InstanceQuery::Of::stem}, progress, &cache);
  EXPECT_EQ(cache.bytes(), bytes);
}

TEST(FindInstance, APlantAtItsLimitsCanBeSearched) {
  // An instance that is expanded once more must not count twice.
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("star", "star", {{"number", 300}});
  builder.component("pole", "pole", {{"nodes", 5}}).link("view", "star").link("star", "pole");
  const Graph graph = builder.node_limit(300 * 5).instance_limit(302).sound_graph();
  const Scene scene = still_scene();
  Progress progress;
  for (const std::uint64_t number : {0U, 17U, 299U}) {
    const auto found = find_instance(graph, scene, 0,
                                     {.component = "pole", .of = InstanceQuery::Of::stem, .number = number}, progress);
    ASSERT_TRUE(found) << number;
    EXPECT_EQ(found->site.i, number);
  }
}

TEST(FindInstance, PartsAreNumberedOverAllBatchesOfTheComponent) {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("star", "star", {{"number", 2}});
  builder.component("twig", "stick", {{"recursion", 3}}).link("view", "star").link("star", "twig").link("twig", "twig");
  const Graph graph = builder.sound_graph();
  Progress progress;
  for (const auto of : {InstanceQuery::Of::organ, InstanceQuery::Of::instance}) {
    for (std::uint64_t number = 0; number < 6; ++number) {
      const InstanceQuery query{.component = "twig", .of = of, .number = number};
      const auto found = find_instance(graph, still_scene(), 0, query, progress);
      ASSERT_TRUE(found) << number;
      EXPECT_EQ(found->site.depth, number / 2);
      EXPECT_EQ(found->site.frame.origin.x, static_cast<float>(number % 2));
    }
    EXPECT_FALSE(find_instance(graph, still_scene(), 0, {.component = "twig", .of = of, .number = 6}, progress));
  }
}

TEST(FindInstance, AGrownStemHasTheInstanceThatPlantedIt) {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("star", "star", {{"number", 5}}).component("sprout", "sprout");
  const Graph graph = builder.link("view", "star").link("star", "sprout").sound_graph();
  Progress progress;
  const InstanceQuery query{.component = "sprout", .of = InstanceQuery::Of::stem, .number = 3};
  const auto found = find_instance(graph, still_scene(), 0, query, progress);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->site.i, 3U);
}

}  // namespace meristem::find_instance_test
