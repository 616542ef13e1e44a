// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "meristem/graph/batch.h"
#include "meristem/graph/expand.h"
#include "meristem/graph/instances.h"
#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::instance_counts_test {

Scene known_scene() {
  Scene scene;
  scene.fingerprint = 1;
  return scene;
}

/// 300 poles on a star, with sticks along them; every third stick is omitted.
Graph poles_with_sticks() {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("star", "star", {{"number", 300}});
  builder.component("pole", "pole", {{"nodes", 5}}).component("leaf", "stick", {{"omit", Value::List{"i % 3 == 0"}}});
  builder.link("view", "star").link("star", "pole").link("pole", "leaf", LinkKind::branch, {{"count", 8}});
  return builder.sound_graph();
}

TEST(InstanceCounts, OmittedInstancesDoNotCount) {
  const Graph graph = poles_with_sticks();
  Progress progress;
  const std::vector<std::uint64_t> counts = instance_counts(graph, known_scene(), 0, progress);
  EXPECT_EQ(counts, (std::vector<std::uint64_t>{1, 1, 300, 300 * 5}));
}

TEST(InstanceCounts, WithTheCacheOfAnExpansionNothingIsMadeAgain) {
  const Graph graph = poles_with_sticks();
  Progress progress;
  Cache cache;
  const Plant plant = expand(graph, known_scene(), 0, progress, &cache);
  const std::vector<std::uint64_t> counts = instance_counts(graph, known_scene(), 0, progress, &cache);
  EXPECT_EQ(counts, (std::vector<std::uint64_t>{1, 1, 300, organs_of(plant, "leaf").size()}));
  EXPECT_EQ(cache.reuse<BatchResult>().made, 0U);
}

TEST(InstanceCounts, ABatchOfAComponentAddsToItsEarlierBatches) {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("stick", "stick", {{"recursion", 7}});
  const Graph graph = builder.link("view", "stick").link("stick", "stick").sound_graph();
  Progress progress;
  EXPECT_EQ(instance_counts(graph, Scene(), 0, progress), (std::vector<std::uint64_t>{1, 7}));
}

}  // namespace meristem::instance_counts_test
