// SPDX-License-Identifier: Apache-2.0
// Documents over time: keys against values put in by hand, cascades, growth as time, and what is refused.
#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/base/hash.h"
#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/graph/batch.h"
#include "meristem/shape/stem/cached_meshes.h"
#include "tests/support/build_graph.h"

namespace meristem::animation_test {

Document read(const std::string& text, double time = 0) {
  return read_document(text, "d.json", builtin_components(), {.time = time});
}

template <class T>
void append(std::vector<std::byte>& bytes, const std::vector<T>& values) {
  const auto more = std::as_bytes(std::span(values));
  bytes.insert(bytes.end(), more.begin(), more.end());
}

std::string hash_of(const GrownDocument& grown) {
  std::vector<std::byte> bytes;
  for (const MeshInstances& instances : grown.meshes.meshes) {
    append(bytes, instances.mesh->positions);
    append(bytes, instances.mesh->normals);
    append(bytes, instances.mesh->triangles);
    append(bytes, instances.frames);
    append(bytes, instances.tints);
  }
  for (const Material& material : grown.meshes.materials) append(bytes, std::vector<Vec3>{material.colour});
  return hash128_hex(bytes);
}

std::string hash_at(const Document& document, double time = 0, GrowthCache* cache = nullptr) {
  Progress progress;
  return hash_of(grow_document(document, progress, {.time = time, .cache = cache}));
}

std::vector<std::string> errors(const std::string& text) {
  std::vector<std::string> all;
  try {
    read(text);
  } catch (const InputError& error) {
    for (const Diagnostic& found : error.diagnostics()) all.push_back(found.text());
  }
  return all;
}

/// A blossom with an animation; `marks` stand for values.
std::string blossom(const std::string& number, const std::string& angle, const std::string& scale,
                    const std::string& colour, const std::string& wide, const std::string& spread,
                    const std::string& animation) {
  return fmt::format(R"j({{"meristem": 1,
  "variables": {{"wide": {{"value": {}, "min": 0, "max": 1}}}},
  "components": {{
    "stem": {{"type": "tree", "length": 0.3, "radius": 0.004, "count": 5}},
    "star": {{"type": "hydra", "number": {}, "angle": {}, "radius": 0.01}},
    "petal": {{"type": "leaf", "length": 0.05, "width": "0.02*(1 + wide)", "colour": "{}",
              "frame": {{"scale": {}}}}}
  }},
  "links": [{{"from": "stem", "to": "star", "kind": "branch", "angle": {}}}, ["star", "petal"]]{}}})j",
                     wide, number, angle, colour, scale, spread, animation);
}

std::string keyed_blossom() {
  return blossom("2", "90", "[1, 1, 1]", "#000000", "0", "40", R"j(,
  "animation": {"length": 10, "keys": {
    "star.number": [[0, 0], [4, 8]],
    "star.angle": [[0, [0, 10]], [10, [80, 100], "smooth"]],
    "petal.frame.scale": [[0, [0.5, 0.5, 0.5]], [8, [1, 2, 1], "smooth"]],
    "petal.colour": [[0, "#204020"], [10, "#ff8000"]],
    "wide": [[2, 0], [6, 1]],
    "links[0].angle": [[0, 10], [10, 60]]
  }})j");
}

TEST(Animation, AtATimeItIsTheDocumentWithTheValuesPutInByHand) {
  const Document document = read(keyed_blossom());
  const struct {
    double time;
    std::string text;
  } by_hand[] = {
      {0, blossom("0", "[0, 10]", "[0.5, 0.5, 0.5]", "#204020", "0", "10", "")},
      {4, blossom("8", "[28.16, 41.68]", "[0.75, 1.25, 0.75]", "#795a13", "0.5", "30", "")},
      {2.5, blossom("5", "[12.5, 24.0625]", R"([0.615966796875, 0.847900390625, 0.615966796875])", "#585018", "0.125",
                    "22.5", "")},
      {10, blossom("8", "[80, 100]", "[1, 2, 1]", "#ff8000", "1", "60", "")},
      {50, blossom("8", "[80, 100]", "[1, 2, 1]", "#ff8000", "1", "60", "")},
  };
  for (const auto& [time, text] : by_hand) {
    EXPECT_EQ(hash_at(document, time), hash_at(read(text), 0)) << "at " << time << " s";
  }
}

/// A leaf with an outline of straight lines, on a stem.
std::string shaped(const std::string& outline, const std::string& animation) {
  return R"j({"meristem": 1, "components": {"stem": {"type": "tree", "length": 0.3},
    "leaf": {"type": "leaf", "length": 0.1, "outline": {"kind": "linear", "curve": )j" +
         outline + R"j(}}}, "links": [["stem", "leaf"]])j" + animation + "}";
}

TEST(Animation, CurvesPassFromKeyToKeyPointByPoint) {
  const auto keys = [](const std::string& begin, const std::string& end) {
    return R"j(, "animation": {"length": 4, "keys": {"leaf.outline": [[0, )j" + begin + "[[0, 0], [0.2, 1], [1, 0]]" +
           end + "], [4, " + begin + "[[0, 0], [0.6, 0.5], [1, 0.2]]" + end + "]]}}";
  };
  for (const std::string& written : {keys("", ""), keys(R"({"kind": "linear", "curve": )", "}")}) {
    const Document document = read(shaped("[[0, 0.1], [0.5, 1], [1, 0.1]]", written));
    EXPECT_EQ(hash_at(document, 1), hash_at(read(shaped("[[0, 0], [0.3, 0.875], [1, 0.05]]", ""))));
    EXPECT_EQ(hash_at(document, 9), hash_at(read(shaped("[[0, 0], [0.6, 0.5], [1, 0.2]]", ""))));
  }
}

TEST(Animation, PointsAndNumbersOfACurveHaveKeys) {
  const std::string keys = R"j(, "animation": {"length": 4, "keys": {
    "leaf.outline.curve[1]": [[0, [0.25, 1]], [4, [0.75, 0.5]]], "leaf.outline.curve[2][1]": [[0, 0], [4, 0.5]]}})j";
  const Document document = read(shaped("[[0, 0.1], [0.5, 1], [1, 0.1]]", keys));
  EXPECT_EQ(hash_at(document, 2), hash_at(read(shaped("[[0, 0.1], [0.5, 0.75], [1, 0.25]]", ""))));
}

TEST(Animation, KeysLeadIntoShortForms) {
  const auto tree = [](const std::string& points, const std::string& name) {
    const std::string keys = R"j(, "animation": {"length": 4, "keys": {")j" + name + R"j(": [[0, 20], [4, 60]]}})j";
    return R"j({"meristem": 1, "components": {"tree": {"type": "colonize", "points": )j" + points +
           R"j(, "crown": {"sphere": {"centre": [0, 1, 0], "radius": 1}}}})j" + (name.empty() ? "" : keys) + "}";
  };
  const std::string by_hand = hash_at(read(tree("40", "")));
  for (const std::string name : {"tree.points", "tree.points.count"}) {
    EXPECT_EQ(hash_at(read(tree("7", name)), 2), by_hand) << name;
    EXPECT_EQ(hash_at(read(tree(R"({"count": 7})", name)), 2), by_hand) << name;
  }
}

TEST(Animation, ControlPointsHaveKeysOnTheClockOfTheirInstance) {
  const auto patch = [](const std::string& corner, const std::string& above, const std::string& keys) {
    return R"j({"meristem": 1, "components": {"pace": {"type": "sequence"}, "two": {"type": "hydra", "number": 2},
      "patch": {"type": "hyperpatch", "degree": [1, 1, 1], "box": [[0, 0, 0], [1, 1, 1]], "points": [[0, 0, 0], [1, 0, 0],
        [0, 0, 1], [1, 0, 1], )j" +
           corner + R"j(, [1, 1, 0], [0, 1, 1], [1, 1, 1]]}, "stem": {"type": "tree", "length": 1}},
      "links": [)j" +
           above + R"j(["two", "patch"], ["patch", "stem"]])j" + keys + "}";
  };
  const std::string by_hand = hash_at(read(patch("[0, 1.5, 0]", "", "")));
  for (const std::string name : {"patch.points[4]", "patch.points[4].at"}) {
    const std::string keys =
        R"j(, "animation": {"length": 4, "keys": {")j" + name + R"j(": [[0, [0, 1, 0]], [4, [0, 2, 0]]]}})j";
    EXPECT_EQ(hash_at(read(patch("[0, 1, 0]", "", keys)), 2), by_hand) << name;
  }
}

TEST(Animation, CountsWithFractionsStandInDocumentsToo) {
  const Document document = read(keyed_blossom());
  EXPECT_EQ(hash_at(document, 1.75), hash_at(read(keyed_blossom(), 1.75), 1.75));
  const std::string keyed = blossom("2", "90", "[1, 1, 1]", "#204020", "0", "40",
                                    R"(, "animation": {"length": 4, "keys": {"star.number": [[0, 0], [4, 8]]}})");
  EXPECT_EQ(hash_at(read(keyed), 1.75), hash_at(read(blossom("3.5", "90", "[1, 1, 1]", "#204020", "0", "40", ""))));
}

TEST(Animation, IsTheSameOnAnyNumberOfThreadsAndWithACache) {
  const Document document = read(keyed_blossom());
  GrowthCache cache;
  for (const double time : {0.0, 1.3, 5.0, 9.1}) {
    const std::string whole = hash_at(document, time);
    EXPECT_EQ(hash_at(document, time, &cache), whole);
    for (const int threads : {1, 3}) {
      const ThreadLimit limit(threads);
      EXPECT_EQ(hash_at(document, time), whole);
    }
  }
}

TEST(Animation, ACacheKnowsThatAClockHasStarted) {
  const Document document = read(R"j({"meristem": 1, "animation": {"length": 4},
    "components": {"own": {"type": "sequence", "delay": 1, "waits": false}, "ball": {"type": "simple"}},
    "links": [["own", "ball"]]})j");
  GrowthCache cache;
  for (const double time : {0.0, 2.0, 0.5}) EXPECT_EQ(hash_at(document, time, &cache), hash_at(document, time));
}

TEST(Animation, ChoicesAndSwitchesJump) {
  const char* const text = R"j({"meristem": 1,
    "components": {"body": {"type": "simple", "shape": "box", "hidden": true}},
    "animation": {"length": 4, "keys": {"body.hidden": [[0, true], [1, false], [3, true]],
                                        "body.shape": [[0, "box"], [2, "cone"]]}}})j";
  const Document document = read(text);
  const auto triangles = [&](double time) {
    Progress progress;
    return grow_document(document, progress, {.time = time}).meshes.triangle_count();
  };
  EXPECT_EQ(triangles(0.5), 0U);
  EXPECT_EQ(triangles(1), 12U);
  EXPECT_GT(triangles(2), 12U);
  EXPECT_EQ(triangles(3), 0U);
}

TEST(Animation, WhatIsAppliedToAValueIsAppliedToItsKeys) {
  const auto text = [](const char* value, const char* keys) {
    return fmt::format(R"j({{"meristem": 1, "components": {{"body": {{"type": "simple", "size": [1, {}, 1]}}}}{}}})j",
                       value, keys);
  };
  const Document document = read(text(R"({"range": [9, 9], "apply": "2*v"})",
                                      R"(, "animation": {"length": 2, "keys": {"body.size[1]": [[0, 1], [2, 3]]}})"));
  EXPECT_EQ(hash_at(document, 1), hash_at(read(text("4", "")), 0));
}

/// The heights at which the boxes of a document stand, which tell their clocks' times.
std::vector<float> heights(const Document& document, double time) {
  Progress progress;
  const GrownDocument grown = grow_document(document, progress, {.time = time, .up_to = GrownPart::plant});
  std::vector<float> all;
  for (const Organ& organ : organs_of(grown.plant, "box")) all.push_back(organ.frame.origin.y);
  return all;
}

TEST(Animation, AnInstanceOfAKeyedCountBeginsItsClockWhenTheCountReachesIt) {
  const Document document = read(R"j({"meristem": 1, "components": {
      "star": {"type": "wreath", "number": 1, "angle": 0},
      "clock": {"type": "sequence", "speed": 2, "delay": 0.5},
      "box": {"type": "simple", "frame": {"translate": [0, 0, 0]}}},
    "links": [["star", "clock"], ["clock", "box"]],
    "animation": {"length": 8, "keys": {"star.number": [[1, 0], [5, 4]],
                                        "box.frame.translate[1]": [[0, 0], [10, 10]]}}})j");
  // The count is i + 1 at 2 + i seconds.
  for (const double time : {1.5, 2.75, 4.0, 7.0}) {
    const std::vector<float> all = heights(document, time);
    ASSERT_EQ(all.size(), static_cast<std::size_t>(std::ceil(std::min(4.0, time - 1))));
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool is_whole = i + 1 < all.size() || time >= 5 || time == std::floor(time);
      const double shown = is_whole ? std::clamp((time - 2 - static_cast<double>(i) - 0.5) * 2, 0.0, 10.0) : 0;
      EXPECT_NEAR(all[i], shown, 1e-5) << "instance " << i << " at " << time;
    }
  }
}

TEST(Animation, OfAKeyedCountOfALinkTheLastChildGrowsOutOfNothing) {
  const auto with = [&](const std::string& count, const std::string& keys) {
    return read(R"j({"meristem": 1, "components": {
        "pole": {"type": "horn", "length": 1}, "box": {"type": "simple"}},
      "links": [{"from": "pole", "to": "box", "kind": "branch", "where": "1", "count": )j" +
                count + "}]" + keys + "}");
  };
  const Document keyed = with("1", R"j(, "animation": {"length": 8, "keys": {"links[0].count": [[0, 1], [8, 5]]}})j");
  for (const double time : {0.0, 1.0, 3.5, 8.0}) {
    EXPECT_EQ(hash_at(keyed, time), hash_at(with(fmt::format("{}", 1 + time / 2), ""))) << time;
    EXPECT_EQ(heights(keyed, time).size(), static_cast<std::size_t>(std::ceil(1 + time / 2)));
  }
  // An expression gives whole numbers, as it always has.
  EXPECT_EQ(hash_at(with("\"2*1.7\"", "")), hash_at(with("3", "")));
}

constexpr const char* kGrowing = R"j({"meristem": 1,
  "components": {
    "tree": {"type": "colonize", "crown": {"profile": [[0.2, 0.5], [1, 1], [0.2, 2]]}, "points": 300,
             "step": 0.05, "influence": 0.5, "kill": 0.15, "frame": {"translate": [0, 0, 0]}},
    "apple": {"type": "organize", "iterations": 7, "length": 0.1, "shedding": {"below": 0.15, "after": 2},
              "frame": {"translate": [5, 0, 0]}},
    "fern": {"type": "lsystem", "grammar": "#steps 5\n#axiom A\nA --> F[&A]/(137)[^A]F A", "length": 0.05,
             "frame": {"translate": [9, 0, 0]}},
    "leaf": {"type": "leaf", "length": 0.05}
  },
  "links": [{"from": "tree", "to": "leaf", "kind": "branch", "density": 20}, {"from": "apple", "to": "leaf", "kind": "branch"},
            {"from": "fern", "to": "leaf", "kind": "leaf"}],
  "animation": {"length": 10, "steps_per_second": 4, "unfold": 0.5}})j";

GrownDocument grown_at(const Document& document, double time, GrowthCache* cache = nullptr,
                       GrownPart up_to = GrownPart::meshes) {
  Progress progress;
  return grow_document(document, progress, {.time = time, .up_to = up_to, .cache = cache});
}

TEST(GrowthAsTime, AFilmCostsOneGrowthAndASurfacePerFrame) {
  const Document document = read(kGrowing);
  GrowthCache cache;
  std::uint64_t grown = 0;
  std::uint64_t clothed = 0;
  constexpr int kFrames = 20;
  for (int k = 1; k <= kFrames; ++k) {
    grown_at(document, 0.3 * k, &cache);
    for (const ReuseCount& count : reuse_of(cache)) {
      if (std::string(count.what) == "grown skeletons") grown += count.count.made;
      if (std::string(count.what) == "clothed stems") clothed += count.count.made;
    }
  }
  EXPECT_EQ(grown, 2U) << "one for each of the plants that compete";
  EXPECT_LE(clothed, 3U * kFrames);
}

TEST(GrowthAsTime, StartsFromNothingAndEndsFullGrown) {
  const Document document = read(kGrowing);
  std::uint64_t last = 0;
  for (const double time : {0.0, 0.5, 1.0, 2.0, 4.0, 9.0}) {
    const std::uint64_t nodes = grown_at(document, time).plant.node_count();
    EXPECT_GE(nodes + nodes / 4, last) << "little is shed at once";
    last = nodes;
  }
  std::string still = kGrowing;
  still.erase(still.find(R"(, "steps_per_second": 4, "unfold": 0.5)"),
              std::string(R"(, "steps_per_second": 4, "unfold": 0.5)").size());
  const GrownDocument end = grown_at(document, 1000);
  const GrownDocument plain = grown_at(read(still), 0);
  ASSERT_EQ(end.plant.stems.size(), plain.plant.stems.size());
  for (std::size_t s = 0; s < end.plant.stems.size(); ++s) {
    EXPECT_EQ(end.plant.stems[s].skeleton.position, plain.plant.stems[s].skeleton.position);
    EXPECT_EQ(end.plant.stems[s].skeleton.radius, plain.plant.stems[s].skeleton.radius);
  }
}

TEST(GrowthAsTime, NothingJumpsBetweenFrames) {
  // A step adds at most ten metamers of a shoot, and ten of a lateral that opens in this step. The top of the plants
  // rises no faster.
  const Document document = read(kGrowing);
  GrowthCache cache;
  constexpr double kFrame = 1.0 / 40;
  constexpr float kFastest = 1.5F;  // metres per step
  std::vector<float> before;
  for (double time = 0.2; time < 2; time += kFrame) {
    const GrownDocument grown = grown_at(document, time, &cache, GrownPart::plant);
    std::vector<float> tops;
    for (const Stem& stem : grown.plant.stems) {
      float top = 0;
      for (const Vec3 position : stem.skeleton.position) top = std::max(top, position.y);
      tops.push_back(top);
    }
    for (std::size_t s = 0; s < std::min(before.size(), tops.size()); ++s) {
      EXPECT_LE(tops[s] - before[s], kFastest * 4 * static_cast<float>(kFrame) + 1e-4F)
          << "stem " << s << " at " << time;
    }
    if (tops.size() == 3) before = tops;
  }
}

TEST(GrowthAsTime, LeavesKeepTheirPlacesAndUnfold) {
  const Document document = read(kGrowing);
  GrowthCache cache;
  const auto leaves = [&](double time) {
    return organs_of(grown_at(document, time, &cache, GrownPart::plant).plant, "leaf");
  };
  constexpr double kFrame = 1.0 / 100;
  const std::vector<Organ> before = leaves(1.5);
  const std::vector<Organ> after = leaves(1.5 + kFrame);
  ASSERT_GT(before.size(), 20U);
  std::size_t stayed = 0;
  for (const Organ& leaf : before) {
    const auto is_it = [&](const Organ& other) {
      return glm::distance(other.frame.origin, leaf.frame.origin) < 0.004F &&
             glm::distance(other.frame.heading(), leaf.frame.heading()) <
                 0.1F * glm::length(leaf.frame.heading()) + 0.06F;
    };
    if (std::ranges::any_of(after, is_it)) ++stayed;
  }
  EXPECT_GE(stayed, before.size() * 95 / 100);
  float smallest = 1;
  for (const Organ& leaf : before) smallest = std::min(smallest, glm::length(leaf.frame.heading()));
  EXPECT_LT(smallest, 0.03F) << "some have just begun to unfold";
}

/// The largest size of each leaf, by its name.
std::map<std::uint64_t, float> sizes_of_leaves(const Plant& plant) {
  std::map<std::uint64_t, float> sizes;
  for (const Organ& organ : plant.organs) sizes[organ.name] = glm::length(organ.frame.axes[1]);
  EXPECT_EQ(sizes.size(), plant.organs.size()) << "each leaf has a name of its own";
  return sizes;
}

TEST(GrowthAsTime, LeavesComeAndGoNoFasterThanTheyUnfold) {
  // Leaves stand on thin wood alone, which does not stay thin.
  const Document document = read(R"j({"meristem": 1, "seed": 4,
    "animation": {"length": 4, "steps_per_second": 5, "unfold": 0.5},
    "components": {
      "tree": {"type": "colonize", "crown": {"ellipsoid": {"centre": [0, 1, 0], "radii": [0.5, 0.7, 0.5]}}, "points": 50,
               "step": 0.1, "influence": 0.7, "kill": 0.2, "tip_radius": 0.004},
      "leaf": {"type": "leaf", "length": 0.1, "width": 0.05, "rows": 1}
    },
    "links": [{"from": "tree", "to": "leaf", "kind": "branch", "density": 12, "where": "radius < 0.008"}]})j");
  constexpr double kFrame = 1.0 / 25;
  Progress progress;
  GrowthCache cache;
  std::map<std::uint64_t, float> before;
  std::size_t gone = 0;
  float largest = 0;
  for (double time = 0.6; time < 4; time += kFrame) {
    const GrownDocument grown =
        grow_document(document, progress, {.time = time, .up_to = GrownPart::plant, .cache = &cache});
    const std::map<std::uint64_t, float> now = sizes_of_leaves(grown.plant);
    // A leaf unfolds with at most 1.5 of its size in `unfold` seconds, and its place comes and goes evenly in them.
    for (const auto& [name, size] : now) largest = std::max(largest, size);
    const auto max = largest * static_cast<float>(kFrame * (1.5 / 0.5 + 1 / 0.5));
    for (const auto& [name, size] : before) {
      const auto found = now.find(name);
      const float left = found == now.end() ? 0 : found->second;
      gone += found == now.end() ? 1 : 0;
      EXPECT_LE(std::abs(size - left), max) << "at " << time << " s";
    }
    for (const auto& [name, size] : now) {
      if (!before.empty() && !before.contains(name)) {
        EXPECT_LE(size, max) << "at " << time << " s";
      }
    }
    before = now;
  }
  EXPECT_GT(gone, 10U) << "the test says something";
}

TEST(GrowthAsTime, IsTheSameOnAnyNumberOfThreadsAndWithACache) {
  const Document document = read(kGrowing);
  GrowthCache cache;
  for (const double time : {0.4, 1.3, 3.0}) {
    const std::string whole = hash_of(grown_at(document, time));
    EXPECT_EQ(hash_of(grown_at(document, time, &cache)), whole);
    const ThreadLimit limit(1);
    EXPECT_EQ(hash_of(grown_at(document, time)), whole);
  }
}

std::string with_keys(const std::string& keys) {
  return R"j({"meristem": 1, "variables": {"age": 3},
    "components": {"clock": {"type": "sequence"}, "body": {"type": "simple", "size": [1, "age", 1]},
                   "bloom": {"type": "tree", "length": 1}, "petal": {"type": "leaf"}},
    "links": [["clock", "petal"], {"from": "bloom", "to": "body", "kind": "branch"}],
    "animation": {"length": 5, "keys": {)j" +
         keys + "}}}";
}

TEST(Animation, TellsWhatIsWrongWithItsKeysAndWhere) {
  const struct {
    const char* keys;
    const char* message;
    const char* hint;
  } cases[] = {
      {R"("bloom.lenght": [[0, 1]])", "has no parameter 'lenght'", "length"},
      {R"("bloon.length": [[0, 1]])", "there is no component 'bloon'", "bloom"},
      {R"("agee": [[0, 1]])", "there is no variable 'agee'", "age"},
      {R"("links[0].angle": [[0, 1]])", "a link that is a pair", ""},
      {R"("links[1].angel": [[0, 1]])", "has no parameter 'angel'", "angle"},
      {R"("petal.outline[0]": [[0, 1]])", "has nothing of the name '[0]'", "outline.curve[0][1]"},
      {R"("bloom.taper": [[0, [[0, 1], [1, 1]]], [1, [[0, 1]]]])", "other points than the first key", "as many points"},
      {R"("bloom.taper": [[0, {"curve": [[0, 1]]}], [1, {"curve": [[0, 1]], "kind": "linear"}]])",
       "another kind than the first key", "one kind"},
      {R"("bloom.taper": [[0, "round"]])", "round", ""},
      {R"("petal.outline": [[0, [[0, 1], [1, 1]]]])", "below a sequence", ""},
      {R"("seed.x": [[0, 1]])", "'seed' cannot have keys", ""},
      {R"("bloom.surface": [[0, 1]])", "cannot have keys", ""},
      {R"("clock.delay": [[0, 1]])", "cannot have keys", ""},
      {R"("bloom.length": [])", "an empty list", "a list of keys"},
      {R"("bloom.length": [[0]])", "a key is", "[time, value]"},
      {R"("bloom.length": [[0, 1], [0, 2]])", "two keys at 0 s", "rising"},
      {R"("bloom.length": [[2, 1], [1, 2]])", "follows one at 2 s", "rising"},
      {R"("bloom.length": [["a", 1]])", "the time of a key", "seconds"},
      {R"("bloom.length": [[0, 1], [1, 2, "smoth"]])", "is not a way", "smooth"},
      {R"("bloom.length": [[0, -1]])", "-1", ""},
      {R"("bloom.length": [[0, 1], [9, 2]])", "after the animation's end", "5 s"},
      {R"("body.hidden": [[0, true, "linear"]])", "has no values between", "step"},
      {R"("body.size": [[0, 1]])", "cannot be", "three numbers"},
      {R"("petal.colour": [[0, "#ff0000"]])", "below a sequence", "instance to instance"},
      {R"("links[1]": [[0, 1]])", "a path leads to a single parameter", ""},
      {R"("components": [[0, 1]])", "'components' cannot have keys", ""},
      {R"("components.bloom": [[0, 1]])", "cannot have keys", ""},
      {R"("variables": [[0, 1]])", "cannot have keys", ""},
      {R"("variables.age.min": [[0, 1]])", "a variable has keys as a whole", ""},
      {R"("bloom.": [[0, 1]])", "is not a path", ""},
  };
  for (const auto& [keys, message, hint] : cases) {
    const std::vector<std::string> found = errors(with_keys(keys));
    ASSERT_EQ(found.size(), 1U) << keys << (found.empty() ? "" : found[0]);
    EXPECT_NE(found[0].find(message), std::string::npos) << keys << ": " << found[0];
    EXPECT_NE(found[0].find(hint), std::string::npos) << keys << ": " << found[0];
    EXPECT_NE(found[0].find("d.json:5"), std::string::npos) << keys << ": " << found[0];
  }
}

TEST(Animation, KeysBelowASequenceMayComeAfterTheEnd) {
  EXPECT_TRUE(errors(with_keys(R"("petal.length": [[0, 1], [9, 2]])")).empty());
}

TEST(Animation, KeysStandInItAlone) {
  const std::vector<std::string> found =
      errors(R"j({"meristem": 1, "components": {"petal": {"type": "leaf", "length": {"keys": [[0, 1]]}}}})j");
  ASSERT_FALSE(found.empty());
  EXPECT_NE(found[0].find("animation"), std::string::npos) << found[0];
}

}  // namespace meristem::animation_test
