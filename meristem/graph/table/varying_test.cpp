// SPDX-License-Identifier: Apache-2.0
// Numbers that differ from instance to instance.
#include "meristem/graph/table/varying.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::varying_test {

// Five sticks a metre apart with the given parameters, along x.
GraphBuilder five_sticks(const Value::Object& parameters) {
  GraphBuilder builder(test_components());
  builder.variable("age", 4);
  builder.component("view", "camera").component("star", "star", {{"number", 5}});
  builder.component("stick", "stick", parameters);
  return builder.link("view", "star").link("star", "stick");
}

// The heights of the sticks, one per instance.
std::vector<float> heights(const GraphBuilder& builder, double time = 0) {
  const Plant plant = builder.grow(time);
  std::vector<float> heights;
  for (const Organ& organ : organs_of(plant, "stick")) {
    heights.push_back(plant.prototypes[organ.prototype].mesh->positions[2].y);
  }
  return heights;
}

std::vector<float> lengths(Value value) { return heights(five_sticks({{"length", std::move(value)}})); }

using Floats = std::vector<float>;

TEST(Varying, ANumberIsTheSameForAll) { EXPECT_EQ(lengths(2), Floats(5, 2)); }

TEST(Varying, ARangeGoesEvenlyFromTheFirstChildToTheLast) {
  EXPECT_EQ(lengths(Value::List{1, 3}), (Floats{1, 1.5F, 2, 2.5F, 3}));
}

TEST(Varying, ARangeGivesAnOnlyChildItsFirstValue) {
  auto builder = five_sticks({{"length", Value::List{2, 3}}});
  builder.component("star", "star", {{"number", 1}});
  EXPECT_EQ(heights(builder), Floats{2});
}

TEST(Varying, AnExpressionSeesTheRangesValueAsV) {
  const Value::List range{1, 3};
  EXPECT_EQ(lengths(Value::Object{{"range", range}, {"apply", "v * 2 + i"}}), (Floats{2, 4, 6, 8, 10}));
  EXPECT_EQ(lengths(Value::Object{{"range", range}}), lengths(range));
}

TEST(Varying, WithoutARangeVIsTheDefault) {
  EXPECT_EQ(lengths("v + i"), (Floats{1, 2, 3, 4, 5}));
  EXPECT_EQ(lengths(Value::Object{{"apply", "v + i"}}), (Floats{1, 2, 3, 4, 5}));
  EXPECT_EQ(lengths(Value::Object{{"apply", "3 + 4"}}), Floats(5, 7));
}

TEST(Varying, ExpressionsSeeTheSitesNumbers) {
  EXPECT_EQ(lengths("n"), Floats(5, 5));
  EXPECT_EQ(lengths("x + 1"), (Floats{1, 2, 3, 4, 5}));
  EXPECT_EQ(lengths("1 + abs(y) + abs(z)"), Floats(5, 1));
  EXPECT_EQ(lengths("hx + 2 * hy + 3 * hz"), Floats(5, 2));
  EXPECT_EQ(lengths("u + depth + order + age"), Floats(5, 5));
  EXPECT_EQ(heights(five_sticks({{"length", "1 + t"}}), 2.5), Floats(5, 3.5F));
}

TEST(Varying, LengthAndRadiusAreThoseOfTheParent) {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("parent", "stick", {{"length", 3}, {"width", 0.25}});
  builder.component("stick", "stick", {{"length", "length + radius"}});
  builder.link("view", "parent").link("parent", "stick");
  EXPECT_EQ(heights(builder), Floats{3.25F});
}

TEST(Varying, ResultsAreClampedToTheParametersRange) { EXPECT_EQ(lengths("i * 4 - 1"), (Floats{0, 3, 7, 10, 10})); }

TEST(Varying, IntegersAreRounded) {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("two", "star", {{"number", 2}});
  builder.component("star", "star", {{"number", "1.4 + i * 1.2"}}).component("stick", "stick");
  builder.link("view", "two").link("two", "star").link("star", "stick");
  EXPECT_EQ(heights(builder).size(), 1U + 3U);  // 1.4 and 2.6
}

TEST(Varying, AnglesVaryInDegrees) {
  const Plant plant = five_sticks({{"frame", Value::Object{{"rotate", Value::List{0, 0, "90 * i"}}}}}).grow();
  const std::vector<Organ> organs = organs_of(plant, "stick");
  const Vec3 headings[] = {{0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_LT(glm::distance(organs[k].frame.heading(), headings[k]), 1e-6F) << k;
}

TEST(Varying, ResultsThatAreNotFiniteAreInputErrorsAtTheParameter) {
  for (const char* text : {"1 / (i - 2)", "log(-i)", "0 / i"}) {
    const auto errors = errors_of([&] { lengths(text); });
    ASSERT_EQ(errors.size(), 1U) << text;
    EXPECT_EQ(errors[0].path, "components.stick.length");
    EXPECT_NE(errors[0].message.find(text), std::string::npos) << errors[0].message;
  }
  const auto nested = errors_of([] {
    five_sticks({{"frame", Value::Object{{"rotate", Value::List{0, "1 / i", 0}}}}}).grow();
  });
  ASSERT_EQ(nested.size(), 1U);
  EXPECT_EQ(nested[0].path, "components.stick.frame.rotate[1]");
}

TEST(Varying, FaultsInAValueAreRejectedWithTheirPlace) {
  const auto path_of = [](Value value) {
    const auto errors = errors_of([&] { five_sticks({{"length", std::move(value)}}); });
    return errors.size() == 1 ? errors[0].path : "not one fault";
  };
  EXPECT_EQ(path_of(Value::List{1, 2, 3}), "components.stick.length");
  EXPECT_EQ(path_of(Value::List{1, 11}), "components.stick.length[1]");
  EXPECT_EQ(path_of(Value::List{"i", 1}), "components.stick.length[0]");
  EXPECT_EQ(path_of("1 + j"), "components.stick.length");
  EXPECT_EQ(path_of(Value::Object{{"aply", "v"}, {"range", Value::List{1, 2}}}), "components.stick.length.aply");
  EXPECT_EQ(path_of(Value::Object{{"range", 1}}), "components.stick.length.range");
  EXPECT_EQ(path_of(Value::Object{{"apply", 1}}), "components.stick.length.apply");
  EXPECT_EQ(path_of(Value::Object{}), "components.stick.length");
  EXPECT_EQ(path_of(Value()), "components.stick.length");
}

TEST(Varying, RandomNumbersDifferBetweenInstancesAndParameters) {
  const Floats drawn = lengths("10 * rand()");
  for (std::size_t k = 1; k < drawn.size(); ++k) EXPECT_NE(drawn[k], drawn[0]);
  const Plant plant = five_sticks({{"length", "rand()"}, {"width", "rand()"}}).grow();
  for (const OrganPrototype& prototype : plant.prototypes) {
    EXPECT_NE(prototype.mesh->positions[1].x, prototype.mesh->positions[2].y);
  }
  EXPECT_EQ(lengths("10 * rand()"), drawn);
}

TEST(Varying, TheSeedChangesAllThatIsRandom) {
  auto builder = five_sticks({{"length", "10 * rand()"}});
  const Floats before = heights(builder);
  const Floats after = heights(builder.seed(99));
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NE(before[k], after[k]);
}

}  // namespace meristem::varying_test
