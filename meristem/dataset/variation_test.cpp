// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/variation.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "meristem/document/json.h"

namespace meristem::variation_test {

std::optional<ValueVariation> read(const std::string& text, std::vector<Diagnostic>* errors = nullptr) {
  ParameterReader reader({}, SizeLimits());
  const DocumentPath top;
  auto variation = read_variation(parse_json(text), DocumentPath(top, "age"), reader);
  if (errors != nullptr) *errors = reader.take_diagnostics();
  return variation;
}

std::vector<double> drawn(const std::string& text, std::uint64_t count = 2000) {
  const ValueVariation variation = read(text).value();
  std::vector<double> numbers;
  for (std::uint64_t k = 0; k < count; ++k) numbers.push_back(*variation.draw(RandomKey(1).child(k)).number());
  return numbers;
}

double mean(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double number : numbers) sum += number;
  return sum / static_cast<double>(numbers.size());
}

// The mean of 2000 draws lies within 4 standard errors of the mean of the distribution.
TEST(Variation, HasTheMeanOfItsDistribution) {
  const double root = std::sqrt(2000.0);
  EXPECT_NEAR(mean(drawn(R"({"uniform": [2, 6]})")), 4, 4 * 4 / std::sqrt(12.0) / root);
  EXPECT_NEAR(mean(drawn(R"({"normal": [10, 2]})")), 10, 4 * 2 / root);
  EXPECT_NEAR(mean(drawn(R"({"triangular": [0, 3, 6]})")), 3, 4 * 1.3 / root);
  EXPECT_NEAR(mean(drawn(R"({"integer": [1, 6]})")), 3.5, 4 * 1.8 / root);
  EXPECT_NEAR(mean(drawn(R"({"lognormal": [1, 0.5]})")), std::exp(0.125), 4 * 0.61 / root);
  EXPECT_NEAR(mean(drawn(R"({"log_uniform": [1, 100]})")), 99 / std::log(100.0), 4 * 24 / root);
}

TEST(Variation, StaysWithinItsBounds) {
  for (const char* text :
       {R"({"normal": [10, 8], "within": [9, 11]})", R"({"uniform": [0, 100], "within": [9, 11]})",
        R"({"lognormal": [10, 1], "within": [9, 11]})", R"({"triangular": [0, 1, 40], "within": [9, 11]})"}) {
    for (const double number : drawn(text, 300)) {
      EXPECT_GE(number, 9) << text;
      EXPECT_LE(number, 11) << text;
    }
  }
}

TEST(Variation, TellsTheShareWithinItsBounds) {
  EXPECT_NEAR(read(R"({"uniform": [0, 10], "within": [9, 20]})")->share_within(), 0.1, 1e-12);
  EXPECT_NEAR(read(R"({"normal": [0, 1], "within": [-1.959964, 1.959964]})")->share_within(), 0.95, 1e-6);
  EXPECT_NEAR(read(R"({"triangular": [0, 1, 2], "within": [0, 1]})")->share_within(), 0.5, 1e-12);
  EXPECT_NEAR(read(R"({"integer": [1, 6], "within": [2, 3]})")->share_within(), 1.0 / 3, 1e-12);
  EXPECT_EQ(read(R"({"normal": [5, 0], "within": [6, 7]})")->share_within(), 0);
}

TEST(Variation, ChoosesByWeights) {
  const ValueVariation plain = *read(R"({"choice": ["a", "b", "c"]})");
  const ValueVariation weighted = *read(R"({"choice": ["a", "b", "c"], "weights": [1, 0, 3]})");
  std::map<std::string, int> of_plain, of_weighted;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    ++of_plain[*plain.draw(RandomKey(2).child(k)).text()];
    ++of_weighted[*weighted.draw(RandomKey(2).child(k)).text()];
  }
  for (const char* name : {"a", "b", "c"}) EXPECT_NEAR(of_plain[name], 2000 / 3.0, 85);
  EXPECT_NEAR(of_weighted["a"], 500, 78);
  EXPECT_EQ(of_weighted["b"], 0);
}

TEST(Variation, DrawsWholeNumbersWithBothEnds) {
  std::map<double, int> counts;
  for (const double number : drawn(R"({"integer": [-1, 1]})", 300)) ++counts[number];
  EXPECT_EQ(counts.size(), 3U);
  EXPECT_GT(counts[-1], 50);
  EXPECT_GT(counts[1], 50);
}

// The value of a key is part of the format of data sets and must not change.
TEST(Variation, GivesTheValuesOfItsKeys) {
  const RandomKey key = RandomKey(7).child("values").child("age");
  const double share = key.uniform(0);
  EXPECT_EQ(*read(R"({"uniform": [20, 60]})")->draw(key).number(), 20 + 40 * share);
  EXPECT_EQ(*read(R"({"normal": [1, 2]})")->draw(key).number(), 1 + 2 * key.normal(0));
}

TEST(Variation, RejectsWhatIsNoDistribution) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"20", "age"},
      {R"({"uniforn": [1, 2]})", "age.uniforn"},
      {R"({"uniform": [2, 1]})", "age.uniform"},
      {R"({"uniform": [2]})", "age.uniform"},
      {R"({"normal": [2, -1]})", "age.normal"},
      {R"({"lognormal": [0, 1]})", "age.lognormal"},
      {R"({"log_uniform": [0, 1]})", "age.log_uniform"},
      {R"({"triangular": [0, 3, 2]})", "age.triangular"},
      {R"({"integer": [0.5, 2]})", "age.integer"},
      {R"({"uniform": [1, 2], "normal": [1, 2]})", "age"},
      {R"({"choice": []})", "age.choice"},
      {R"({"choice": [1, 2], "weights": [1]})", "age.weights"},
      {R"({"choice": [1, 2], "weights": [0, 0]})", "age.weights"},
      {R"({"choice": [1, 2], "within": [1, 2]})", "age.within"},
      {R"({"uniform": [1, 2], "weights": [1, 2]})", "age.weights"},
      {R"({"uniform": [1, 2], "within": [2, 1]})", "age.within"},
  };
  for (const auto& [text, path] : cases) {
    std::vector<Diagnostic> errors;
    EXPECT_FALSE(read(text, &errors)) << text;
    ASSERT_EQ(errors.size(), 1U) << text;
    EXPECT_EQ(errors[0].path, path) << text;
    EXPECT_FALSE(errors[0].expected.empty()) << text;
  }
  std::vector<Diagnostic> errors;
  read(R"({"uniforn": [1, 2]})", &errors);
  EXPECT_EQ(errors[0].nearest, "uniform");
}

}  // namespace meristem::variation_test
