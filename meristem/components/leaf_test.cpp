// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/leaf.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "meristem/components/parts/shared_shape.h"
#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"
#include "tests/support/check_mesh.h"

namespace meristem::leaf_test {

// `copies` leaves in a row; each link makes one leaf.
GraphBuilder leaves(int copies, const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("leaf", "leaf", parameters);
  for (int k = 0; k < copies; ++k) builder.link("view", "leaf");
  return builder;
}

Box box_of(const Plant& plant, const Organ& organ) {
  Box box;
  for (const Vec3 position : plant.prototypes[organ.prototype].mesh->positions) box.add(organ.frame.point(position));
  return box;
}

TEST(LeafComponent, AFlatLeafHasItsExactLengthAndWidth) {
  const Value outline = Value::Object{{"curve", Value::List{Value::List{0, 0}, Value::List{0.5, 1}, Value::List{1, 0}}},
                                      {"kind", "linear"}};
  for (const double length : {0.03, 0.08, 1.7}) {
    for (const double width : {0.011, 0.05, 0.9}) {
      const Plant plant = leaves(1, {{"length", length}, {"width", width}, {"outline", outline}}).grow();
      const Box box = box_of(plant, plant.organs.at(0));
      EXPECT_NEAR(box.size().y / length, 1, 1e-5);
      EXPECT_NEAR(box.size().x / width, 1, 1e-5);
      EXPECT_NEAR(box.low.y, 0, 1e-7);
      EXPECT_TRUE(check_mesh(*plant.prototypes[0].mesh, {.closed = false, .outward = false}));
    }
  }
}

TEST(LeafComponent, ScalingALeafScalesItsBytesOnlyByItsFrame) {
  const Plant small = leaves(1, {{"length", 0.05}, {"width", 0.03}}).grow();
  const Plant large = leaves(1, {{"length", 0.1}, {"width", 0.06}}).grow();
  EXPECT_EQ(small.prototypes[0].mesh->positions, large.prototypes[0].mesh->positions);
  EXPECT_EQ(2.0F * small.organs[0].frame.axes, large.organs[0].frame.axes);
}

TEST(LeafComponent, TenThousandVariedLeavesShareFewShapes) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera")
      .component("tree", "colonize",
                 {{"crown", Value::Object{{"profile", Value::List{Value::List{0.5, 0.5}, Value::List{0.5, 1.5}}}}},
                  {"points", 200}});
  builder.component(
      "leaf", "leaf",
      {{"length", "rand(0.05, 0.12)"}, {"width", "rand(0.03, 0.05)"}, {"curl", "rand(0, 30)"}, {"rows", 4}});
  builder.link("view", "tree").link("tree", "leaf", LinkKind::branch, {{"count", 10'000}});
  const Plant plant = builder.grow();
  const std::vector<Organ> organs = organs_of(plant, "leaf");
  EXPECT_EQ(organs.size(), 10'000U);
  // Proportions from 1/4 to 1 in eighths of an octave, and curls from 0 to 30 degrees in steps of 5.
  EXPECT_LE(prototypes_of(plant, "leaf").size(), 17U * 7);
  EXPECT_GE(prototypes_of(plant, "leaf").size(), 30U);
  // Lengths stay exact: the length of a leaf's heading is the length of its blade.
  float min = 1, max = 0;
  for (const Organ& organ : organs) {
    min = std::min(min, glm::length(organ.frame.heading()));
    max = std::max(max, glm::length(organ.frame.heading()));
    const float stretch = glm::length(organ.frame.right()) / glm::length(organ.frame.heading());
    EXPECT_NEAR(stretch, 1, 0.045);
  }
  EXPECT_NEAR(min, 0.05, 1e-4);
  EXPECT_NEAR(max, 0.12, 1e-4);
}

TEST(LeafComponent, AnglesThatVaryAreRoundedToFiveDegreesAndOthersAreExact) {
  const auto mesh = [](const Value& curl) {
    return leaves(1, {{"curl", curl}}).grow().prototypes.at(0).mesh->positions;
  };
  EXPECT_EQ(mesh("38 + i"), mesh(40));
  EXPECT_EQ(mesh("42 + i"), mesh(40));
  EXPECT_EQ(mesh("43 + i"), mesh(45));
  EXPECT_NE(mesh(38), mesh(40));
  EXPECT_NE(mesh(42), mesh(40));
}

TEST(LeafComponent, AStalkThatAllHaveIsExact) {
  const auto box = [](const Value& length, double petiole, double radius) {
    const Plant plant =
        leaves(1, {{"length", length}, {"width", 0.02}, {"petiole", petiole}, {"petiole_radius", radius}}).grow();
    return box_of(plant, plant.organs.at(0));
  };
  EXPECT_NEAR(box(0.07, 0.031, 0.001).size().y, 0.07 + 0.031, 1e-5);
  EXPECT_NEAR(box(0.07, 0.002, 0.0007).size().y, 0.07 + 0.002, 1e-5);
  // If lengths vary, the stalk is a whole number of twentieths.
  EXPECT_NEAR(box("0.07 + i", 0.031, 0.001).size().y, 0.07 * 1.45, 1e-5);
}

TEST(LeafComponent, APolygonIsMirroredAtTheMidrib) {
  const auto pair = [](double a, double b) { return Value(Value::List{a, b}); };
  const Value polygon = Value::List{pair(1, 0.6), pair(0.5, 0.5), pair(0.5, 0.8)};
  const Plant plant = leaves(1, {{"polygon", polygon}, {"length", 0.1}, {"width", 0.08}}).grow();
  const Box box = box_of(plant, plant.organs.at(0));
  EXPECT_NEAR(box.low.x, -0.04, 1e-6);
  EXPECT_NEAR(box.high.x, 0.04, 1e-6);
}

TEST(LeafComponent, ItsTextureShowsTheWholeOutline) {
  const ComponentType& type = *builtin_components().find("leaf");
  Leaf leaf;
  leaf.blade.heart = 0.2;
  leaf.blade.teeth = 9;
  const TextureShape shape = type.texture_shape(&leaf);
  EXPECT_GT(shape.outline.size(), 4U * 9);
  EXPECT_FALSE(shape.masked);
}

TEST(LeafComponent, LongLeavesKeepTheirThinStalk) {
  const Plant plant = leaves(1, {{"length", 3}, {"width", 1}, {"petiole", 0.6}, {"petiole_radius", 0.001}}).grow();
  EXPECT_TRUE(check_mesh(*plant.prototypes.at(0).mesh, {.closed = false, .outward = false}));
  EXPECT_NEAR(box_of(plant, plant.organs[0]).size().y, 3.6, 0.01);
}

TEST(LeafComponent, LeavesOfOneRowHaveTwoTrianglesForEachPointOfTheirPolygon) {
  const auto pair = [](double a, double b) { return Value(Value::List{a, b}); };
  for (const Value::List& polygon : {Value::List{pair(1, 0.42)}, Value::List{pair(0.7, 0.35), pair(1, 0.7)},
                                     Value::List{pair(0.8, 0.2), pair(0.4, 0.4), pair(1, 0.7)}}) {
    const Plant plant = leaves(1, {{"polygon", polygon}, {"rows", 1}, {"fold", 25}}).grow();
    const Mesh& mesh = *plant.prototypes.at(0).mesh;
    EXPECT_TRUE(check_mesh(mesh, {.closed = false, .outward = false}));
    EXPECT_EQ(mesh.triangle_count(), 2 * polygon.size());
  }
}

TEST(LeafComponent, ASawOfAPolygonIsAFrondOfFewTriangles) {
  const auto pair = [](double a, double b) { return Value(Value::List{a, b}); };
  const Value::List saw{pair(0.05, 0.14), pair(0.8, 0.34), pair(0.22, 0.3),  pair(1, 0.56),   pair(0.25, 0.5),
                        pair(0.9, 0.78),  pair(0.2, 0.7),  pair(0.55, 0.96), pair(0.12, 0.88)};
  const Plant plant = leaves(1, {{"polygon", saw}, {"rows", 3}, {"fold", -35}, {"curl", 90}}).grow();
  EXPECT_TRUE(check_mesh(*plant.prototypes.at(0).mesh, {.closed = false, .outward = false}));
  EXPECT_LE(plant.prototypes[0].mesh->triangle_count(), 26U);
}

TEST(LeafComponent, FaultyBladesAreRejected) {
  const auto path_of = [](const Value::Object& parameters) {
    const auto errors = errors_of([&] { leaves(1, parameters); });
    return errors.size() == 1 ? errors[0].path : "not one fault";
  };
  const auto outline = [](double a, double b) {
    return Value(Value::Object{{"curve", Value::List{Value::List{0, a}, Value::List{1, b}}}});
  };
  EXPECT_EQ(path_of({{"outline", outline(0, 0)}}), "components.leaf.outline");
  EXPECT_EQ(path_of({{"outline", outline(0, 1.5)}}), "components.leaf.outline.curve[1][1]");
  EXPECT_EQ(path_of({{"across", 3}}), "components.leaf.across");
  EXPECT_EQ(path_of({{"length", 0}}), "components.leaf.length");
  EXPECT_EQ(path_of({{"rows", "i"}}), "components.leaf.rows");
  const auto pair = [](double a, double b) { return Value(Value::List{a, b}); };
  EXPECT_EQ(path_of({{"polygon", Value::List{pair(0.5, 0.2), pair(1.5, 0.5)}}}), "components.leaf.polygon[1][0]");
  EXPECT_EQ(path_of({{"polygon", Value::List{pair(0, 0.2)}}}), "components.leaf.polygon");
  EXPECT_EQ(path_of({{"polygon", Value::List{pair(1, 0.2), pair(0, 0.5), pair(1, 0.8)}}}), "components.leaf.polygon");
  EXPECT_EQ(path_of({{"polygon", Value::List{pair(1, 0.5)}}, {"outline", outline(0, 1)}}), "components.leaf.outline");
  EXPECT_EQ(path_of({{"teeth_depth", 0.2}}), "components.leaf.teeth_depth");
  EXPECT_EQ(path_of({{"heart", "rand(0, 1)"}}), "components.leaf.heart");
  EXPECT_EQ(path_of({{"edge", "picture"}}), "components.leaf.edge");
}

TEST(Leaf, PhototropismTurnsItsUpperFaceAndGravitropismItsHeading) {
  Scene scene;
  scene.sun = {kPi / 2, radians(40)};
  scene.light.sun = {{.toward = unit_vector(scene.sun)}};
  const auto frame = [&](const Value::Object& parameters) {
    GraphBuilder builder(builtin_components());
    builder.component("view", "camera").component("leaf", "leaf", parameters).link("view", "leaf");
    return organs_of(builder.grow(0, scene), "leaf").at(0).frame;
  };
  const auto angle = [](Vec3 a, Vec3 b) { return degrees(std::acos(glm::dot(glm::normalize(a), glm::normalize(b)))); };
  const Vec3 light = unit_vector(scene.sun);
  const double whole = angle(frame({}).upper(), light);
  EXPECT_NEAR(angle(frame({{"phototropism", 0.25}}).upper(), light), 0.75 * whole, 0.05);
  EXPECT_NEAR(angle(frame({{"phototropism", 1}}).upper(), light), 0, 0.05);
  EXPECT_NEAR(angle(frame({{"phototropism", -1}}).upper(), -light), 0, 0.05);
  EXPECT_NEAR(angle(frame({{"gravitropism", 0.5}}).heading(), -kUp), 90, 0.05);
}

TEST(Simple, TropismsTurnItsHeadingAndWhatStandsOnIt) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("post", "simple", {{"gravitropism", 0.5}}).component("top", "simple");
  const Plant plant = builder.link("view", "post").link("post", "top").grow();
  for (const char* id : {"post", "top"}) {
    EXPECT_NEAR(organs_of(plant, id).at(0).frame.heading().y, 0, 1e-6F) << id;
  }
}

TEST(Leaf, ShapesAreRoundedToPowersThatAreLookedUpOrNot) {
  for (int k = -400; k <= 400; ++k) {
    EXPECT_EQ(power_of_2(k / 8.0), math::pow(2, k / 8.0)) << k;
    EXPECT_EQ(power_of_2(k / 7.0), math::pow(2, k / 7.0)) << k;
  }
}

}  // namespace meristem::leaf_test
