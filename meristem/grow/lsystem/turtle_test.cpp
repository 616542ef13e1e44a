// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/lsystem/turtle.h"

#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "meristem/base/math.h"
#include "meristem/grow/lsystem/derive.h"
#include "meristem/grow/lsystem/grammar_reader.h"
#include "tests/support/check_skeleton.h"
#include "tests/support/test_data.h"

namespace meristem::turtle_test {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr float kNear = 1e-5F;

/// Draws the axiom without rules.
WordDrawing drawn(const std::string& word, const TurtleParameters& parameters = {.angle = 90, .length = 1},
                  const Frame& start = {}) {
  const Grammar grammar = read_grammar("#axiom\n" + word + "\n#rules\n");
  Progress progress;
  const Word derived = derive(grammar, 0, RandomKey(1), SizeLimits(), progress);
  return draw(derived, grammar.alphabet, parameters, start, SizeLimits(), "components.plant", progress);
}

Vec3 tip_of(const std::string& word, const TurtleParameters& parameters = {.angle = 90, .length = 1}) {
  return drawn(word, parameters).skeleton.position.back();
}

void expect_near(Vec3 found, Vec3 expected, float tolerance = kNear) {
  EXPECT_LT(glm::length(found - expected), tolerance) << found.x << " " << found.y << " " << found.z << " instead of "
                                                      << expected.x << " " << expected.y << " " << expected.z;
}

std::string error_of(const std::string& word, const SizeLimits& limits = {}) {
  const Grammar grammar = read_grammar("#axiom\n" + word + "\n#rules\n");
  Progress progress;
  const Word derived = derive(grammar, 0, RandomKey(1), SizeLimits(), progress);
  try {
    draw(derived, grammar.alphabet, {}, {}, limits, "components.plant", progress);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Turtle, BeginsUpwardWithItsLeftToTheWest) {
  expect_near(tip_of("F"), {0, 1, 0});
  expect_near(tip_of("+F"), {-1, 0, 0});
  expect_near(tip_of("-F"), {1, 0, 0});
  expect_near(tip_of("&F"), {0, 0, -1});
  expect_near(tip_of("^F"), {0, 0, 1});
  expect_near(tip_of("|F"), {0, -1, 0});
}

TEST(Turtle, KnowsWhichModuleDrewWhat) {
  const WordDrawing drawing = drawn("F[+F]f F{.+f.+f.}~A");
  // Nodes: the root and the tip of the first F, the tip of the second, and both nodes of the F after the gap.
  EXPECT_THAT(drawing.module_of_node, ElementsAre(0, 0, 3, 6, 6));
  ASSERT_EQ(drawing.polygons.size(), 1U);
  EXPECT_EQ(drawing.polygons[0].module, 7U);
  ASSERT_EQ(drawing.places.size(), 1U);
  EXPECT_EQ(drawing.places[0].module, 17U);
}

TEST(Turtle, RollingLeftTheLeftSideSinks) {
  expect_near(tip_of("\\+F"), {0, 0, -1});
  expect_near(tip_of("/+F"), {0, 0, 1});
  expect_near(tip_of("\\/+F"), {-1, 0, 0});
}

TEST(Turtle, OppositeTurnsCancelToTheLastDigits) {
  for (const char* pair : {"+-", "-+", "&^", "^&", "\\/", "/\\", "||"}) {
    std::string word = "+(13)&(71)/(5)";
    for (int k = 0; k < 1000; ++k) word += pair;
    expect_near(tip_of(word + "F"), tip_of("+(13)&(71)/(5)F"), 1e-6F);
  }
}

TEST(Turtle, ParametersStandInForTheDefaults) {
  expect_near(tip_of("F(3)"), {0, 3, 0});
  expect_near(tip_of("+(45)F(2)"), Vec3(-1, 1, 0) * std::sqrt(2.0F));
  expect_near(tip_of("|(30)F"), {-0.5F, std::sqrt(0.75F), 0});
  expect_near(tip_of("F(-2)"), {0, -2, 0});
}

TEST(Turtle, SegmentsWithoutLengthMakeNoNode) {
  EXPECT_EQ(drawn("F(0)F").skeleton.node_count(), 2U);
  EXPECT_EQ(drawn("F(0)").skeleton.node_count(), 0U);
}

TEST(Turtle, MovesLeaveAGap) {
  const Skeleton skeleton = drawn("FfF").skeleton;
  EXPECT_TRUE(check_skeleton(skeleton));
  EXPECT_THAT(skeleton.parent, ElementsAre(kNoNode, 0U, kNoNode, 2U));
  expect_near(skeleton.position[2], {0, 2, 0});
  EXPECT_THAT(skeleton.axis, ElementsAre(0U, 0U, 1U, 1U));
}

TEST(Turtle, BranchesFromOnePlaceShareItsNode) {
  const Skeleton trunkless = drawn("[+F][-F]F").skeleton;
  EXPECT_THAT(trunkless.parent, ElementsAre(kNoNode, 0U, 0U, 0U));
  const Skeleton after_gap = drawn("Ff[+F][-F]").skeleton;
  EXPECT_THAT(after_gap.parent, ElementsAre(kNoNode, 0U, kNoNode, 2U, 2U));
}

TEST(Turtle, TheApicalChainIsOneAxis) {
  const Skeleton skeleton = drawn("F[+F[+F]F]F[-F]F").skeleton;
  EXPECT_TRUE(check_skeleton(skeleton));
  EXPECT_THAT(skeleton.axis, ElementsAre(0U, 0U, 1U, 2U, 1U, 0U, 3U, 0U));
  EXPECT_THAT(skeleton.order, ElementsAre(0, 0, 1, 2, 1, 0, 1, 0));
}

TEST(Turtle, WhereAnAxisEndsInBranchesTheWidestThenTheStraightestGoesOn) {
  EXPECT_THAT(drawn("F[+F][F][-F]").skeleton.order, ElementsAre(0, 0, 1, 0, 1));
  EXPECT_THAT(drawn("!(1)F[!(0.3)F][!(0.5)+F]").skeleton.order, ElementsAre(0, 0, 1, 0));
  EXPECT_THAT(drawn("F[+F][-F]").skeleton.order, ElementsAre(0, 0, 0, 1));
}

TEST(Turtle, WidthsAreRadii) {
  const WordDrawing drawing = drawn("!(0.5)F!F!F#F#(2)F", {.length = 1, .thinner = 0.5});
  EXPECT_THAT(drawing.skeleton.radius, ElementsAre(0.5F, 0.5F, 0.25F, 0.125F, 0.25F, 2.0F));
}

TEST(Turtle, WithoutWidthsInTheWordEachLevelDecays) {
  const WordDrawing drawing = drawn("FF[FF]F", {.length = 1, .width = 1, .trunk_decay = 0.5, .branch_decay = 0.25});
  EXPECT_THAT(drawing.skeleton.radius, ElementsAre(1.0F, 0.5F, 0.25F, 0.0625F, 0.015625F, 0.125F));
}

TEST(Turtle, LevelsItsLeft) {
  // After a roll and a pitch, the left vector is inclined. $ makes it horizontal and keeps the heading.
  const Vec3 before = tip_of("&(50)/(33)F");
  expect_near(tip_of("&(50)/(33)$F"), before);
  const Vec3 left = tip_of("&(50)/(33)$+F");
  EXPECT_NEAR(left.y, 0, kNear);
  EXPECT_GT(tip_of("&(50)/(33)$^F").y, 0) << "up is the upper side";
}

TEST(Turtle, AVerticalHeadingIsLevelAsItIs) {
  expect_near(tip_of("/(33)$+F"), tip_of("/(33)+F"));
  expect_near(tip_of("|/(33)$+F"), tip_of("|/(33)+F"));
}

TEST(Turtle, TropismTurnsByTheTorqueAfterEachSegment) {
  // At right angles to the pull, the turn is e radians: 12.605 degrees for 0.22.
  const TurtleParameters pulled{.angle = 90, .length = 1, .elasticity = 0.22};
  const WordDrawing drawing = drawn("+FF", pulled);
  expect_near(drawing.skeleton.position[1], {-1, 0, 0});
  const Vec3 second = drawing.skeleton.position[2] - drawing.skeleton.position[1];
  EXPECT_NEAR(math::asin(-second.y) * 180 / 3.14159265358979, 12.605, 0.001);
  // Along the pull there is no turn; at an angle, the turn is proportional to the sine.
  expect_near(tip_of("FF", pulled), {0, 2, 0});
  const Skeleton slanted = drawn("+(30)FF", pulled).skeleton;
  const Vec3 before = slanted.position[1];
  const Vec3 after = slanted.position[2] - before;
  EXPECT_NEAR(math::acos(glm::dot(before, after)), 0.22 * 0.5, 1e-5);
}

TEST(Turtle, DownIsWhereTheSceneSaysForTropismAndLevels) {
  const Directions eastward(kUp, {1, 0, 0});
  const WordDrawing bent = drawn("FF", {.length = 1, .directions = eastward, .elasticity = 0.5});
  expect_near(bent.skeleton.position[2], {0.479426F, 1.877583F, 0}, 1e-5F);
  expect_near(drawn("$^(90)F", {.length = 1, .directions = eastward}).skeleton.position.back(), {-1, 0, 0});
}

TEST(Turtle, TropismIsTheWorldsWhereverTheTurtleBegins) {
  const Frame east{rotation({0, 0, 1}, -3.14159265358979 / 2), {0, 0, 0}};
  const WordDrawing drawing = drawn("FF", {.length = 1, .elasticity = 0.5}, east);
  EXPECT_LT(drawing.skeleton.position[2].y, -0.4F);
}

TEST(Turtle, GrowsInItsFrame) {
  Frame start{2.0F * rotation({0, 0, 1}, -3.14159265358979 / 2), {5, 1, 0}};
  const WordDrawing drawing = drawn("!(0.1)F+F", {.angle = 90, .length = 1}, start);
  expect_near(drawing.skeleton.position[0], {5, 1, 0});
  expect_near(drawing.skeleton.position[1], {7, 1, 0});
  expect_near(drawing.skeleton.position[2], {7, 3, 0});
  EXPECT_FLOAT_EQ(drawing.skeleton.radius[1], 0.2F);
}

TEST(PolarTurtle, RaisesAHeadingFromLevel) {
  const TurtleParameters polar{.reading = TurtleParameters::Reading::polar, .length = 1};
  expect_near(tip_of("F", polar), {1, 0, 0});
  expect_near(tip_of("^^^^F", polar), {0, 1, 0});
  expect_near(tip_of("^^^^&&&&F", polar), {1, 0, 0});
  expect_near(tip_of("++++F", polar), {0, 0, -1});
  // The azimuth applies at any elevation: turning an upright heading changes the direction in which it later leans.
  expect_near(tip_of("^^^^----&&&&F", polar), {0, 0, 1});
  expect_near(tip_of("^^^^+(90)&(45)F", polar), Vec3(0, 1, -1) * std::sqrt(0.5F));
  expect_near(tip_of("^(90)\\(45)$/F", polar), {0, 1, 0});
}

TEST(PolarTurtle, StepsOfBothAnglesMayDiffer) {
  const TurtleParameters polar{.reading = TurtleParameters::Reading::polar, .angle = 30, .azimuth = 90, .length = 1};
  expect_near(tip_of("^^^F", polar), {0, 1, 0});
  expect_near(tip_of("+F", polar), {0, 0, -1});
}

TEST(PolarTurtle, TheShootsOfTheDichasiumStandAt45DegreesToBothSides) {
  const Grammar grammar = read_grammar("#axiom\nA\n#rules\nA -> ^^FB\nB -> C+++C---\nC -> [^F&B]\n");
  const TurtleParameters polar{.reading = TurtleParameters::Reading::polar, .angle = 45, .azimuth = 60, .length = 1};
  Progress progress;
  const Word word = derive(grammar, 3, RandomKey(1), SizeLimits(), progress);
  const Skeleton plant = draw(word, grammar.alphabet, polar, {}, SizeLimits(), "", progress).skeleton;
  ASSERT_EQ(plant.node_count(), 4U);
  expect_near(plant.position[1], {0, 1, 0});
  expect_near(plant.position[2], Vec3(0, 1, 0) + Vec3(-1, 1, 0) * std::sqrt(0.5F));
  expect_near(plant.position[3], Vec3(0, 1, 0) + Vec3(1, 1, 0) * std::sqrt(0.5F));
}

TEST(PolarTurtle, ABracketMayKeepTheAngles) {
  TurtleParameters polar{.reading = TurtleParameters::Reading::polar, .angle = 90, .length = 1};
  expect_near(tip_of("[^F]F", polar), {1, 0, 0});
  polar.stack_angles = false;
  expect_near(tip_of("[^F]F", polar), {0, 1, 0});
}

TEST(TurtlePolygon, HasACornerAtEachPointAndMove) {
  const WordDrawing drawing = drawn("F{.f+f+f}");
  ASSERT_EQ(drawing.polygons.size(), 1U);
  EXPECT_EQ(drawing.polygons[0].count, 4U);
  expect_near(drawing.corners[0], {0, 1, 0});
  expect_near(drawing.corners[1], {0, 2, 0});
  expect_near(drawing.corners[3], {-1, 1, 0});
  expect_near(drawing.polygons[0].frame.origin, {0, 1, 0});
  EXPECT_EQ(drawing.skeleton.node_count(), 2U);
}

TEST(TurtlePolygon, SymbolGLeavesNone) {
  const WordDrawing drawing = drawn("{.G.+g.F}");
  ASSERT_EQ(drawing.polygons.size(), 1U);
  EXPECT_EQ(drawing.polygons[0].count, 4U);
  EXPECT_EQ(drawing.skeleton.node_count(), 4U) << "F and G are drawn";
}

TEST(TurtlePolygon, OpensInABranchAndClosesBehindIt) {
  const WordDrawing drawing = drawn("[+{.]f.}");
  ASSERT_EQ(drawing.polygons.size(), 1U) << "the corner at the end counts twice";
  EXPECT_EQ(drawing.polygons[0].count, 3U);
}

TEST(TurtlePolygon, MayLieInAnother) {
  const WordDrawing drawing = drawn("'(2){.f{.f.f.}'.f.}");
  ASSERT_EQ(drawing.polygons.size(), 2U);
  EXPECT_EQ(drawing.polygons[1].colour, 2U);
  EXPECT_EQ(drawing.polygons[1].first, drawing.polygons[0].count);
}

TEST(TurtlePolygon, NeedsItsEnd) {
  EXPECT_THAT(error_of("F{.f.f."), HasSubstr("the word leaves a polygon open; expected a } for each {"));
  EXPECT_THAT(error_of("{" + std::string(2001, '.') + "}"),
              HasSubstr("module 2002 of the word is one corner too many of a polygon; expected at most 2000"));
}

TEST(TurtlePolygon, NeedsItsBegin) {
  EXPECT_THAT(error_of("Ff.}"), HasSubstr("components.plant: module 4 of the word closes a polygon"));
}

TEST(TurtleSite, StandsOnTheStem) {
  const WordDrawing drawing = drawn("!(0.2)F+~K(3)F~K");
  ASSERT_EQ(drawing.places.size(), 2U);
  expect_near(drawing.places[0].frame.origin, {0, 1, 0});
  expect_near(drawing.places[0].frame.heading(), {-3, 0, 0});
  expect_near(drawing.places[1].frame.heading(), {-1, 0, 0});
  EXPECT_FLOAT_EQ(drawing.places[0].radius, 0.2F);
  EXPECT_EQ(drawing.places[0].node, 1U);
  EXPECT_EQ(drawing.places[1].node, 2U);
  EXPECT_EQ(drawn("~K").places[0].node, kNoNode);
  EXPECT_EQ(drawn("F~F(2)").skeleton.node_count(), 2U) << "a name is nothing to draw";
  EXPECT_THAT(error_of("F~"), HasSubstr("module 2 of the word is a ~ without a name"));
}

TEST(Turtle, StopsAtTheLimitOfNodes) {
  SizeLimits limits;
  limits.nodes = 2;
  EXPECT_THAT(error_of("FFF", limits), HasSubstr("limits.nodes"));
}

TEST(Turtle, StopsAtTheLimitOfPolygonsAndPlaces) {
  SizeLimits limits;
  limits.instances = 2;
  EXPECT_THAT(error_of("~A{...}~A", limits), HasSubstr("limits.instances"));
}

TEST(Turtle, StopsAtTheEndOfTheWorld) {
  EXPECT_THAT(error_of("F(1e308)F(1e308)"), HasSubstr("module 1 of the word leads out of the world"));
  EXPECT_THAT(error_of("F(1e9)F(1)"), HasSubstr("module 2 of the word leads out of the world"));
  EXPECT_THAT(error_of("F!(1e39)F"), HasSubstr("module 3 of the word is wider than the world"));
}

/// P. Prusinkiewicz, A. Lindenmayer: The Algorithmic Beauty of Plants, figure 1.25.
TEST(TurtlePolygon, DrawsTheLeavesOfTheBooksBush) {
  const Grammar grammar = read_grammar(
      "#axiom\nA\n#rules\nA -> [&FL!A]/////'[&FL!A]///////'[&FL!A]\nF -> S/////F\nS -> FL\n"
      "L -> ['''^^{-f+f+f-|-f+f+f}]\n");
  Progress progress;
  const Word word = derive(grammar, 7, RandomKey(1), SizeLimits(), progress);
  const WordDrawing drawing = draw(word, grammar.alphabet, {.length = 1}, {}, SizeLimits(), "", progress);
  EXPECT_EQ(drawing.polygons.size(), 1284U);
  EXPECT_EQ(drawing.skeleton.node_count(), 3891U + 1);
  for (const TurtlePolygon& leaf : drawing.polygons) {
    ASSERT_EQ(leaf.count, 6U);
    // A leaf ends where it began and is flat in the plane of the turtle's left vector.
    expect_near(drawing.corners[leaf.first + 5], leaf.frame.origin, 1e-4F);
    const Vec3 across = drawing.corners[leaf.first + 1] - drawing.corners[leaf.first + 4];
    EXPECT_NEAR(glm::dot(across, leaf.frame.upper()), 0, 1e-4);
  }
}

/// Draws the plane figures of a reference and compares segments, ends and bounds. Their drawing letters become F.
/// Returns the number of figures.
int compare_figures(const std::string& path) {
  std::ifstream file(path);
  const nlohmann::json entries = nlohmann::json::parse(file);
  int figures = 0;
  for (const auto& [name, entry] : entries.items()) {
    if (!entry.contains("turtle") || entry["turtle"]["segments"] == 0) continue;
    std::string text = "#axiom\n" + entry["axiom"].get<std::string>() + "\n#rules\n";
    std::string drawing_letters = "F";
    if (entry.contains("draw")) {
      drawing_letters = entry["draw"].get<std::string>();
    }
    if (entry.contains("ignore")) continue;  // context-sensitive: its rules have another notation
    for (const auto& [letter, successor] : entry["rules"].items()) {
      text += letter + " -> " + successor.get<std::string>() + "\n";
    }
    text += "#interpret\n";
    for (const char letter : drawing_letters) {
      if (letter != 'F') text += std::string(1, letter) + " -> F\n";
    }
    const Grammar grammar = read_grammar(text);
    Progress progress;
    const Word word = derive(grammar, entry["n"].get<int>(), RandomKey(1), SizeLimits(), progress);
    const Word seen = interpreted(grammar, word, RandomKey(1), SizeLimits(), progress);
    const Skeleton skeleton = draw(seen, grammar.alphabet, {.angle = entry["delta"].get<double>(), .length = 1}, {},
                                   SizeLimits(), "", progress)
                                  .skeleton;
    EXPECT_TRUE(check_skeleton(skeleton)) << name;
    const nlohmann::json& expected = entry["turtle"];
    EXPECT_EQ(skeleton.node_count() - 1, expected["segments"].get<std::size_t>()) << name;
    Vec3 min(0);
    Vec3 max(0);
    for (const Vec3 position : skeleton.position) {
      min = glm::min(min, position);
      max = glm::max(max, position);
    }
    const auto& box = expected["bbox"];
    EXPECT_NEAR(min.x, box[0].get<double>(), 1e-3) << name;
    EXPECT_NEAR(min.y, box[1].get<double>(), 1e-3) << name;
    EXPECT_NEAR(max.x, box[2].get<double>(), 1e-3) << name;
    EXPECT_NEAR(max.y, box[3].get<double>(), 1e-3) << name;
    // If a bracketed branch continues the stem, the stem is longer than the turtle's unbracketed path.
    const Vec3 end(expected["end"][0].get<float>(), expected["end"][1].get<float>(), 0);
    const auto stem = SkeletonAxes(skeleton);
    const auto ends_at = [&](NodeIndex node) { return glm::length(skeleton.position[node] - end) < 1e-3F; };
    EXPECT_TRUE(std::ranges::any_of(stem.of(0), ends_at)) << name;
    ++figures;
  }
  return figures;
}

TEST(TurtleReference, DrawsTheBooksFigures) {
  for (const std::string& file : data_files({"tests/data/reference/lsystems.json"}, {"reference/lsystems.json"})) {
    SCOPED_TRACE(file);
    EXPECT_GE(compare_figures(file), 8);
  }
}

TEST(Turtle, TheColumnEndMarksWhereBranchesEnd) {
  const auto ends = [](const std::string& word) {
    const Skeleton skeleton = drawn(word).skeleton;
    EXPECT_EQ(skeleton.extra.at("end").size(), skeleton.node_count()) << word;
    return skeleton.extra.at("end");
  };
  EXPECT_THAT(ends("FF"), ElementsAre(0, 0, 0));
  EXPECT_THAT(ends("F[+F]F"), ElementsAre(0, 0, 1, 0));
  EXPECT_THAT(ends("F[+F[-FF]F]"), ElementsAre(0, 0, 0, 0, 1, 1));
  // Branches without length count, too.
  EXPECT_THAT(ends("F[]F"), ElementsAre(0, 1, 0));
  EXPECT_THAT(ends("F[+(10)]F[]"), ElementsAre(0, 1, 1));
  EXPECT_THAT(ends("[]F"), ElementsAre(0, 0));
  // After a gap, nothing has been drawn at the end of the branch.
  EXPECT_THAT(ends("F[+Ff]F"), ElementsAre(0, 0, 0, 0));
  EXPECT_TRUE(drawn("[][+]f[]").skeleton.extra.at("end").empty());
}

}  // namespace meristem::turtle_test
