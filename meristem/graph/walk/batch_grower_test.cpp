// SPDX-License-Identifier: Apache-2.0
// Batches of sprouts, whose height is divided by the number of sprouts in their stand.
#include "meristem/graph/walk/batch_grower.h"

#include <string>
#include <typeinfo>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::batch_grower_test {

constexpr ComponentIndex kFirst = 1;
constexpr ComponentIndex kSecond = 2;

/// A camera with two components of sprouts.
Graph two_components(const Value::Object& first, const Value::Object& second) {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("first", "sprout", first).component("second", "sprout", second);
  return builder.link("view", "first").link("view", "second").sound_graph();
}

Scene known_scene() {
  Scene scene;
  scene.fingerprint = 1;
  return scene;
}

/// A batch of sprouts one metre apart, with the random keys 0, 1, ...
Batch batch_of(ComponentIndex component, int count) {
  auto places = std::make_shared<Sites>();
  for (int k = 0; k < count; ++k) {
    Site site;
    site.frame.origin.x = static_cast<float>(k);
    site.key = RandomKey(static_cast<std::uint64_t>(k));
    places->sites.add(site);
  }
  places->hash = hash_of(places->sites);
  return {component, std::move(places)};
}

/// A grower with everything that it needs.
struct Nursery {
  Graph graph;
  Scene scene = known_scene();
  Directions directions = scene.directions();
  Progress progress;
  GrowthView view;
  ShownGrowth shown{graph, view};
  CacheRun results;
  ResultKeys keys{graph, scene, 0, shown, results};
  WalkContext context{graph, scene, directions, 0, progress, shown, keys, results};
  BatchGrower grower{context};

  explicit Nursery(Graph of, Cache* cache = nullptr, GrowthView as = {})
      : graph(std::move(of)), view(std::move(as)), results(cache, {typeid(GrownBatch)}) {}
  ~Nursery() { results.end(); }
  Nursery(const Nursery&) = delete;
  Nursery& operator=(const Nursery&) = delete;

  /// Grows three sprouts of the first component and two of the second.
  std::vector<Grown> grow() const {
    const std::vector<Batch> batches{batch_of(kFirst, 3), batch_of(kSecond, 2)};
    return grower.grow(batches);
  }
};

/// Number of grown plants that were computed, and that were found in the cache.
using Numbers = std::pair<std::uint64_t, std::uint64_t>;

/// Grows a graph with a cache and returns the numbers of this growth.
Numbers grown_with(Cache& cache, const Graph& graph) {
  Nursery(graph, &cache).grow();
  return {cache.reuse<GrownBatch>().made, cache.reuse<GrownBatch>().reused};
}

float height_of(const Skeleton& skeleton) { return skeleton.position[1].y; }

TEST(BatchGrower, AllBatchesGrowInOneStand) {
  const std::vector<Grown> grown = Nursery(two_components({{"height", 1}}, {{"height", 2}})).grow();
  ASSERT_EQ(grown.size(), 2U);
  ASSERT_EQ(grown[0].batch->skeletons.size(), 3U);
  ASSERT_EQ(grown[1].batch->skeletons.size(), 2U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_FLOAT_EQ(height_of(grown[0].batch->skeletons[k]), 1.0F / 5);
    EXPECT_EQ(grown[0].batch->skeletons[k].position[0].x, static_cast<float>(k));
  }
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_FLOAT_EQ(height_of(grown[1].batch->skeletons[k]), 2.0F / 5);
    EXPECT_EQ(grown[1].batch->skeletons[k].position[0].x, static_cast<float>(k));
  }
}

TEST(BatchGrower, PlantsThatGrowAloneHaveStandsOfTheirOwn) {
  const std::vector<Grown> grown = Nursery(two_components({{"alone", true}}, {})).grow();
  for (const Skeleton& skeleton : grown[0].batch->skeletons) EXPECT_FLOAT_EQ(height_of(skeleton), 1);
  for (const Skeleton& skeleton : grown[1].batch->skeletons) EXPECT_FLOAT_EQ(height_of(skeleton), 1.0F / 2);
}

TEST(BatchGrower, AChangeOfOneBatchGrowsTheWholeStandAgain) {
  Cache cache;
  EXPECT_EQ(grown_with(cache, two_components({}, {})), Numbers(5, 0));
  EXPECT_EQ(grown_with(cache, two_components({}, {})), Numbers(0, 5));
  EXPECT_EQ(grown_with(cache, two_components({}, {{"height", 3}})), Numbers(5, 0));
}

TEST(BatchGrower, AChangeOfPlantsThatGrowAloneLeavesTheOthers) {
  Cache cache;
  grown_with(cache, two_components({}, {{"alone", true}}));
  EXPECT_EQ(grown_with(cache, two_components({}, {{"alone", true}, {"height", 3}})), Numbers(2, 3));
}

TEST(BatchGrower, CachedPlantsEqualGrownOnes) {
  Cache cache;
  const Graph graph = two_components({{"height", 1}}, {{"height", 2}});
  const std::vector<Grown> first = Nursery(graph, &cache).grow();
  const std::vector<Grown> second = Nursery(graph, &cache).grow();
  ASSERT_TRUE(first[0].key);
  EXPECT_NE(first[0].key, first[1].key);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(first[k].key, second[k].key);
    EXPECT_EQ(first[k].batch, second[k].batch);
  }
}

TEST(BatchGrower, SkeletonsAreMovedOutOnlyIfNobodyElseNeedsThem) {
  Nursery without_cache(two_components({}, {}));
  const std::vector<Grown> own = without_cache.grow();
  EXPECT_EQ(without_cache.grower.take_skeleton(own[0], kFirst, 2, without_cache.progress).node_count(), 2U);
  EXPECT_EQ(own[0].batch->skeletons[2].node_count(), 0U);
  Cache cache;
  Nursery with_cache(two_components({}, {}), &cache);
  const std::vector<Grown> shared = with_cache.grow();
  EXPECT_EQ(with_cache.grower.take_skeleton(shared[0], kFirst, 2, with_cache.progress).node_count(), 2U);
  EXPECT_EQ(shared[0].batch->skeletons[2].node_count(), 2U);
}

TEST(BatchGrower, OnlyComponentsThatTheViewLooksAtAreShownAtItsStep) {
  GrowthView view;
  view.step = 1;
  view.of = "second";
  Nursery nursery(two_components({}, {}), nullptr, view);
  const std::vector<Grown> grown = nursery.grow();
  const Skeleton whole = nursery.grower.take_skeleton(grown[0], kFirst, 0, nursery.progress);
  const Skeleton half = nursery.grower.take_skeleton(grown[1], kSecond, 0, nursery.progress);
  EXPECT_FLOAT_EQ(height_of(whole), 1.0F / 5);
  EXPECT_FLOAT_EQ(height_of(half), 0.5F / 5);
}

TEST(BatchGrower, AWatchedGrowthHasTheKeyOfTheInstanceThatShowsIt) {
  Graph graph = two_components({}, {{"watches", true}});
  graph.components[kSecond].shown = "first";
  const std::vector<Grown> grown = Nursery(graph).grow();
  EXPECT_TRUE(grown[0].watched.empty());
  ASSERT_EQ(grown[1].watched.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NE(grown[1].watched[k], nullptr);
    EXPECT_EQ(grown[1].watched[k], grown[0].batch->traces[k]);
  }
}

TEST(BatchGrower, TheKeyOfAWatcherCoversTheGrowthThatItShows) {
  const auto key_of_watcher = [](double height) {
    Cache cache;
    Graph graph = two_components({{"height", height}, {"alone", true}}, {{"watches", true}});
    graph.components[kSecond].shown = "first";
    return Nursery(graph, &cache).grow()[1].key;
  };
  ASSERT_TRUE(key_of_watcher(1));
  EXPECT_EQ(key_of_watcher(1), key_of_watcher(1));
  EXPECT_NE(key_of_watcher(1), key_of_watcher(2));
}

}  // namespace meristem::batch_grower_test
