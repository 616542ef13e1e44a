// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/simple.h"

#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/components/parts/unit_shape.h"
#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"
#include "tests/support/check_mesh.h"

namespace meristem::simple_test {

GraphBuilder one(const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  return builder.component("view", "camera").component("body", "simple", parameters).link("view", "body");
}

// Returns the bounding box of a component's organs in world space.
Box box_of(const Plant& plant, std::string_view component) {
  Box box;
  for (const Organ& organ : organs_of(plant, component)) {
    for (const Vec3 position : plant.prototypes[organ.prototype].mesh->positions) box.add(organ.frame.point(position));
  }
  return box;
}

class SimpleShape : public testing::TestWithParam<const char*> {};

TEST_P(SimpleShape, FillsItsSizeAndStandsOnItsFrame) {
  Value::Object body{{"shape", GetParam()}, {"size", Value::List{0.4, 1.5, 0.8}}};
  if (GetParam() != std::string("box")) body.emplace_back("segments", 32);
  const Plant plant = one(body).grow();
  EXPECT_TRUE(check_mesh(*plant.prototypes.at(0).mesh));
  const Box box = box_of(plant, "body");
  EXPECT_LT(glm::distance(box.low, Vec3(-0.2F, 0, -0.4F)), 0.02F);
  EXPECT_LT(glm::distance(box.high, Vec3(0.2F, 1.5F, 0.4F)), 0.02F);
  EXPECT_NEAR(box.size().y, 1.5F, 0.02F);
}

TEST_P(SimpleShape, ChildrenStandOnTop) {
  auto builder = one({{"shape", GetParam()}, {"size", Value::List{1, 3, 1}}});
  const Plant plant = builder.component("child", "simple").link("body", "child").grow();
  EXPECT_NEAR(box_of(plant, "child").low.y, 3, 1e-6F);
}

INSTANTIATE_TEST_SUITE_P(Shapes, SimpleShape, testing::Values("box", "sphere", "cylinder", "cone", "torus"));

TEST(Simple, TrianglesOfShapesAreCountedWithoutAMesh) {
  for (const UnitShape shape :
       {UnitShape::box, UnitShape::sphere, UnitShape::cylinder, UnitShape::cone, UnitShape::torus}) {
    for (const int segments : {3, 4, 5, 7, 16, 33}) {
      EXPECT_EQ(unit_shape_triangles(shape, segments),
                static_cast<double>(make_unit_shape(shape, segments).triangle_count()))
          << static_cast<int>(shape) << " " << segments;
    }
  }
}

TEST(Simple, SizesShareOneShape) {
  auto builder = one({{"size", Value::List{"1 + i", "rand(1, 2)", 1}}});
  for (int k = 0; k < 9; ++k) builder.link("view", "body");
  const Plant plant = builder.grow();
  EXPECT_EQ(plant.organs.size(), 10U);
  EXPECT_EQ(plant.prototypes.size(), 1U);
}

Value pairs(std::initializer_list<std::pair<double, double>> points) {
  Value::List list;
  for (const auto& [x, z] : points) list.emplace_back(Value::List{x, z});
  return list;
}

// A tube that is its own child: each section is smaller than the previous one, and bent.
Value::Object horn(int sections) {
  const Value::Object frame{{"scale", Value::List{0.95, 0.95, 0.95}}, {"rotate", Value::List{5, 2, 0}}};
  return {{"shape", "tube"}, {"size", Value::List{1, 0.5, 1}}, {"recursion", sections}, {"frame", frame}};
}

TEST(SimpleTube, HangingOnItselfIsOneClosedSmoothHorn) {
  auto builder = one(horn(40));
  const Plant plant = builder.link("body", "body").grow();
  ASSERT_EQ(plant.organs.size(), 1U);
  const Mesh& mesh = *plant.prototypes.at(0).mesh;
  EXPECT_TRUE(check_mesh(mesh));
  EXPECT_EQ(euler_number(mesh), 2);
  EXPECT_FALSE(plant.materials.at(0).two_sided);
  // 40 rings with 24 quads between neighbours, and two discs.
  EXPECT_EQ(mesh.triangle_count(), 39U * 48 + 48);
}

TEST(SimpleTube, AnOutlineEitherWayRoundFacesOutward) {
  for (const bool is_clockwise : {true, false}) {
    const Value outline =
        is_clockwise ? pairs({{0, 0}, {1, 0}, {1, 1}, {0, 1}}) : pairs({{0, 0}, {0, 1}, {1, 1}, {1, 0}});
    auto builder = one({{"shape", "tube"}, {"outline", outline}, {"size", Value::List{1, 2, 1}}});
    const Value other = pairs({{0, 0}, {0, 1}, {1, 1}, {1, 0}});
    const Plant plant =
        builder.component("top", "simple", {{"shape", "tube"}, {"outline", other}}).link("body", "top").grow();
    ASSERT_EQ(plant.organs.size(), 2U);  // the first has the cap at the base
    double volume = 0;
    for (const Organ& organ : plant.organs) volume += signed_volume(*plant.prototypes[organ.prototype].mesh);
    EXPECT_NEAR(volume, 2, 1e-5);
  }
}

TEST(SimpleTube, AloneItIsADiscSeenFromBothSides) {
  const Plant plant = one({{"shape", "tube"}, {"size", Value::List{2, 1, 2}}, {"segments", 64}}).grow();
  EXPECT_NEAR(surface_area(*plant.prototypes.at(0).mesh), kPi, 0.01);
  EXPECT_TRUE(plant.materials.at(0).two_sided);
  EXPECT_TRUE(one({{"shape", "tube"}, {"cap", false}}).grow().organs.empty());
  EXPECT_TRUE(one({{"shape", "area"}}).grow().organs.empty());
  EXPECT_TRUE(one({{"shape", "none"}}).grow().organs.empty());
}

// Petals around an axis, each a row of four areas and a tip.
GraphBuilder petals(int number, const Value::Object& own = {}) {
  GraphBuilder builder(builtin_components());
  Value::Object petal{{"shape", "area"},
                      {"size", Value::List{"0.02 + 0.01 * sin(60 * depth)", 0.02, 0.1}},
                      {"recursion", 4},
                      {"frame", Value::Object{{"rotate", Value::List{12, 0, 0}}}}};
  petal.insert(petal.end(), own.begin(), own.end());
  builder.component("view", "camera").component("star", "hydra", {{"number", number}});
  builder.component("petal", "simple", petal);
  builder.component("tip", "simple", {{"shape", "area"}, {"outline", pairs({{0, 0}})}});
  builder.link("view", "star").link("star", "petal").link("petal", "petal");
  return builder.link("petal", "tip", LinkKind::leaf);
}

TEST(SimpleArea, EqualPetalsShareTheirMesh) {
  const Plant plant = petals(50).grow();
  EXPECT_EQ(organs_of(plant, "petal").size(), 50U);
  EXPECT_EQ(organs_of(plant, "tip").size(), 50U);
  EXPECT_EQ(prototypes_of(plant, "petal").size(), 1U);
  EXPECT_EQ(prototypes_of(plant, "tip").size(), 1U);
  EXPECT_TRUE(check_mesh(*prototypes_of(plant, "petal")[0].mesh, {.closed = false}));
}

TEST(SimpleArea, ChanceGivesAWholePetalOneColour) {
  const Plant plant = petals(20, {{"variety", 0.3}}).grow();
  const std::vector<Organ> organs = organs_of(plant, "petal");
  ASSERT_EQ(organs.size(), 20U);
  EXPECT_NE(organs[0].tint, organs[1].tint);
}

TEST(SimpleArea, HiddenAndOmittedSectionsMakeNoSurface) {
  EXPECT_EQ(organs_of(petals(5, {{"hidden", true}}).grow(), "petal").size(), 0U);
  EXPECT_EQ(organs_of(petals(5, {{"omit", Value::List{"depth == 0 && i < 2"}}}).grow(), "petal").size(), 3U);
  // A gap in each petal.
  const Value::Object gap{{"omit", Value::List{"depth == 2"}}, {"omit_keeps_children", true}};
  const Plant plant = petals(5, gap).grow();
  EXPECT_EQ(organs_of(plant, "petal").size(), 5U);
  EXPECT_EQ(prototypes_of(plant, "petal").at(0).mesh->triangle_count(), 2U);
}

TEST(SimpleArea, SurfacesHaveTheSameBytesOnAnyNumberOfThreads) {
  const auto hash = [](int threads) {
    const ThreadLimit limit(threads);
    return hash_of(petals(700, {{"place", Value::Object{{"scale", Value::List{"rand(0.5, 2)", 1, 1}}}}}).grow());
  };
  const std::string one_thread = hash(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(hash(threads), one_thread);
}

TEST(SimpleArea, LimitsNameTheComponent) {
  auto builder = petals(700, {{"place", Value::Object{{"scale", Value::List{"rand(0.5, 2)", 1, 1}}}}});
  builder.mesh_limit(50'000);
  const auto errors = errors_of([&] { builder.grow(); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "components.petal");
}

TEST(Simple, FaultyOutlinesAreRejectedAtTheirPlace) {
  const auto path_of = [](const char* shape, const Value& outline) {
    const auto errors = errors_of([&] { one({{"shape", shape}, {"outline", outline}}); });
    return errors.size() == 1 ? errors[0].path : "not one fault";
  };
  EXPECT_EQ(path_of("box", pairs({{0, 0}, {1, 0}, {1, 1}})), "components.body.outline");
  EXPECT_EQ(path_of("tube", pairs({{0, 0}, {1, 0}})), "components.body.outline");
  EXPECT_EQ(path_of("tube", pairs({{0, 0}, {1, 0}, {1, 0}, {1, 1}})), "components.body.outline[2]");
  EXPECT_EQ(path_of("tube", pairs({{0, 0}, {1, 1}, {1, 0}, {0, 1}})), "components.body.outline");
  EXPECT_EQ(path_of("area", pairs({{0, 0}, {0, 0}})), "components.body.outline[1]");
}

TEST(Simple, WrongSizesAndShapesAreRejected) {
  EXPECT_EQ(errors_of([] { one({{"size", Value::List{1, 0, 1}}}); }).at(0).path, "components.body.size[1]");
  EXPECT_EQ(errors_of([] { one({{"segments", 2}}); }).at(0).path, "components.body.segments");
  EXPECT_EQ(errors_of([] { one({{"shape", "shpere"}}); }).at(0).nearest, "sphere");
}

}  // namespace meristem::simple_test
