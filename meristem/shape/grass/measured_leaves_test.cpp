// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/grass/measured_leaves.h"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/grass_leaves.h"

namespace meristem::measured_leaves_test {

using Errors = std::vector<Diagnostic>;

template <class Read>
Errors errors_by(const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.diagnostics();
  }
  return {};
}

std::vector<MeasuredCurve> midribs_in(std::string_view text) {
  Errors warnings;
  return read_midribs(text, {}, warnings);
}

Errors midrib_errors(std::string_view text) {
  return errors_by([&] { midribs_in(text); });
}

Errors midrib_warnings(std::string_view text) {
  Errors warnings;
  read_midribs(text, {}, warnings);
  return warnings;
}

Errors width_warnings(std::string_view text) {
  Errors warnings;
  read_widths(text, {}, warnings);
  return warnings;
}

Errors width_errors(std::string_view text) {
  Errors warnings;
  return errors_by([&] { read_widths(text, {}, warnings); });
}

/// Succeeds if there is exactly one error, at `line` and with `message` in its text.
testing::AssertionResult is_one(const Errors& errors, int line, std::string_view message) {
  if (errors.size() != 1) return testing::AssertionFailure() << errors.size() << " faults";
  const bool holds = errors[0].line == line && errors[0].message.find(message) != std::string::npos;
  return holds ? testing::AssertionSuccess() : testing::AssertionFailure() << errors[0].text();
}

MeasuredCurve curve(std::vector<glm::dvec2> points) { return {.points = std::move(points)}; }

TEST(MeasuredLeaves, MidribsArePartedByRankLindexAndAge) {
  const auto midribs = midribs_in(
      "rank,lindex,age,x,y\n1,1,0.5,0,0\n1,1,0.5,1,2\n1,1,0.5,2,3\n1,1,1,0,0\n1,1,1,3,4\n1,1,1,9,9\n1,2,1,-1,0\n"
      "1,2,1,1,5\n1,2,1,2,5\n");
  ASSERT_EQ(midribs.size(), 3U);
  EXPECT_EQ(midribs[0].rank, 1);
  EXPECT_EQ(midribs[0].age, 0.5);
  EXPECT_EQ(midribs[1].age, 1);
  EXPECT_EQ(midribs[2].lindex, 2);
  EXPECT_EQ(midribs[1].points[1], glm::dvec2(3, 4));
  EXPECT_EQ(midribs[1].lines, (std::vector<int>{5, 6, 7}));
  EXPECT_EQ(midribs[2].points[0], glm::dvec2(-1, 0)) << "a base behind the stem is one";
}

TEST(MeasuredLeaves, ATextWithoutNamesIsOneLeaf) {
  const auto midribs = midribs_in("x;y\n0;0\n1,5;2\n2;2,5\n");
  ASSERT_EQ(midribs.size(), 1U);
  EXPECT_EQ(midribs[0].rank, std::nullopt);
  EXPECT_EQ(midribs[0].points[1], glm::dvec2(1.5, 2));
}

TEST(MeasuredLeaves, WidthsKnowRanksOrClassesOfThem) {
  for (const std::string name : {"rank", "rankclass"}) {
    Errors warnings;
    const auto widths = read_widths(name + ",s,r\n2,0,.5\n2,.5,1\n2,1,0\n3,0,.6\n3,.5,1\n3,1,0\n", {}, warnings);
    ASSERT_EQ(widths.size(), 2U);
    EXPECT_EQ(widths[1].rank, 3);
    EXPECT_TRUE(warnings.empty());
  }
}

TEST(MeasuredLeaves, RejectsRowsOfALeafThatStandApart) {
  EXPECT_TRUE(is_one(midrib_errors("rank,x,y\n1,0,0\n1,1,1\n1,2,2\n2,0,0\n2,1,1\n2,2,2\n1,3,3\n1,4,4\n1,5,5\n"), 8,
                     "rank 1 appears a second time"));
}

TEST(MeasuredLeaves, RejectsARankThatIsNoWholeNumber) {
  EXPECT_TRUE(is_one(midrib_errors("rank,x,y\n1.5,0,0\n0,1,1\n0,2,2\n0,3,3\n"), 2, "1.5 is not a whole number"));
}

TEST(MeasuredLeaves, RejectsMidribsOfTooFewPoints) {
  EXPECT_TRUE(is_one(midrib_errors("rank,x,y\n1,0,0\n1,1,1\n1,2,1\n2,0,0\n2,1,1\n"), 5, "2 points"));
}

TEST(MeasuredLeaves, PointsThatAreRepeatedAreLeftOutWithAWarningThatNamesLeafAndLine) {
  const std::string text = "rank,lindex,x,y\n1,7,0,0\n1,7,1,1\n1,7,1,1\n1,7,1,1\n1,7,2,1\n2,1,0,0\n2,1,1,1\n2,1,2,3\n";
  const Errors warnings = midrib_warnings(text);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0].severity, Severity::warning);
  EXPECT_EQ(warnings[0].line, 4);
  EXPECT_EQ(warnings[1].line, 5);
  EXPECT_EQ(warnings[0].message, "rank 1, lindex 7: the point of the midrib repeats the one before it and is left out");
  const auto midribs = midribs_in(text);
  ASSERT_EQ(midribs.size(), 2U) << "the other leaf is there";
  EXPECT_EQ(midribs[0].points, (std::vector<glm::dvec2>{{0, 0}, {1, 1}, {2, 1}}));
  EXPECT_EQ(midribs[0].lines, (std::vector<int>{2, 3, 6}));
  EXPECT_TRUE(midrib_warnings("x,y\n0,0\n1,1\n2,1\n1,1\n").empty()) << "a midrib may come back";
}

TEST(MeasuredLeaves, PointsNearerThanNumbersTellApartAreRepeated) {
  const std::string_view repeats = "repeats the one before it";
  EXPECT_TRUE(is_one(midrib_warnings("x,y\n0,0\n1,1\n1.0000000001,1\n2,1\n"), 4, repeats));
  EXPECT_TRUE(is_one(midrib_warnings("x,y\n0,0\n1e-300,0\n1,1\n2,1\n"), 3, repeats));
  EXPECT_TRUE(is_one(width_warnings("s,r\n0,1\n0.5,1\n0.5000000001,1\n1,0\n"), 4, repeats));
}

TEST(MeasuredLeaves, RejectsRepeatedPointsWhereTooFewAreLeft) {
  EXPECT_TRUE(is_one(midrib_errors("x,y\n0,0\n1,1\n1,1\n"), 4, "the one in the row before"));
}

TEST(MeasuredLeaves, RejectsNumbersBeyondAnyUnit) {
  EXPECT_TRUE(is_one(midrib_errors("x,y\n0,0\n1,1\n1e200,1\n"), 4, "out of range"));
  EXPECT_TRUE(is_one(width_errors("s,r\n0,1\n1,1\n2,1e200\n"), 4, "out of range"));
}

TEST(MeasuredLeaves, OfWidthsAtAPositionThatIsRepeatedTheFirstHolds) {
  const std::string text = "rank,s,r\n3,0,1\n3,0.5,1\n3,0.5,0.9\n3,1,0\n";
  EXPECT_TRUE(is_one(width_warnings(text), 4, "rank 3: the position s repeats the one before it and is left out"));
  Errors warnings;
  EXPECT_EQ(read_widths(text, {}, warnings)[0].points, (std::vector<glm::dvec2>{{0, 1}, {0.5, 1}, {1, 0}}));
  EXPECT_TRUE(is_one(width_errors("s,r\n0,1\n0.5,1\n0.5,0.9\n"), 4, "s = 0.5 repeats the one in the row before"));
}

TEST(MeasuredLeaves, RejectsPlacesThatAreNotSorted) {
  EXPECT_TRUE(is_one(width_errors("s,r\n0,1\n0.5,1\n0.4,0.9\n1,0\n"), 4, "not sorted: 0.4 after 0.5"));
}

TEST(MeasuredLeaves, RejectsNegativePlacesAndWidths) {
  EXPECT_TRUE(is_one(width_errors("s,r\n-0.5,1\n0.5,1\n1,0\n"), 2, "s = -0.5 is negative"));
  EXPECT_TRUE(is_one(width_errors("s,r\n0,1\n0.5,-1\n1,0\n"), 3, "the width -1 is negative"));
}

TEST(MeasuredLeaves, RejectsProfilesWithoutWidthOrRows) {
  EXPECT_TRUE(is_one(width_errors("s,r\n0,0\n0.5,0\n1,0\n"), 2, "no width"));
  EXPECT_TRUE(is_one(width_errors("s,r\n0,1\n1,0\n"), 2, "2 points"));
}

TEST(MeasuredLeaves, RejectsColumnsThatAreNotThere) {
  const Errors errors = midrib_errors("rank,X,z\n1,0,0\n");
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0].message, "there is no column 'x'");
  EXPECT_EQ(errors[0].line, 1);
  EXPECT_TRUE(is_one(width_errors("s,width\n0,1\n"), 1, "there is no column 'r'"));
}

TEST(MeasuredLeaves, TellsTheFaultsOfAllLeavesAtOnceUpToTheLimit) {
  std::string text = "rank,x,y\n";
  for (int rank = 0; rank < 200; ++rank) {
    for (int row = 0; row < 3; ++row) text += fmt::format("{},1,1\n", rank);
  }
  const Errors errors = midrib_errors(text);
  EXPECT_EQ(errors.size(), SizeLimits{}.diagnostics);
  EXPECT_EQ(errors[2].line, 6);
  text = "rank,x,y\n";
  for (int row = 0; row < 300; ++row) text += fmt::format("0.5,{},1\n", row);
  EXPECT_EQ(midrib_errors(text).size(), SizeLimits{}.diagnostics);
}

TEST(MeasuredLeaves, CurvesWithoutLinesNameTheRow) {
  const Errors errors = errors_by([] { check_midrib(curve({{0, 0}, {1, 1}, {1, 1}})); });
  EXPECT_TRUE(is_one(errors, 0, "row 2: "));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(errors_by([&] { check_midrib(curve({{0, 0}, {1, nan}, {2, 1}})); }).size(), 1U);
  EXPECT_EQ(errors_by([&] { check_widths(curve({{0, 1}, {1, nan}, {2, 1}})); }).size(), 1U);
}

// One blade, listed in three possible ways.
const std::vector<glm::dvec2> kFromBase{{0, 0.6}, {0.25, 1}, {0.5, 0.9}, {1, 0.1}};

TEST(MeasuredLeaves, WidthsFromTheBaseStayAsTheyAre) {
  MeasuredCurve widths = curve(kFromBase);
  EXPECT_FALSE(turn_to_base(widths));
  EXPECT_EQ(widths.points, kFromBase);
}

TEST(MeasuredLeaves, FallingPlacesAreTurnedAbout) {
  MeasuredCurve widths = curve({{1, 0.1}, {0.5, 0.9}, {0.25, 1}, {0, 0.6}});
  widths.lines = {2, 3, 4, 5};
  EXPECT_TRUE(turn_to_base(widths));
  EXPECT_EQ(widths.points, kFromBase);
  EXPECT_EQ(widths.lines, (std::vector<int>{5, 4, 3, 2}));
}

TEST(MeasuredLeaves, PlacesFromTheTipAreTurnedAbout) {
  for (const bool falls : {false, true}) {
    std::vector<glm::dvec2> points{{0, 0.1}, {0.5, 0.9}, {0.75, 1}, {1, 0.6}};
    if (falls) std::reverse(points.begin(), points.end());
    MeasuredCurve widths = curve(points);
    EXPECT_TRUE(turn_to_base(widths));
    EXPECT_EQ(widths.points, kFromBase);
  }
}

TEST(MeasuredLeaves, TurningIsToldAsAWarningAtTheFirstRow) {
  Errors warnings;
  const auto widths =
      read_widths("rankclass,s,r\n1,0,.6\n1,.5,1\n1,1,0\n2,1,0\n2,.5,1\n2,0,.6\n3,0,0\n3,.5,1\n3,1,.6\n", {}, warnings);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0].severity, Severity::warning);
  EXPECT_EQ(warnings[0].line, 5);
  EXPECT_EQ(warnings[1].line, 8);
  for (const MeasuredCurve& of_class : widths) EXPECT_EQ(of_class.points, widths[0].points);
}

TEST(MeasuredLeaves, FilesOfManyMidribsAllRead) {
  for (const auto& [file, midribs] : data_sets<std::size_t>(
           {{"tests/data/grass/midribs.csv", 72}, {"tests/data/grass/midribs_by_age.csv", 30}},
           {{"grass/So99.csv", 450}, {"grass/median_leaf_trajectories_Soissons_Grignon2010_byleafclass.csv", 50}})) {
    EXPECT_EQ(midribs_in(read_file(file, SizeLimits{}.file_bytes)).size(), midribs) << file;
  }
}

TEST(MeasuredLeaves, FilesOfWidthsAllReadWithoutWarnings) {
  for (const auto& [file, classes] :
       data_sets<std::size_t>({{"tests/data/grass/widths.csv", 6}, {"tests/data/grass/few_widths.csv", 2}},
                              {{"grass/SRSo.csv", 6}, {"grass/srdb_GrignonMercia2010.csv", 2}})) {
    Errors warnings;
    EXPECT_EQ(read_widths(read_file(file, SizeLimits{}.file_bytes), {}, warnings).size(), classes) << file;
    EXPECT_TRUE(warnings.empty()) << file;
  }
}

}  // namespace meristem::measured_leaves_test
