// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/implicit/plant_body.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "meristem/base/random.h"
#include "meristem/shape/implicit/isosurface.h"
#include "tests/support/body_plants.h"
#include "tests/support/check_mesh.h"
#include "tests/support/check_skeleton.h"

namespace meristem::plant_body_test {

std::vector<AxisIndex> all_axes(const Skeleton& skeleton) {
  std::vector<AxisIndex> axes(SkeletonAxes(skeleton).count());
  std::iota(axes.begin(), axes.end(), 0);
  return axes;
}

Mesh surface_of(const ImplicitBody& body, int resolution) {
  Progress progress;
  return extract_isosurface(body, {.resolution = resolution}, {}, "", progress);
}

Box box_of(const Mesh& mesh) {
  Box box;
  for (const Vec3 position : mesh.positions) box.add(position);
  return box;
}

ImplicitBody stem_body(const Skeleton& skeleton, const SurfaceOptions& surface = {}, double min_radius = 0) {
  return make_stem_body(skeleton, all_axes(skeleton), surface, min_radius);
}

/// Returns a capsule among cells of 1 m, in any direction, near an axis, or near a diagonal.
ImplicitBody thin_tube(const RandomKey& key, std::uint64_t k, double radius) {
  const DVec3 from(key.uniform(0), key.uniform(1), key.uniform(2));
  DVec3 along(key.direction(3));
  if (k % 3 == 1) along = glm::round(1.2 * along) + 0.02 * DVec3(key.direction(4));
  if (k % 3 == 2) along = glm::round(along) + 0.2 * key.uniform(5) * DVec3(key.direction(6));
  return ImplicitBody::capsule(from, from + key.uniform(7, 0, 15) * glm::normalize(along), radius);
}

TEST(PlantBody, IsosurfaceHoldsThinTubes) {
  // The minimum radii of bodies with cells of 1 m.
  Skeleton rod = chain({{0, 0, 0}, {0, 100, 0}}, 0.01F);
  const double min =
      find_thickening(rod, all_axes(rod), {.flare = 0}).min_radius /
      cell_size(stem_body(rod, {.flare = 0}, find_thickening(rod, all_axes(rod), {.flare = 0}).min_radius), 100);
  EXPECT_GE(min, std::sqrt(0.75));
  EXPECT_LT(min, 0.9);
  const RandomKey key(51);
  for (std::uint64_t k = 0; k < 300; ++k) {
    const ImplicitBody tube = thin_tube(key.child(k), k, min);
    SampledField field{.origin = glm::floor(tube.low()) - 1.0};
    field.size = glm::ivec3(tube.high() - field.origin) + 2;
    for (int z = 0; z < field.size.z; ++z) {
      for (int y = 0; y < field.size.y; ++y) {
        for (int x = 0; x < field.size.x; ++x) {
          field.values.push_back(static_cast<float>(tube.value(field.origin + DVec3(x, y, z))));
        }
      }
    }
    Progress progress;
    const Mesh mesh = extract_isosurface(field, 0, {}, "", progress);
    EXPECT_TRUE(check_mesh(mesh)) << k;
    EXPECT_EQ(euler_number(mesh), 2) << k;
    EXPECT_EQ(component_count(mesh), 1U) << k;
  }
}

TEST(PlantBody, ThickeningIsThatOfCylinders) {
  const Skeleton rod = chain({{0, 0, 0}, {0, 4, 0}, {0, 10, 0}}, 0.01F);
  SurfaceOptions surface{.flare = 0, .resolution = 50};
  const BodyThickening found = find_thickening(rod, all_axes(rod), surface);
  // The assumed cells equal the cells of the resulting body.
  const double cell = cell_size(stem_body(rod, {.flare = 0}, found.min_radius), 50);
  EXPECT_NEAR(found.min_radius / cell, 0.867, 0.02);  // its base is flat, unlike the round other end
  EXPECT_GE(found.min_radius / cell, 0.867);
  EXPECT_NEAR(found.length, 10, 1e-6);
  EXPECT_NEAR(found.thickened, 10, 1e-6);
  EXPECT_NEAR(found.volume, kPi * 10 * 1e-4, 1e-8);
  EXPECT_NEAR(found.added, kPi * 10 * (found.min_radius * found.min_radius - 1e-4), 1e-6);
  surface.thicken = false;
  const BodyThickening none = find_thickening(rod, all_axes(rod), surface);
  EXPECT_EQ(none.min_radius, 0);
  EXPECT_EQ(none.thickened, 0);
  EXPECT_EQ(none.added, 0);
}

TEST(PlantBody, OnlyThinSegmentsAreThickened) {
  Skeleton stick = chain({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}}, 0.3F);
  stick.radius[2] = 0.001F;
  const SurfaceOptions surface{.flare = 0, .resolution = 20};
  const BodyThickening found = find_thickening(stick, all_axes(stick), surface);
  EXPECT_NEAR(found.thickened, 1, 1e-6);
  const auto cone = [](double a, double b) { return kPi / 3 * (a * a + a * b + b * b); };
  EXPECT_NEAR(found.volume, cone(0.3, 0.3) + cone(0.3, 0.001), 1e-6);
  EXPECT_NEAR(found.added, cone(0.3, found.min_radius) - cone(0.3, 0.001), 1e-6);
}

TEST(PlantBody, WideBasesCountForTheCells) {
  // A body wider than high, whose base is twice as wide.
  const Skeleton stump = chain({{0, 0, 0}, {0, 0.4F, 0}}, 0.5F);
  const SurfaceOptions surface{.flare = 1, .resolution = 20};
  const BodyThickening found = find_thickening(stump, all_axes(stump), surface);
  EXPECT_GE(found.min_radius / cell_size(stem_body(stump, surface, found.min_radius), 20), std::sqrt(0.75));
}

TEST(PlantBody, OfAForkIsOneClosedPiece) {
  const Skeleton skeleton = forked();
  ASSERT_TRUE(check_skeleton(skeleton));
  for (const float blend : {0.0F, 0.5F, 4.0F}) {
    for (const int resolution : {10, 40, 100}) {
      SurfaceOptions surface{.resolution = resolution, .blend = blend};
      const double min = find_thickening(skeleton, all_axes(skeleton), surface).min_radius;
      const Mesh mesh = surface_of(stem_body(skeleton, surface, min), resolution);
      EXPECT_TRUE(check_mesh(mesh)) << blend << " at " << resolution;
      EXPECT_EQ(euler_number(mesh), 2) << blend << " at " << resolution;
      EXPECT_EQ(component_count(mesh), 1U) << blend << " at " << resolution;
    }
  }
}

TEST(PlantBody, BlendsFillForksAndNoMore) {
  const Skeleton skeleton = forked();
  const auto volume = [&](float blend) {
    return signed_volume(surface_of(stem_body(skeleton, {.flare = 0, .blend = blend}), 100));
  };
  EXPECT_GT(volume(0.5F), 1.0005 * volume(0));
  EXPECT_GT(volume(2), 1.005 * volume(0));
  EXPECT_LT(volume(2), 1.3 * volume(0));
}

TEST(PlantBody, StandsFlatOnItsBase) {
  Skeleton skeleton = forked();
  for (Vec3& position : skeleton.position) position.y += 5;
  const ImplicitBody body = stem_body(skeleton);
  const Mesh mesh = surface_of(body, 80);
  EXPECT_NEAR(box_of(mesh).low.y, 5, cell_size(body, 80));
  // The surface also crosses the body's base in a straight line.
  for (const double x : {0.0, 0.05, 0.1}) EXPECT_NEAR(body.value({x, 5, 0}), 0, 1e-6) << x;
}

TEST(PlantBody, FlareWidensTheBaseAlone) {
  const Skeleton pole = chain({{0, 0, 0}, {0, 5, 0}}, 0.1F);
  const auto width = [&](float flare, double height) {
    const ImplicitBody body = stem_body(pole, {.flare = flare});
    double x = 0;
    while (body.value({x, height, 0}) < 0) x += 1e-4;
    return x;
  };
  EXPECT_NEAR(width(0, 0.001), 0.1, 1e-3);
  EXPECT_NEAR(width(0.5F, 0.001), 0.15, 2e-3);
  EXPECT_NEAR(width(1, 0.001), 0.2, 4e-3);
  EXPECT_NEAR(width(1, 4), 0.1, 1e-3);
}

TEST(PlantBody, DoesNotSwellAtTheNodesOfAnAxis) {
  const Vec3 along = glm::normalize(Vec3(1, 3, 2));
  std::vector<Vec3> places;
  for (int k = 0; k <= 40; ++k) places.push_back(0.05F * static_cast<float>(k) * along);
  const ImplicitBody body = stem_body(chain(places, 0.1F), {.flare = 0, .blend = 4});
  const DVec3 aside = DVec3(any_perpendicular(along));
  for (int k = 10; k < 190; ++k) {
    EXPECT_NEAR(body.value(0.01 * k * DVec3(along) + 0.1 * aside), 0, 1e-5) << k;
  }
  EXPECT_EQ(body.reach(), 0);
}

TEST(PlantBody, LateralsBeginWithTheirOwnRadius) {
  const ImplicitBody body = stem_body(forked(), {.flare = 0, .blend = 0});
  // The thin lateral at the trunk's node does not widen the trunk.
  EXPECT_NEAR(body.value({0, 0.5, 0.1}), 0, 1e-6);
  EXPECT_NEAR(body.value({0.25, 1.25, 0.04}), 0, 1e-3);
}

TEST(PlantBody, TheOrderOfAxesDoesNotMatter) {
  const Skeleton skeleton = forked();
  const ImplicitBody body = make_stem_body(skeleton, std::vector<AxisIndex>{0, 1, 2}, {}, 0);
  const ImplicitBody other = make_stem_body(skeleton, std::vector<AxisIndex>{2, 0, 1}, {}, 0);
  EXPECT_EQ(surface_of(body, 40).positions, surface_of(other, 40).positions);
  const ImplicitBody part = make_stem_body(skeleton, std::vector<AxisIndex>{1}, {}, 0);
  EXPECT_GT(part.value({0, 0.3, 0}), 0.5);
  EXPECT_LT(part.value({0.25, 1.25, 0}), 0);
}

TEST(PlantBody, OfNothingIsEmpty) {
  EXPECT_TRUE(stem_body(Skeleton()).is_empty());
  EXPECT_TRUE(stem_body(chain({{0, 0, 0}}, 0.1F)).is_empty());
  EXPECT_TRUE(stem_body(chain({{0, 0, 0}, {0, 1, 0}}, 0)).is_empty());
  EXPECT_FALSE(stem_body(chain({{0, 0, 0}, {0, 1, 0}}, 0), {}, 0.01).is_empty());
  EXPECT_TRUE(make_crown_body(Skeleton(), {}, {}).is_empty());
  EXPECT_EQ(find_thickening(Skeleton(), {}, {}).length, 0);
}

TEST(PlantBody, BranchEndsAreTipsOrTheColumnEnd) {
  Skeleton skeleton = forked();
  const auto ends = [&] { return branch_ends(skeleton, all_axes(skeleton)); };
  EXPECT_EQ(ends(), (std::vector<NodeIndex>{2, 4, 5}));
  EXPECT_EQ(branch_ends(skeleton, std::vector<AxisIndex>{1}), (std::vector<NodeIndex>{4}));
  skeleton.extra["end"] = std::vector<float>(6, 0);
  EXPECT_EQ(ends(), (std::vector<NodeIndex>{2, 4, 5}));
  skeleton.extra["end"][1] = 1;
  skeleton.extra["end"][5] = 1;
  EXPECT_EQ(ends(), (std::vector<NodeIndex>{1, 5}));
}

TEST(PlantBody, CrownsAreBallsAboveTheEnds) {
  const Skeleton skeleton = forked();
  const CrownBody crown{.diameter = 0.6F, .offset = 0.25F, .fuse = 0};
  const ImplicitBody body = make_crown_body(skeleton, all_axes(skeleton), crown);
  const RandomKey key(52);
  for (std::uint64_t k = 0; k < 100; ++k) {
    const DVec3 point = 2.0 * DVec3(key.direction(k)) + DVec3(0, 1, 0);
    double nearest = 1e9;
    for (const NodeIndex end : {2, 4, 5}) {
      nearest = std::min(nearest, glm::distance(point, DVec3(skeleton.position[end]) + DVec3(0, 0.25, 0)) - 0.3);
    }
    EXPECT_NEAR(body.value(point), nearest, 1e-6);
  }
  for (const BlendKind kind : {BlendKind::poly, BlendKind::root, BlendKind::pasko}) {
    CrownBody fused = crown;
    fused.fuse = 0.5F;
    fused.blend = kind;
    const Mesh mesh = surface_of(make_crown_body(skeleton, all_axes(skeleton), fused), 30);
    EXPECT_TRUE(check_mesh(mesh));
    EXPECT_GT(signed_volume(mesh), 1.02 * signed_volume(surface_of(body, 30)));
  }
}

}  // namespace meristem::plant_body_test
