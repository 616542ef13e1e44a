// SPDX-License-Identifier: Apache-2.0
// Whole plants that components request from other documents. A source in memory stands in for a document.
#include "meristem/graph/grow_plantings.h"

#include <atomic>
#include <functional>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meristem/base/cache.h"
#include "meristem/base/parallel.h"
#include "meristem/graph/table/plant_source.h"
#include "meristem/plant/plant_variant.h"
#include "tests/support/build_graph.h"

namespace meristem::grow_plantings_test {

using testing::HasSubstr;

std::atomic<int> grown{0};

/// A plant with as many nodes as its request says by `nodes`; 3 without it. A negative number is an error.
class Sapling : public PlacedGrowth {
 public:
  explicit Sapling(const PlantRequest& request) : nodes_(request.values.empty() ? 3 : request.values[0].second) {}

  ShownPlant show(const GrowthView&, const Progress&) override {
    ++grown;
    if (nodes_ < 0) throw InputError(Diagnostic{.message = fmt::format("{} nodes", nodes_), .path = "components.own"});
    auto plant = std::make_shared<Plant>();
    plant->stems.emplace_back();
    for (int k = 0; k < nodes_; ++k) {
      plant->stems[0].skeleton.add_node(k == 0 ? kNoNode : static_cast<NodeIndex>(k - 1), Vec3(0), 0);
    }
    auto variant = std::make_shared<PlantVariant>();
    variant->plant = plant;
    return {variant, nullptr};
  }
  std::uint64_t bytes() const override { return 0; }

 private:
  double nodes_;
};

class Nursery : public PlantSource {
 public:
  const std::string& file() const override { return file_; }
  std::uint64_t fingerprint() const override { return 1; }
  Handle handle(const std::string&) const override { return {}; }
  std::shared_ptr<PlacedGrowth> plant(const PlantRequest& request) const override {
    return std::make_shared<Sapling>(request);
  }

 private:
  std::string file_ = "nursery.json";
};

const std::shared_ptr<const PlantSource> kNursery = std::make_shared<const Nursery>();
std::function<void(OrganSink& organs)> expansion;

struct Planter : ComponentBase {};

ComponentType type(ComponentTraits traits, ExpandFunction<Planter> expand) {
  return define_component<Planter>(
      {.traits = std::move(traits), .parameters = Table<Planter>("a planter", "A test's."), .expand = expand});
}

const Registry& registry() {
  static const Registry made(
      {type({.name = "camera", .doc = "The root.", .is_camera = true}, [](const Planter&, const Site&) {}),
       type({.name = "planter", .doc = "Requests plants.", .has_geometry = false, .is_whole_plant = true},
            [](const Planter&, const Site&, OrganSink& organs) { expansion(organs); })});
  return made;
}

GraphBuilder garden() {
  GraphBuilder builder(registry());
  builder.component("view", "camera").component("planter", "planter").link("view", "planter");
  return builder;
}

Plant grow(const GraphBuilder& builder, std::function<void(OrganSink& organs)> with, Cache* cache = nullptr) {
  expansion = std::move(with);
  grown = 0;
  return builder.grow(0, {}, cache);
}

void request(OrganSink& organs, float x, double nodes, std::uint64_t seed = 1) {
  organs.add_plant(Frame{.origin = {x, 0, 0}}, kNursery, {.values = {{"nodes", nodes}}, .seed = seed});
}

TEST(GrowPlantings, EqualRequestsAreGrownOnceAndStandInSeveralPlaces) {
  const Plant plant = grow(garden(), [](OrganSink& organs) {
    request(organs, 1, 4);
    request(organs, 2, 5);
    request(organs, 3, 4);
  });
  EXPECT_EQ(grown, 2);
  ASSERT_EQ(plant.plantings.size(), 2U) << "in the order of the first requests";
  ASSERT_EQ(plant.plantings[0].places.size(), 2U);
  EXPECT_EQ(plant.plantings[0].component, "planter");
  EXPECT_EQ(plant.plantings[0].variant->plant->node_count(), 4U);
  EXPECT_EQ(plant.plantings[0].places[1].frame.origin, Vec3(3, 0, 0));
  EXPECT_EQ(plant.plantings[0].places[1].instance, 2U);
  EXPECT_EQ(plant.plantings[1].places[0].instance, 1U);
}

TEST(GrowPlantings, AnotherSeedIsAnotherPlant) {
  const Plant plant = grow(garden(), [](OrganSink& organs) {
    request(organs, 0, 4, 1);
    request(organs, 0, 4, 2);
  });
  EXPECT_EQ(grown, 2);
  ASSERT_EQ(plant.plantings.size(), 2U);
  EXPECT_NE(plant.plantings[0].variant->key, plant.plantings[1].variant->key);
}

TEST(GrowPlantings, PlacesThatHaveShrunkToNothingHaveNoPlant) {
  const Plant plant = grow(garden(), [](OrganSink& organs) {
    organs.add_plant(Frame{.axes = Mat3(0)}, kNursery, {});
    organs.add_plant(Frame{}, kNursery, {});
  });
  ASSERT_EQ(plant.plantings.size(), 1U);
  ASSERT_EQ(plant.plantings[0].places.size(), 1U);
  EXPECT_EQ(plant.plantings[0].places[0].instance, 1U) << "numbers count the requests";
}

TEST(GrowPlantings, TheFirstFaultIsToldAtTheComponentOnAnyNumberOfThreads) {
  for (const unsigned threads : {1U, 3U}) {
    const ThreadLimit limit(threads);
    const auto errors = errors_of([] {
      grow(garden(), [](OrganSink& organs) {
        for (const double nodes : {3.0, -1.0, 4.0, -2.0}) request(organs, 0, nodes);
      });
    });
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].path, "components.planter");
    EXPECT_THAT(errors[0].message, HasSubstr("growing 'nursery.json' with nodes = -1, seed 1: "));
    EXPECT_THAT(errors[0].message, HasSubstr("-1 nodes"));
  }
}

TEST(GrowPlantings, MoreThanAThousandDifferentPlantsAreAnError) {
  const auto plants = [](int count) {
    return errors_of([&] {
      grow(garden(), [&](OrganSink& organs) {
        for (int k = 0; k < count; ++k) request(organs, 0, 1, static_cast<std::uint64_t>(k));
      });
    });
  };
  EXPECT_TRUE(plants(1000).empty());
  const auto errors = plants(1001);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].message, "there are more than 1000 different plants of other documents");
  EXPECT_EQ(grown, 0) << "before one is grown";
}

TEST(GrowPlantings, TheirNodesAreLimited) {
  auto builder = garden();
  builder.node_limit(10);
  const auto errors = errors_of([&] {
    grow(builder, [](OrganSink& organs) {
      request(organs, 0, 6);
      request(organs, 0, 5);
    });
  });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_THAT(errors[0].text(), HasSubstr("more than 10 nodes"));
  EXPECT_THAT(errors[0].text(), HasSubstr("limits.nodes"));
}

TEST(GrowPlantings, AreFoundInTheCacheOfTheExpansionBefore) {
  Cache cache;
  const auto two = [](OrganSink& organs) {
    request(organs, 0, 4);
    request(organs, 1, 5);
  };
  const Plant first = grow(garden(), two, &cache);
  EXPECT_EQ(grown, 2);
  const Plant again = grow(garden(), two, &cache);
  EXPECT_EQ(grown, 0);
  EXPECT_EQ(hash_of(again), hash_of(first));
}

}  // namespace meristem::grow_plantings_test
