// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/simple.h"

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"
#include "tests/support/check_mesh.h"

namespace meristem {
namespace {

GraphBuilder one(const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  return builder.component("view", "camera").component("body", "simple", parameters).link("view", "body");
}

// The box around a component's organs in the world.
Box box_of(const Plant& plant, std::string_view component) {
  Box box;
  for (const Organ& organ : organs_of(plant, component)) {
    for (const Vec3 position : plant.prototypes[organ.prototype].mesh->positions) box.add(organ.frame.point(position));
  }
  return box;
}

class SimpleShape : public testing::TestWithParam<const char*> {};

TEST_P(SimpleShape, FillsItsSizeAndStandsOnItsFrame) {
  const Plant plant = one({{"shape", GetParam()}, {"size", Value::List{0.4, 1.5, 0.8}}, {"segments", 32}}).grow();
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

TEST(Simple, SizesShareOneShape) {
  auto builder = one({{"size", Value::List{"1 + i", "rand(1, 2)", 1}}});
  for (int k = 0; k < 9; ++k) builder.link("view", "body");
  const Plant plant = builder.grow();
  EXPECT_EQ(plant.organs.size(), 10U);
  EXPECT_EQ(plant.prototypes.size(), 1U);
}

TEST(Simple, WrongSizesAndShapesAreRejected) {
  EXPECT_EQ(faults_of([] { one({{"size", Value::List{1, 0, 1}}}); }).at(0).path, "components.body.size[1]");
  EXPECT_EQ(faults_of([] { one({{"segments", 2}}); }).at(0).path, "components.body.segments");
  EXPECT_EQ(faults_of([] { one({{"shape", "shpere"}}); }).at(0).nearest, "sphere");
}

}  // namespace
}  // namespace meristem
