// SPDX-License-Identifier: Apache-2.0
// Numbers that are drawn from measured values. Bounds of the statistics: four standard errors of what is drawn, from
// the values' own variance; keys are fixed, so a test that holds once holds always.
#include "meristem/graph/table/sample.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/document/json.h"
#include "meristem/graph/placement.h"
#include "meristem/graph/table/reader.h"
#include "meristem/graph/table/table.h"
#include "tests/support/temporary_folder.h"

namespace meristem::sample_test {

struct Angles {
  double angle = 0.5;
  int count = 1;
  double fixed = 1;
};

const ParameterTable& angles_table() {
  static const ParameterTable table =
      Table<Angles>("angles", "For tests.")
          .number("angle", &Angles::angle, {.unit = Unit::degree, .min = 0, .max = 180}, "An angle.")
          .integer("count", &Angles::count, {.min = 0, .max = 100}, "A number.")
          .number("fixed", &Angles::fixed, {.fixed = true}, "One for all.");
  return table;
}

struct Read {
  Angles angles;
  std::vector<Varying> varyings;
  std::vector<std::string> errors;
};

Read read(const std::string& json, const std::string& folder = {}, const SizeLimits& limits = {}) {
  ParameterReader reader({{"tilt", 40}}, limits, {.folder = folder});
  Read result;
  const DocumentPath top;
  result.varyings = reader.read_varying(angles_table(), &result.angles, parse_json(json), DocumentPath(top, "it"));
  for (const Diagnostic& error : reader.diagnostics()) result.errors.push_back(error.text());
  return result;
}

std::vector<Site> sites(std::size_t count) {
  std::vector<Site> made(count);
  for (std::size_t k = 0; k < count; ++k) {
    made[k].key = RandomKey(7).child(k);
    made[k].i = static_cast<std::uint32_t>(k);
    made[k].n = static_cast<std::uint32_t>(count);
  }
  return made;
}

/// In degrees.
std::vector<double> drawn(const std::string& json, std::size_t count, const std::string& folder = {}) {
  const Read given = read(json, folder);
  EXPECT_TRUE(given.errors.empty()) << given.errors.front();
  const std::vector<Site> all = sites(count);
  const VaryingValues values(given.varyings, all, 0);
  std::vector<double> result;
  for (std::size_t k = 0; k < count; ++k) result.push_back(degrees(values.value(0, k)));
  return result;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double deviation(const std::vector<double>& values) {
  const double middle = mean(values);
  double sum = 0;
  for (const double value : values) sum += (value - middle) * (value - middle);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

constexpr std::size_t kMany = 20'000;
const std::vector<double> kMeasured{20, 35, 35, 40, 90};
const std::string kSample = R"({"angle": {"sample": [40, 35, 90, 20, 35]}})";

TEST(Sample, InstancesHaveTheValuesThemselvesAsOftenAsTheyAreThere) {
  const std::vector<double> values = drawn(kSample, kMany);
  for (const double value : {20.0, 35.0, 40.0, 90.0}) {
    const double share = value == 35 ? 0.4 : 0.2;
    const auto found = std::ranges::count_if(values, [&](double one) { return std::abs(one - value) < 1e-9; });
    const double standard_error = std::sqrt(share * (1 - share) / kMany);
    EXPECT_NEAR(static_cast<double>(found) / kMany, share, 4 * standard_error) << value;
  }
  EXPECT_NEAR(mean(values), mean(kMeasured), 4 * deviation(kMeasured) / std::sqrt(kMany));
}

TEST(Sample, SmoothOnesLieOnTheLinesBetweenNeighbours) {
  std::vector<double> values = drawn(R"({"angle": {"sample": [0, 30, 40, 100], "smooth": true}})", kMany);
  std::ranges::sort(values);
  // A value's share is interpolated between the ranks of its neighbours: each of the three lines has a third.
  const Sample sample{{0, 30, 40, 100}, true};
  for (const double share : {0.1, 0.25, 1.0 / 3, 0.5, 0.6, 0.9}) {
    const double value = sample.quantile(share);
    const auto below = std::ranges::lower_bound(values, value) - values.begin();
    EXPECT_NEAR(static_cast<double>(below) / kMany, share, 4 * std::sqrt(share * (1 - share) / kMany)) << share;
  }
  EXPECT_GE(values.front(), 0);
  EXPECT_LT(values.back(), 100);
  // The mean of the distribution is the mean of the middles of its lines.
  EXPECT_NEAR(mean(values), (15 + 35 + 70) / 3.0, 4 * deviation(values) / std::sqrt(kMany));
}

TEST(Sample, QuantilesAreTheClosedForms) {
  const Sample steps{{1, 2, 4}, false};
  EXPECT_EQ(steps.quantile(0), 1);
  EXPECT_EQ(steps.quantile(0.3333), 1);
  EXPECT_EQ(steps.quantile(0.3334), 2);
  EXPECT_EQ(steps.quantile(0.9999), 4);
  EXPECT_EQ(steps.quantile(1), 4);
  const Sample smooth{{1, 2, 4}, true};
  EXPECT_EQ(smooth.quantile(0), 1);
  EXPECT_EQ(smooth.quantile(0.25), 1.5);
  EXPECT_EQ(smooth.quantile(0.75), 3);
  EXPECT_EQ(smooth.quantile(1), 4);
  EXPECT_EQ((Sample{{5}, true}.quantile(0.5)), 5);
}

TEST(Sample, AnExpressionSeesTheDrawnValue) {
  const std::vector<double> plain = drawn(kSample, 50);
  const std::vector<double> turned = drawn(R"({"angle": {"sample": [40, 35, 90, 20, 35], "apply": "v + 10"}})", 50);
  for (std::size_t k = 0; k < plain.size(); ++k) EXPECT_NEAR(turned[k], plain[k] + 10, 1e-9);
}

TEST(Sample, DrawsDependOnTheInstanceAndTheParameterAlone) {
  const std::vector<double> many = drawn(kSample, 200);
  const std::vector<double> few = drawn(kSample, 100);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  EXPECT_EQ(drawn(R"({"angle": {"sample": [20, 35, 35, 40, 90]}})", 100), few) << "whatever their order";
}

TEST(Sample, ValuesMayBeExpressionsOfVariablesAndWholeNumbersStaySo) {
  EXPECT_NEAR(drawn(R"({"angle": {"sample": ["tilt / 2"]}})", 1)[0], 20, 1e-12);
  EXPECT_EQ(read(R"({"count": {"sample": [1, 2.5]}})").errors[0],
            "it.count.sample[1]: 'count' cannot be the fraction 2.5; expected a whole number from 0 to 100");
}

TEST(Sample, AColumnOfAFileGivesTheValues) {
  const TemporaryFolder folder;
  std::ofstream(folder / "angles.csv") << "tree;angle\n1;40,5\n1;35\n2;90\n";
  const std::string json = R"({"angle": {"sample": {"file": "angles.csv", "column": "angle"}}})";
  std::vector<double> values = drawn(json, 200, folder.path().string());
  std::ranges::sort(values);
  EXPECT_NEAR(values.front(), 35, 1e-12);
  EXPECT_NEAR(values[100], 40.5, 1e-12);
  EXPECT_NEAR(values.back(), 90, 1e-12);
}

TEST(Sample, FaultsOfFilesHaveTheirPlaceInThem) {
  const TemporaryFolder folder;
  const auto error_of = [&](const std::string& table, const std::string& column = "angle") {
    std::ofstream(folder / "angles.csv") << table;
    const Read given =
        read(fmt::format(R"({{"angle": {{"sample": {{"file": "angles.csv", "column": "{}"}}}}}})", column),
             folder.path().string(), {.points = 4});
    return given.errors.size() == 1 ? given.errors[0] : fmt::format("{} faults", given.errors.size());
  };
  EXPECT_EQ(
      error_of("tree,angel\n1,40\n"),
      "it.angle.sample.file: 'angles.csv:1:1': there is no column 'angle'; expected a head line that names it; did "
      "you mean 'angel'?");
  EXPECT_EQ(error_of("tree,angle\n1,40\n1,steep\n"),
            "it.angle.sample.file: 'angles.csv:3:3': 'steep' in the column 'angle' is not a number; expected a finite "
            "number");
  EXPECT_EQ(
      error_of("tree,angle\n1,40\n1,190\n"),
      "it.angle.sample.file: 'angles.csv:3:3': the value 190 of the column 'angle' cannot be that of 'angle'; expected "
      "a number (°) from 0 to 180");
  EXPECT_EQ(error_of("angle\n1\n2\n3\n4\n5\n").substr(0, 62),
            "it.angle.sample.file: 'angles.csv:6': 5 rows of a table are to");
}

TEST(Sample, FaultsAreTold) {
  const auto error_of = [](const std::string& json) {
    const Read given = read(json);
    return given.errors.size() == 1 ? given.errors[0] : fmt::format("{} faults", given.errors.size());
  };
  EXPECT_EQ(error_of(R"({"angle": {"sample": []}})"),
            "it.angle.sample: the sample of 'angle' has no values; expected at least one number");
  EXPECT_EQ(error_of(R"({"angle": {"sample": [20, 200]}})"),
            "it.angle.sample[1]: the value 200 is out of range for 'angle'; expected a number (°) from 0 to 180");
  EXPECT_EQ(error_of(R"({"angle": {"sample": [20], "range": [1, 2]}})"),
            "it.angle.range: a value has both a sample and a range; expected one of them");
  EXPECT_EQ(error_of(R"({"angle": {"range": [1, 2], "smooth": true}})"),
            "it.angle.smooth: 'smooth' has no meaning without a sample; expected 'sample' beside it");
  EXPECT_EQ(error_of(R"({"angle": {"smaple": [20]}})"),
            "it.angle: 'angle' cannot be an object; expected a number (°) from 0 to 180");
  EXPECT_EQ(error_of(R"({"angle": {"sample": {"file": "a.csv", "colunm": "b"}}})"), "2 faults");
  EXPECT_EQ(error_of(R"({"fixed": {"sample": [1, 2]}})"),
            "it.fixed: 'fixed' is one number for all instances and cannot be an object; expected a number");
}

}  // namespace meristem::sample_test
