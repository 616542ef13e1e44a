// SPDX-License-Identifier: Apache-2.0
// Documents at a step of their growth: the bytes of one with no more iterations, from one growth.
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "meristem/graph/batch.h"
#include "meristem/plant/operation_record.h"
#include "tests/support/build_graph.h"

namespace meristem::growth_steps_test {

constexpr const char* kColonizing = R"j({
  "meristem": 1, "seed": 4,
  "scene": {"sun": {"azimuth": 180, "altitude": 50}, "obstacles": [{"box": [[0.3, 0, -1], [2, 1.2, 1]]}]},
  "components": {
    "tree": {"type": "colonize", "crown": {"ellipsoid": {"centre": [0, 1.2, 0], "radii": [0.7, 0.8, 0.7]}},
             "points": 120, "step": 0.06, "influence": 0.8, "kill": 0.16, "iterations": 18,
             "light": {"drift": 0.05}, "finish": {"decimate": 2, "relax": true, "subdivide": 1}},
    "leaf": {"type": "leaf", "length": 0.06, "width": 0.03},
    "dots": {"type": "cloud", "of": "tree", "after_growth": true, "used_colour": "#aaaaaa"}
  },
  "links": [{"from": "tree", "to": "leaf", "kind": "branch", "density": 20}]
})j";

constexpr const char* kOrganizing = R"j({
  "meristem": 1, "seed": 2,
  "components": {
    "tree": {"type": "organize", "iterations": 18, "length": 0.1, "shedding": {"below": 0.3, "after": 2}, "sag": {},
             "operations": [{"do": "cut", "from": 6, "every": 4, "shoots": "leader", "above": 6}]},
    "leaf": {"type": "leaf", "length": 0.06, "width": 0.03}
  },
  "links": [["tree", "leaf"]]
})j";

constexpr const char* kTrained = R"j({
  "meristem": 1, "seed": 3,
  "components": {
    "tree": {"type": "organize", "iterations": 18, "length": 0.1, "sag": {}, "resource": {"alpha": 2.3},
             "training": {"form": "espalier"},
             "operations": [
               {"do": "cut", "from": 5, "every": 3, "season": "summer", "shoots": "rank >= 2 && length > 0.15", "above": 1},
               {"do": "bend", "from": 4, "every": 5, "shoots": "rank == 1 && age < 4", "metamers": 3, "inclination": -10,
                "iterations": 3},
               {"do": "tie", "from": 6, "every": 4, "shoots": "rank == 1 && height > 0.5", "anchor": "ground", "length": 0.3,
                "iterations": 2}]},
    "leaf": {"type": "leaf", "length": 0.06, "width": 0.03}
  },
  "links": [["tree", "leaf"]]
})j";

constexpr const char* kMarkers = R"j({
  "meristem": 1, "seed": 2,
  "components": {"tree": {"type": "organize", "iterations": 7, "length": 0.1, "light": {"model": "markers"}}}
})j";

Document read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  std::vector<ValueOverride> parsed;
  for (const std::string& each : overrides) parsed.push_back(parse_override(each));
  return read_document(text, "test.json", builtin_components(), {.overrides = parsed});
}

GrownDocument grown(const Document& document, const GrowthView& view, GrowthCache* cache = nullptr) {
  Progress progress;
  return grow_document(document, progress, {.up_to = GrownPart::meshes, .cache = cache, .view = view});
}

/// Hash of skeletons, operations and organs.
std::string hash_of(const GrownDocument& grown) {
  std::string text;
  for (const Stem& stem : grown.plant.stems) {
    text += skeleton_hash(stem.skeleton);
    for (const OperationRecord& record : stem.skeleton.operations) text += record.operation + record.shoot;
  }
  for (const MeshInstances& instances : grown.meshes.meshes) {
    text += instances.component + std::to_string(instances.mesh->triangle_count());
    for (const Frame& frame : instances.frames) {
      for (const float number : {frame.origin.x, frame.origin.y, frame.origin.z, frame.axes[1].x, frame.axes[0].y}) {
        text += std::to_string(number) + ",";
      }
    }
  }
  return text;
}

TEST(GrowthSteps, AStepEqualsAGrowthWithNoMoreIterations) {
  for (const char* text : {kColonizing, kOrganizing, kTrained}) {
    const Document whole = read(text);
    GrowthCache cache;
    for (const int step : {12, 4, 17}) {
      const Document less = read(text, {"tree.iterations=" + std::to_string(step)});
      EXPECT_EQ(hash_of(grown(whole, {step, {}}, &cache)), hash_of(grown(less, {}))) << step;
      EXPECT_EQ(cache.reuse<GrownBatch>().made == 0, step != 12) << "one growth gives all steps";
    }
    EXPECT_EQ(hash_of(grown(whole, {18, {}}, &cache)), hash_of(grown(whole, {})));
    EXPECT_EQ(hash_of(grown(whole, {500, {}}, &cache)), hash_of(grown(whole, {}))) << "the last step";
  }
}

TEST(GrowthSteps, RecordingChangesNothing) {
  const GrowthView all{{}, TraceRequest::all()};
  for (const char* text : {kColonizing, kOrganizing, kTrained, kMarkers}) {
    const Document document = read(text);
    const GrownDocument plain = grown(document, {});
    const GrownDocument recorded = grown(document, all);
    EXPECT_EQ(hash_of(plain), hash_of(recorded));
    EXPECT_GT(recorded.traces.bytes(), 0U);
  }
  EXPECT_EQ(grown(read(kOrganizing), {}).traces.bytes(), 0U) << "nothing is recorded that nobody asks for";
}

TEST(GrowthSteps, LsystemsShowTheStepsOfTheirDerivation) {
  const std::string text = R"j({
    "meristem": 1, "seed": 3,
    "components": {"plant": {"type": "lsystem", "steps": 4, "grammar": ["axiom: A", "A -> F[+A][-A]"]}}
  })j";
  const GrownDocument at_two = grown(read(text), {2, {}});
  EXPECT_EQ(at_two.traces.last_step, 4);
  EXPECT_EQ(hash_of(at_two), hash_of(grown(read(text, {"plant.steps=2"}), {})));
}

TEST(GrowthSteps, AStepOfATimedGrammarIsAUnitOfItsTime) {
  const std::string text = R"j({
    "meristem": 1, "seed": 3, "animation": {"length": 2, "steps_per_second": 2},
    "components": {"plant": {"type": "lsystem", "time": 4.5,
      "grammar": ["A", "#rules", "A @ 1 -> FA"]}}
  })j";
  const GrownDocument at_two = grown(read(text), {2, {}});
  EXPECT_EQ(at_two.traces.last_step, 5) << "the last one is not whole";
  EXPECT_EQ(hash_of(at_two), hash_of(grown(read(text, {"plant.time=2"}), {5, {}})));
  EXPECT_NE(hash_of(at_two), hash_of(grown(read(text), {4, {}})));
}

TEST(GrowthSteps, PointsOfAStepEqualThoseOfAGrowthWithNoMoreIterations) {
  const GrowthView points{{}, {TracePart::points, TracePart::pulls}};
  const GrownDocument whole = grown(read(kColonizing), points);
  for (const int step : {3, 12}) {
    const GrownDocument less = grown(read(kColonizing, {"tree.iterations=" + std::to_string(step)}), points);
    EXPECT_EQ(whole.traces.marks(step, {TracePart::points}, Progress()).points,
              less.traces.marks(step, {TracePart::points}, Progress()).points);
    EXPECT_EQ(whole.traces.marks(step, {TracePart::pulls}, Progress()).pulls,
              less.traces.marks(step, {TracePart::pulls}, Progress()).pulls);
  }
  EXPECT_NE(whole.traces.marks(3, {TracePart::points}, Progress()).points,
            whole.traces.marks(12, {TracePart::points}, Progress()).points);
}

TEST(GrowthSteps, PointsAreUsedUpNearNodesAndNeverComeBack) {
  const GrownDocument whole = grown(read(kColonizing), {{}, {TracePart::points}});
  const std::vector<TracedPlace> last = whole.traces.marks(18, {TracePart::points}, Progress()).points;
  ASSERT_EQ(last.size(), 120U);
  std::size_t used = 0, removed = 0;
  for (std::size_t k = 0; k < last.size(); ++k) {
    removed += last[k].state == PlaceState::removed ? 1 : 0;
    if (last[k].state != PlaceState::used) continue;
    ++used;
    const TracedPlace before = whole.traces.marks(last[k].used_in - 1, {TracePart::points}, Progress()).points[k];
    EXPECT_EQ(before.state, PlaceState::free);
    EXPECT_EQ(whole.traces.marks(last[k].used_in, {TracePart::points}, Progress()).points[k], last[k]);
  }
  EXPECT_GT(used, 20U);
  EXPECT_GT(removed, 3U) << "those in the box";
}

TEST(GrowthSteps, TracesAreTheSameOnAnyNumberOfThreads) {
  const GrowthView all{{}, TraceRequest::all()};
  for (const char* text : {kColonizing, kOrganizing, kMarkers}) {
    const Document document = read(text);
    const GrownDocument many = grown(document, all);
    const ThreadLimit one(1);
    const GrownDocument single = grown(document, all);
    for (const int step : {2, 5, 7}) {
      const StepMarks a = many.traces.marks(step, all.request, Progress());
      const StepMarks b = single.traces.marks(step, all.request, Progress());
      EXPECT_EQ(a.points, b.points);
      EXPECT_EQ(a.pulls, b.pulls);
      EXPECT_EQ(a.ways, b.ways);
      EXPECT_EQ(a.room_ways, b.room_ways);
      EXPECT_EQ(a.markers, b.markers);
      EXPECT_EQ(a.losses, b.losses);
    }
  }
}

TEST(GrowthSteps, LossesSayWhyAndWhat) {
  const GrownDocument whole = grown(read(kOrganizing), {{}, {TracePart::losses}});
  std::size_t cut = 0, shed = 0;
  for (int step = 0; step <= 18; ++step) {
    for (const TracedLoss& loss : whole.traces.marks(step, {TracePart::losses}, Progress()).losses) {
      EXPECT_EQ(loss.step, step);
      EXPECT_FALSE(loss.segments.empty());
      EXPECT_GT(loss.length, 0);
      cut += loss.why == LossReason{LossCause::cut, "components.tree.operations[0]"} ? 1 : 0;
      shed += loss.why == LossReason{LossCause::shed, "components.tree.shedding"} ? 1 : 0;
    }
  }
  EXPECT_GT(cut, 0U);
  EXPECT_GT(shed, 0U);
}

TEST(GrowthSteps, MarkersAreTakenByShootsAndFreeBeyondThem) {
  const GrownDocument whole = grown(read(kMarkers), {{}, {TracePart::steps, TracePart::markers}});
  const auto taken = [&](int step) {
    std::size_t count = 0;
    for (const TracedPlace& marker : whole.traces.marks(step, {TracePart::markers}, Progress()).markers)
      count += marker.state == PlaceState::used ? 1 : 0;
    return count;
  };
  EXPECT_EQ(taken(0), 0U);
  EXPECT_GT(taken(3), 0U);
  EXPECT_GT(taken(7), taken(3));
}

TEST(GrowthSteps, MarkersOfManyTreesAreThoseOfEach) {
  const std::string text = R"j({
    "meristem": 1, "seed": 2,
    "components": {"tree": {"type": "organize", "iterations": 5, "length": 0.1, "light": {"model": "markers"},
                            "roots": [[0, 0, 0], [5, 0, 0], [5, 0, 5]]}}
  })j";
  const GrownDocument whole = grown(read(text), {{}, {TracePart::steps, TracePart::markers}});
  std::array<std::size_t, 3> taken{};
  for (const TracedPlace& marker : whole.traces.marks(5, {TracePart::markers}, Progress()).markers) {
    const std::size_t tree = marker.position.x < 2.5F ? 0 : (marker.position.z < 2.5F ? 1 : 2);
    taken[tree] += marker.state == PlaceState::used ? 1 : 0;
  }
  for (const std::size_t count : taken) EXPECT_GT(count, 0U);
}

TEST(GrowthSteps, TooManyMarkersAreAFaultOfTheirSpacing) {
  Document document = read(kMarkers);
  document.graph.limits.points = 500;
  const GrownDocument whole = grown(document, {{}, {TracePart::steps, TracePart::markers}});
  try {
    whole.traces.marks(7, {TracePart::markers}, Progress());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics()[0].path, "components.tree.light.spacing");
  }
}

TEST(GrowthSteps, MarksCanBeCancelled) {
  Progress progress;
  progress.cancel();
  const GrownDocument organized = grown(read(kMarkers), {{}, {TracePart::steps, TracePart::markers}});
  EXPECT_THROW(organized.traces.marks(7, {TracePart::markers}, progress), Cancelled);
  const GrownDocument colonized = grown(read(kColonizing), {{}, {TracePart::points, TracePart::pulls}});
  EXPECT_THROW(colonized.traces.marks(7, {TracePart::points}, progress), Cancelled);
}

TEST(GrowthSteps, ACloudBesideATreeShowsWhatGrowthHasLeft) {
  const auto dots = [](const GrownDocument& grown) {
    std::size_t count = 0;
    for (const Organ& organ : grown.plant.organs) {
      count += grown.plant.prototypes[organ.prototype].component == "dots" ? 1 : 0;
    }
    return count;
  };
  const Document document = read(kColonizing);
  const GrownDocument whole = grown(document, {{}, {TracePart::points}});
  std::size_t there = 0;
  for (const TracedPlace& point : whole.traces.marks(18, {TracePart::points}, Progress()).points)
    there += point.state != PlaceState::removed ? 1 : 0;
  EXPECT_EQ(dots(whole), there) << "used ones have a colour, removed ones have none";
  const Document apart = read(kColonizing, {"dots.frame={\"translate\":[3,0,0]}"});
  EXPECT_EQ(dots(grown(apart, {})), there);
}

TEST(GrowthSteps, PointsOfACloudsOwnMeanNothingBesideTheGrowthOfATree) {
  const std::string text = R"j({
    "meristem": 1,
    "components": {
      "tree": {"type": "colonize", "crown": {"ellipsoid": {"centre": [0, 1, 0], "radii": [0.5, 0.5, 0.5]}}, "points": 20},
      "dots": {"type": "cloud", "of": "tree", "after_growth": true, "points": 10}
    }
  })j";
  try {
    read(text);
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.diagnostics().size(), 1U);
    EXPECT_EQ(error.diagnostics()[0].path, "components.dots.points");
    EXPECT_EQ(error.diagnostics()[0].message, "'points' has no meaning beside the growth of 'tree'");
  }
}

TEST(GrowthSteps, ACloudThatDoesNotStandBesideItsTreeIsAFault) {
  const std::string text = R"j({
    "meristem": 1,
    "components": {
      "view": {"type": "camera"},
      "bed": {"type": "world"},
      "tree": {"type": "colonize", "crown": {"ellipsoid": {"centre": [0, 1, 0], "radii": [0.5, 0.5, 0.5]}}, "points": 20},
      "dots": {"type": "cloud", "of": "tree", "after_growth": true}
    },
    "links": [["view", "bed"], ["bed", "tree"], ["view", "dots"]]
  })j";
  try {
    grown(read(text), {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics()[0].path, "components.dots.after_growth");
  }
}

}  // namespace meristem::growth_steps_test
