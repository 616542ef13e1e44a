// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/random.h"
#include "meristem/scene/crown/combined_crown.h"
#include "meristem/scene/crown/mesh_crown.h"
#include "meristem/scene/crown/placed_crown.h"
#include "meristem/scene/crown/profile_crown.h"
#include "meristem/scene/crown/solid_crowns.h"

namespace meristem::crown_distance_test {

Vec3 random_point(std::uint64_t k) {
  const RandomKey key(k);
  return Vec3(key.uniform(0, -3, 3), key.uniform(1, -3, 3), key.uniform(2, -3, 3));
}

/// Checks that the distance is negative inside and that no point on the other side is nearer than the distance.
void check_distance(const Crown& crown, double slack) {
  for (std::uint64_t k = 0; k < 500; ++k) {
    const Vec3 point = random_point(k);
    const double distance = crown.distance(point);
    if (std::abs(distance) > 1e-4) {
      EXPECT_EQ(crown.contains(point), distance < 0) << k;
    }
    for (std::uint64_t way = 0; way < 20; ++way) {
      const Vec3 direction = RandomKey(k).child("way").direction(way);
      const auto near = static_cast<float>((1 - slack) * std::abs(distance) - 1e-4);
      if (near <= 0) continue;
      EXPECT_EQ(crown.contains(point + near * direction), crown.contains(point)) << k;
    }
  }
}

TEST(CrownDistance, OfBodiesWithPlanesAndCones) {
  check_distance(BoxCrown(Box{{-1, -0.5F, -2}, {1, 2, 0.5F}}), 0);
  check_distance(ConeCrown({0.2F, -1, 0}, 1.2, 2.5), 0);
  check_distance(CylinderCrown({0.2F, -1, 0}, 1.2, 2.5), 0);
  check_distance(PyramidCrown({0.2F, -1, 0}, 2.2, 2.5), 0);
  check_distance(HalfSpaceCrown({0, 0.5F, 0}, {0.3F, 2, 0}), 0);
  EXPECT_DOUBLE_EQ(BoxCrown(Box{{0, 0, 0}, {2, 2, 2}}).distance({5, 6, 1}), 5);
  EXPECT_DOUBLE_EQ(BoxCrown(Box{{0, 0, 0}, {2, 2, 2}}).distance({1, 1.5F, 1}), -0.5);
}

TEST(CrownDistance, OfBallsIsExactAndOfEllipsoidsNearTheSurface) {
  check_distance(EllipsoidCrown({0, 0.5F, 0}, Vec3(1.5)), 0);
  EXPECT_NEAR(EllipsoidCrown({0, 0, 0}, Vec3(1.5)).distance({0, 0, 4}), 2.5, 1e-6);
  const EllipsoidCrown flat({0, 0, 0}, {2, 1, 1});
  EXPECT_NEAR(flat.distance({2.01F, 0, 0}), 0.01, 1e-3);
  EXPECT_NEAR(flat.distance({0, 0.99F, 0}), -0.01, 1e-3);
}

TEST(CrownDistance, OfATorusIsExactAndItHasAHole) {
  const TorusCrown ring({0.2F, 0.5F, 0}, 1.5, 0.6);
  check_distance(ring, 0);
  EXPECT_NEAR(ring.distance({0.2F, 0.5F, 0}), 0.9, 1e-6);
  EXPECT_NEAR(ring.distance({1.7F, 0.5F, 0}), -0.6, 1e-6);
  EXPECT_FALSE(ring.is_convex());
  EXPECT_NEAR(ring.bounds().high.x, 2.3F, 1e-5);
  EXPECT_NEAR(ring.bounds().low.y, -0.1F, 1e-5);
}

TEST(CrownDistance, OfProfilesFromTheirOutline) {
  const ProfileCrown crown({{0, -1}, {1.2F, 0}, {1.5F, 0.8F}, {0, 2}});
  check_distance(crown, 0.02);
}

TEST(CrownDistance, OfMeshesCombinationsAndTurnedBodies) {
  const auto mesh = std::make_shared<const ClosedMesh>(box_mesh({-1, -1, -1}, {1, 1, 1}));
  const MeshCrown cube(mesh, DFrame{});
  check_distance(cube, 0);
  EXPECT_NEAR(cube.distance({3, 0, 0}), 2, 1e-6);
  const auto ball = std::make_shared<EllipsoidCrown>(Vec3(0.5F, 0, 0), Vec3(1));
  const auto box = std::make_shared<BoxCrown>(Box{{-1, -1, -1}, {0.4F, 1, 1}});
  for (const CombineKind kind : {CombineKind::unite, CombineKind::intersect, CombineKind::subtract}) {
    check_distance(CombinedCrown(kind, {ball, box}), 0);
  }
  check_distance(PlacedCrown(box, Frame{1.5F * rotation({0, 0, 1}, 0.7), {0.2F, 0.1F, 0}}), 0);
}

/// A crown that implements only the required functions.
class Unknown : public Crown {
 public:
  bool contains(Vec3 point) const override { return ball_.contains(point); }
  Box bounds() const override { return ball_.bounds(); }

 private:
  EllipsoidCrown ball_{{0.5F, 0, 0}, Vec3(1.25)};
};

TEST(CrownDistance, OfOtherBodiesTowardTheirMiddle) {
  EXPECT_NEAR(Unknown().distance({2.5F, 0, 0}), 0.75, 1e-5);
  EXPECT_NEAR(Unknown().distance({0.5F, 1, 0}), -0.25, 1e-5);
  EXPECT_NEAR(Unknown().distance({0.5F, 0, 0}), -1.25, 1e-5);
}

}  // namespace meristem::crown_distance_test
