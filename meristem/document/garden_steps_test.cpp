// SPDX-License-Identifier: Apache-2.0
// Steps of plants that other documents place. Each document is grown once, and its steps are shown from this growth.
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "meristem/plant/plant_variant.h"
#include "tests/support/build_graph.h"
#include "tests/support/temporary_folder.h"

namespace meristem::garden_steps_test {

constexpr const char* kTree = R"j({
  "meristem": 1,
  "components": {"stem": {"type": "colonize", "crown": {"sphere": {"centre": [0, 1, 0], "radius": 0.5}}, "points": 60,
                          "step": 0.06, "influence": 0.8, "kill": 0.16, "iterations": 18}}
})j";

constexpr const char* kGarden = R"j({
  "meristem": 1, "seed": 5,
  "components": {
    "view": {"type": "camera"},
    "row": {"type": "places", "line": {"points": [[0, 0], [8, 0]], "spacing": 4}},
    "tree": {"type": "document", "file": "tree.json", "seed": 3, "frame": {"scale": [2, 2, 2]}},
    "copse": {"type": "document", "file": "copse.json", "seed": 1},
    "herb": {"type": "lsystem", "steps": 4, "grammar": ["axiom: A", "A -> F[+A][-A]"]}
  },
  "links": [["view", "row"], ["row", "tree"], ["view", "copse"], ["view", "herb"]]
})j";

constexpr const char* kCopse = R"j({
  "meristem": 1,
  "components": {"group": {"type": "hydra", "number": 2, "radius": 1},
                 "young": {"type": "document", "file": "tree.json", "set": {"stem.iterations": 9}, "seed": 8}},
  "links": [["group", "young"]]
})j";

class GardenSteps : public testing::Test {
 protected:
  GardenSteps() {
    write("tree.json", kTree);
    write("copse.json", kCopse);
    garden_ = read(kGarden);
  }

  Document read(const std::string& text, const std::vector<ValueOverride>& overrides = {},
                std::optional<std::uint64_t> seed = {}) const {
    return read_document(text, (folder_ / "garden.json").string(), builtin_components(),
                         {.overrides = overrides, .seed = seed});
  }

  /// Hash of the tree's only stem after that many steps, in its own document.
  std::string alone(int iterations, std::uint64_t seed) const {
    Progress progress;
    const Document document = read(kTree, {{"stem.iterations", Value(iterations)}}, seed);
    return skeleton_hash(grow_document(document, progress).plant.stems.at(0).skeleton);
  }

  GrownDocument grown(const GrowthView& view, GrowthCache* cache = nullptr) const {
    Progress progress;
    return grow_document(garden_, progress, {.up_to = GrownPart::plant, .cache = cache, .view = view});
  }

  /// The plant that a component of the garden places.
  static const Plant& placed(const Plant& plant, const std::string& component) {
    for (const Planting& planting : plant.plantings) {
      if (planting.component == component) return *planting.variant->plant;
    }
    throw std::invalid_argument("nothing is placed by " + component);
  }

  /// With all that stands there.
  static std::string hash_of_all(const Plant& plant) { return hash_of(*ExpandedPlant(plant, {}, Progress())); }
  static std::string hash_of_stem(const Plant& plant) { return skeleton_hash(plant.stems.at(0).skeleton); }

 private:
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }

  TemporaryFolder folder_;
  Document garden_;
};

TEST_F(GardenSteps, AStepEqualsThatOfThePlantsOwnDocument) {
  GrowthCache cache;
  for (const int step : {7, 12, 1, 500}) {
    const GrownDocument at = grown({step, {}}, &cache);
    EXPECT_EQ(hash_of_stem(placed(at.plant, "tree")), alone(std::min(step, 18), 3)) << step;
    EXPECT_EQ(hash_of_stem(placed(placed(at.plant, "copse"), "young")), alone(std::min(step, 9), 8)) << step;
    EXPECT_EQ(at.traces.last_step, 18);
    EXPECT_EQ(cache.reuse<PlantVariant>().made == 0, step != 7) << "one growth gives all steps";
  }
  EXPECT_EQ(hash_of_all(grown({18, {}}, &cache).plant), hash_of_all(grown({}).plant));
}

TEST_F(GardenSteps, RecordingChangesNothingAndStepsNeedNoGrowthMore) {
  GrowthCache cache;
  const GrownDocument recorded = grown({{}, TraceRequest::all()}, &cache);
  EXPECT_EQ(hash_of_all(recorded.plant), hash_of_all(grown({}).plant));
  EXPECT_GT(recorded.traces.bytes(), 0U);
  EXPECT_FALSE(grown({}).traces.has_growths()) << "nothing is recorded that nobody asks for";
  const GrownDocument earlier = grown({5, TraceRequest::all()}, &cache);
  EXPECT_EQ(cache.reuse<PlantVariant>().made, 0U);
  EXPECT_EQ(hash_of_stem(placed(earlier.plant, "tree")), alone(5, 3));
}

TEST_F(GardenSteps, TellsTheStepsOfEachComponent) {
  const std::vector<ComponentSteps> all{{"copse", 9}, {"herb", 4}, {"tree", 18}};
  EXPECT_EQ(grown({{}, TraceRequest::all()}).traces.steps, all);
}

TEST_F(GardenSteps, AStepMayBeThatOfOneComponentAlone) {
  GrowthCache cache;
  const GrownDocument only_copse = grown({.step = 4, .of = "copse"}, &cache);
  EXPECT_EQ(only_copse.traces.last_step, 9);
  EXPECT_EQ(hash_of_stem(placed(only_copse.plant, "tree")), alone(18, 3));
  EXPECT_EQ(hash_of_stem(placed(placed(only_copse.plant, "copse"), "young")), alone(4, 8));
  EXPECT_EQ(skeleton_hash(only_copse.plant.stems.at(0).skeleton), skeleton_hash(grown({}).plant.stems.at(0).skeleton));
  const GrownDocument only_herb = grown({.step = 2, .of = "herb"}, &cache);
  EXPECT_EQ(only_herb.traces.last_step, 4);
  EXPECT_EQ(hash_of_stem(placed(only_herb.plant, "tree")), alone(18, 3));
}

TEST_F(GardenSteps, MarksStandAtThePlaces) {
  const GrownDocument at = grown({6, {TracePart::points, TracePart::pulls}});
  const std::vector<GrowthMarks> growths = at.traces.marks_of_growths(6, {TracePart::points}, Progress());
  std::vector<std::string> components;
  for (const GrowthMarks& growth : growths) components.push_back(growth.component);
  EXPECT_EQ(components,
            (std::vector<std::string>{"tree.stem", "tree.stem", "tree.stem", "copse.young.stem", "copse.young.stem"}));
  EXPECT_EQ(growths[2].instance, 2U);
  for (std::size_t k = 0; k < 3; ++k) {
    ASSERT_EQ(growths[k].marks.points.size(), 60U);
    const Vec3 middle(4.0F * static_cast<float>(k), 2, 0);  // twice as large
    for (const TracedPlace& point : growths[k].marks.points) EXPECT_LE(glm::distance(point.position, middle), 1.01F);
  }
  EXPECT_EQ(at.traces.marks(6, {TracePart::points}, Progress()).points.size(), 300U);
  // Plants that the view's step no longer applies to are at their last step.
  GrownDocument other = grown({.step = 6, .request = {TracePart::points}, .of = "herb"});
  for (const TracedPlace& point : other.traces.marks(2, {TracePart::points}, Progress()).points)
    if (point.state == PlaceState::used) return;
  FAIL() << "all trees have grown to their end";
}

TEST_F(GardenSteps, AreTheSameOnAnyNumberOfThreads) {
  const auto hash = [&](int threads) {
    const ThreadLimit limit(threads);
    return hash_of_all(grown({7, {}}).plant);
  };
  const std::string expected = hash(1);
  for (const int threads : {2, 8}) EXPECT_EQ(hash(threads), expected) << threads;
}

}  // namespace meristem::garden_steps_test
