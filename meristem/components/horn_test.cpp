// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/horn.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"
#include "tests/support/check_mesh.h"
#include "tests/support/check_skeleton.h"

namespace meristem::horn_test {

GraphBuilder one(const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  return builder.component("view", "camera").component("horn", "horn", parameters).link("view", "horn");
}

Value square() {
  Value::List list;
  for (const auto& [x, z] : {std::pair(1, 1), std::pair(1, -1), std::pair(-1, -1), std::pair(-1, 1)}) {
    list.emplace_back(Value::List{x, z});
  }
  return list;
}

Value even_taper(double tip) {
  return Value::Object{{"curve", Value::List{Value::List{0, 1}, Value::List{1, tip}}}, {"kind", "linear"}};
}

// Returns the frames of boxes on the ribs.
std::vector<Frame> rib_frames(const Value::Object& parameters, const Value::Object& placement = {}) {
  auto builder = one(parameters);
  builder.component("box", "simple", {{"size", Value::List{0.01, 0.01, 0.01}}});
  const Plant plant = builder.link("horn", "box", LinkKind::branch, placement).grow();
  std::vector<Frame> frames;
  for (const Organ& organ : organs_of(plant, "box")) {
    Frame frame = organ.frame;
    frame.axes *= 100;
    frames.push_back(frame);
  }
  return frames;
}

TEST(Horn, RibsStandEvenlyFromBaseToTip) {
  const auto frames = rib_frames({{"length", 2}, {"ribs", 5}, {"segments", 7}});
  ASSERT_EQ(frames.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_LT(glm::distance(frames[k].origin, Vec3(0, 0.5F * static_cast<float>(k), 0)), 1e-5F);
    EXPECT_LT(glm::distance(frames[k].heading(), kUp), 1e-5F);
  }
  EXPECT_EQ(rib_frames({{"ribs", 1}}).at(0).origin, Vec3(0));
}

TEST(Horn, TwistTurnsTheRibs) {
  const auto frames = rib_frames({{"ribs", 4}, {"twist", 90}});
  ASSERT_EQ(frames.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 upper = rotation(kUp, radians(30) * static_cast<double>(k)) * Vec3(0, 0, 1);
    EXPECT_LT(glm::distance(frames[k].upper(), upper), 1e-5F) << k;
  }
}

TEST(Horn, PlacementKeysPlaceChildrenAlongItInstead) {
  EXPECT_EQ(rib_frames({{"ribs", 4}}, {{"count", 17}}).size(), 17U);
  for (const Frame& frame : rib_frames({{"ribs", 4}, {"section", "sphere"}, {"radius", 0.3}}, {{"density", 40}})) {
    EXPECT_GT(glm::length(Vec3(frame.origin.x, 0, frame.origin.z)), 0.04F);
  }
}

// A curl whose direction rotates gives a helix: all ribs have equal distance from one axis.
TEST(Horn, ASpiralIsAHelix) {
  const auto frames = rib_frames({{"length", 10}, {"segments", 400}, {"ribs", 60}, {"curl", 1500}, {"spiral", 2000}});
  ASSERT_EQ(frames.size(), 60U);
  // The rotation from rib to rib is constant; its axis is the direction of the helix.
  const Mat3 turn = frames[31].axes * glm::transpose(frames[30].axes);
  const Vec3 axis = glm::normalize(Vec3(turn[1][2] - turn[2][1], turn[2][0] - turn[0][2], turn[0][1] - turn[1][0]));
  const auto flat = [&](Vec3 position) { return position - glm::dot(position, axis) * axis; };
  // The centre is the intersection of the perpendicular bisectors of three points.
  const Vec3 a = flat(frames[10].origin), b = flat(frames[13].origin), c = flat(frames[17].origin);
  const Vec3 ab = b - a, ac = c - a, normal = glm::cross(ab, ac);
  const Vec3 centre = a + (glm::dot(ac, ac) * glm::cross(normal, ab) + glm::dot(ab, ab) * glm::cross(ac, normal)) /
                              (2 * glm::dot(normal, normal));
  const float radius = glm::distance(a, centre);
  EXPECT_GT(radius, 0.1F);
  for (std::size_t k = 1; k < 59; ++k) {
    EXPECT_NEAR(glm::distance(flat(frames[k].origin), centre), radius, 0.02F * radius) << k;
  }
}

TEST(Horn, ARingIsAStem) {
  const Plant plant = one({{"length", 3}, {"radius", 0.1}, {"segments", 6}, {"curl", 40}}).grow();
  ASSERT_EQ(plant.stems.size(), 1U);
  check_skeleton(plant.stems[0].skeleton);
  EXPECT_EQ(plant.stems[0].skeleton.node_count(), 7U);
  EXPECT_TRUE(plant.organs.empty());
}

TEST(Horn, StemsOnTheRibsOfARingJoinIt) {
  auto builder = one({{"ribs", 3}, {"radius", 0.05}, {"taper", even_taper(1)}});
  builder.component("side", "tree",
                    {{"length", 0.5}, {"segments", 2}, {"frame", Value::Object{{"rotate", Value::List{90, 0, 0}}}}});
  const Plant plant = builder.link("horn", "side", LinkKind::branch).grow();
  ASSERT_EQ(plant.stems.size(), 1U);
  const std::vector<AxisIndex>& axis = plant.stems[0].skeleton.axis;
  EXPECT_EQ(*std::max_element(axis.begin(), axis.end()), 3U);
}

TEST(Horn, AnOutlineIsAClosedPrism) {
  const Plant plant =
      one({{"section", "outline"}, {"outline", square()}, {"length", 2}, {"radius", 0.25}, {"taper", even_taper(1)}})
          .grow();
  EXPECT_TRUE(plant.stems.empty());
  ASSERT_EQ(plant.organs.size(), 1U);
  const Mesh& mesh = *plant.prototypes.at(0).mesh;
  EXPECT_TRUE(check_mesh(mesh));
  EXPECT_EQ(euler_number(mesh), 2);
  const double scale = plant.organs[0].frame.axes[1][1];
  EXPECT_NEAR(signed_volume(mesh) * scale * scale * scale, 0.5, 1e-4);
}

TEST(Horn, AnOutlineThatTapersToNothingIsAPyramidHoweverItIsTwisted) {
  const Value::Object form{
      {"section", "outline"}, {"outline", square()}, {"length", 3}, {"radius", 0.5}, {"segments", 1}};
  auto pointed = form;
  pointed.emplace_back("taper", even_taper(0));
  const Plant plant = one(pointed).grow();
  const Mesh& mesh = *plant.prototypes.at(0).mesh;
  EXPECT_TRUE(check_mesh(mesh));
  EXPECT_NEAR(signed_volume(mesh) * 27, 1, 0.02);  // radii are rounded, so that meshes can be shared
  auto twisted = form;
  twisted.insert(twisted.end(), {{"twist", 400}, {"curl", 200}, {"taper", even_taper(0)}});
  twisted[4].second = 120;
  EXPECT_TRUE(check_mesh(*one(twisted).grow().prototypes.at(0).mesh));
}

// A line of two points is a strip, twice the radius wide.
TEST(Horn, ALineIsASheetSeenFromBothSides) {
  const Value ends = Value::List{Value(Value::List{-1, 0}), Value(Value::List{1, 0})};
  const Plant plant =
      one({{"section", "line"}, {"outline", ends}, {"length", 2}, {"radius", 0.25}, {"taper", even_taper(1)}}).grow();
  ASSERT_EQ(plant.organs.size(), 1U);
  EXPECT_TRUE(plant.materials.at(0).two_sided);
  const Mesh& mesh = *plant.prototypes.at(0).mesh;
  const double scale = plant.organs[0].frame.axes[1][1];
  EXPECT_NEAR(surface_area(mesh) * scale * scale, 2 * 0.5, 1e-4);
}

TEST(Horn, AreasFillTheOutlineOnEachRib) {
  const Plant plant = one({{"section", "area"},
                           {"outline", square()},
                           {"ribs", 3},
                           {"length", 2},
                           {"radius", 0.2},
                           {"taper", even_taper(0.5)}})
                          .grow();
  ASSERT_EQ(plant.organs.size(), 3U);
  EXPECT_TRUE(plant.materials.at(0).two_sided);
  EXPECT_EQ(plant.prototypes.size(), 1U) << "they share a mesh";
  EXPECT_NEAR(surface_area(*plant.prototypes[0].mesh), 4, 1e-5);
  for (int k = 0; k < 3; ++k) {
    const Frame& frame = plant.organs[static_cast<std::size_t>(k)].frame;
    EXPECT_LT(glm::distance(frame.origin, Vec3(0, k, 0)), 1e-5F);
    EXPECT_NEAR(glm::length(frame.axes[0]), 0.2 * (1 - 0.25 * k), 1e-5);
  }
}

TEST(Horn, OutlinesShareTheirMeshWhereNothingDiffers) {
  const auto prototypes = [](const Value::Object& more) {
    Value::Object parameters{{"section", "outline"}, {"outline", square()}, {"curl", 50}};
    parameters.emplace_back("frame", Value::Object{{"scale", Value::List{"1 + i", "1 + i", "1 + i"}}});
    parameters.insert(parameters.end(), more.begin(), more.end());
    GraphBuilder builder(builtin_components());
    builder.component("view", "camera").component("star", "hydra", {{"number", 10}, {"angle", 40}});
    const Plant plant = builder.component("horn", "horn", parameters).link("view", "star").link("star", "horn").grow();
    EXPECT_EQ(plant.organs.size(), 10U);
    return plant.prototypes.size();
  };
  EXPECT_EQ(prototypes({}), 1U);
  EXPECT_EQ(prototypes({{"gnarl", 10}}), 10U);
  EXPECT_EQ(prototypes({{"gravitropism", 0.3}}), 10U);
}

// The mesh ends at the site of child links, for every bend of the curve.
TEST(Horn, TheOutlineEndsAtTheTip) {
  for (const Value::Object& bend :
       {Value::Object{{"curl", 70}, {"spiral", 100}},
        {{"gnarl", 30}},
        {{"gravitropism", 0.6}, {"frame", Value::Object{{"rotate", Value::List{70, 20, 10}}}}}}) {
    Value::Object parameters{{"section", "outline"}, {"outline", square()}, {"taper", even_taper(0)}, {"length", 2}};
    parameters.insert(parameters.end(), bend.begin(), bend.end());
    const Plant plant = one(parameters).component("tip", "simple").link("horn", "tip").grow();
    const Organ organ = organs_of(plant, "horn").at(0);
    const Vec3 tip = organs_of(plant, "tip").at(0).frame.origin;
    const Mesh& mesh = *plant.prototypes[organ.prototype].mesh;
    float nearest = 1e9F;
    for (const Vec3 position : mesh.positions)
      nearest = std::min(nearest, glm::distance(organ.frame.point(position), tip));
    EXPECT_LT(nearest, 1e-5F);
  }
}

TEST(Horn, PrimitivesStandOnTheRibsAsThickAsTheCurve) {
  for (const char* shape : {"box", "sphere", "cylinder", "cone", "torus"}) {
    const Plant plant =
        one({{"section", shape}, {"ribs", 3}, {"length", 2}, {"radius", 0.2}, {"taper", even_taper(0.5)}}).grow();
    ASSERT_EQ(plant.organs.size(), 3U) << shape;
    EXPECT_EQ(plant.prototypes.size(), 1U);
    for (int k = 0; k < 3; ++k) {
      Box box;
      const Organ& organ = plant.organs[static_cast<std::size_t>(k)];
      for (const Vec3 position : plant.prototypes[0].mesh->positions) box.add(organ.frame.point(position));
      EXPECT_NEAR(box.size().x, 2 * 0.2 * (1 - 0.25 * k), 0.01) << shape;
      EXPECT_LT(glm::distance(box.centre(), Vec3(0, k, 0)), 0.01F) << shape;
    }
  }
}

TEST(Horn, FaultsAreLocated) {
  const auto path_of = [](const Value::Object& parameters) {
    const auto errors = errors_of([&] { one(parameters); });
    return errors.size() == 1 ? errors[0].path : "not one fault";
  };
  EXPECT_EQ(path_of({{"section", "outline"}}), "components.horn.outline");
  EXPECT_EQ(path_of({{"section", "outline"}, {"outline", Value::List{Value(Value::List{0, 0})}}}),
            "components.horn.outline");
  EXPECT_EQ(path_of({{"outline", square()}}), "components.horn.outline");
  EXPECT_EQ(path_of({{"axis", Value::List{Value::List{0, 1, 0}, Value::List{0, 1, 0}}}}), "components.horn.axis[1]");
  EXPECT_EQ(path_of({{"ribs", 0}}), "components.horn.ribs");
  EXPECT_EQ(path_of({{"section", "area"}}), "components.horn.outline");
  EXPECT_EQ(path_of({{"section", "line"}, {"outline", Value::List{Value(Value::List{0, 0})}}}),
            "components.horn.outline");
  EXPECT_EQ(errors_of([] { one({{"section", "bix"}}); }).at(0).nearest, "box");
}

TEST(Horn, HasTheSameBytesOnAnyNumberOfThreads) {
  const auto hash = [](int threads) {
    const ThreadLimit limit(threads);
    auto builder =
        one({{"section", "outline"}, {"outline", square()}, {"length", "rand(1, 4)"}, {"curl", "20 * (i % 7)"}});
    for (int k = 0; k < 600; ++k) builder.link("view", "horn");
    return hash_of(builder.grow());
  };
  const std::string one_thread = hash(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(hash(threads), one_thread);
}

}  // namespace meristem::horn_test
