// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/solid/revolution.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "meristem/base/random.h"
#include "tests/support/check_mesh.h"

namespace meristem::revolution_test {

using Silhouette = std::vector<Vec2>;

const Silhouette kCone{{0, 0}, {0.5F, 0}, {0, 2}};
/// An outer cylinder of radius 2 and height 3 with an inner one of radius 1 down to height 1.
const Silhouette kCup{{0, 0}, {2, 0}, {2, 3}, {1, 3}, {1, 1}, {0, 1}};

SolidOfRevolution lines(Silhouette silhouette, int segments = 24) {
  return {.silhouette = std::move(silhouette), .kind = CurveKind::linear, .segments = segments};
}

/// Returns the area of a regular polygon as a share of the circle around it.
double share_of_circle(int corners) { return corners * std::sin(2 * kPi / corners) / (2 * kPi); }

Silhouette half_circle(int points) {
  Silhouette circle;
  for (int k = 0; k < points; ++k) {
    const double angle = kPi * k / (points - 1);
    circle.emplace_back(k == 0 || k + 1 == points ? 0 : std::sin(angle), -std::cos(angle));
  }
  return circle;
}

TEST(Revolution, ConesAndCupsHaveTheVolumeOfTheirSilhouette) {
  for (const int n : {3, 4, 7, 48}) {
    const Mesh cone = make_revolution(lines(kCone, n));
    EXPECT_TRUE(check_mesh(cone));
    EXPECT_NEAR(signed_volume(cone), share_of_circle(n) * kPi * 0.25 * 2 / 3, 1e-6);
    const Mesh cup = make_revolution(lines(kCup, n));
    EXPECT_TRUE(check_mesh(cup));
    EXPECT_EQ(euler_number(cup), 2);
    EXPECT_NEAR(signed_volume(cup), share_of_circle(n) * kPi * (4 * 3 - 1 * 2), 1e-5);
  }
}

TEST(Revolution, OpenEndsGetFlatDiscs) {
  const Mesh prism = make_revolution(lines({{1, 0}, {1, 2}}, 6));
  EXPECT_TRUE(check_mesh(prism));
  EXPECT_NEAR(signed_volume(prism), share_of_circle(6) * kPi * 2, 1e-6);
  // The mesh equals the mesh of lines with explicit discs.
  const Mesh written = make_revolution(lines({{0, 0}, {1, 0}, {1, 2}, {0, 2}}, 6));
  EXPECT_EQ(prism.positions, written.positions);
  EXPECT_EQ(prism.triangles, written.triangles);
}

TEST(Revolution, ALineOffTheAxisHasPappusVolume) {
  // A ridge around a thin core: a triangle whose centroid is 5 from the axis, and the core's cylinder.
  const Mesh ridge = make_revolution(lines({{4, 0}, {7, 1}, {4, 2}}, 128));
  EXPECT_TRUE(check_mesh(ridge));
  const double pappus = 2 * kPi * 5 * 3;
  EXPECT_NEAR(signed_volume(ridge), share_of_circle(128) * (pappus + kPi * 16 * 2), 1e-3);
}

TEST(Revolution, ASplineThroughACircleIsNearlyASphere) {
  const SolidOfRevolution ball{.silhouette = half_circle(17), .segments = 96, .rings = 96};
  const Mesh mesh = make_revolution(ball);
  EXPECT_TRUE(check_mesh(mesh));
  EXPECT_NEAR(signed_volume(mesh), 4.0 / 3 * kPi, 0.01);
  EXPECT_NEAR(surface_area(mesh), 4 * kPi, 0.02);
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    EXPECT_NEAR(glm::length(mesh.positions[i]), 1, 2e-3);
    EXPECT_GT(glm::dot(mesh.normals[i], glm::normalize(mesh.positions[i])), std::cos(radians(3)));
  }
}

TEST(Revolution, RingsStandWhereASplineBends) {
  // Straight except for its upper end.
  const Silhouette flask{{1, 0}, {1, 4}, {1, 8}, {0.5F, 9}, {0, 9}};
  const auto error = [&](int rings) {
    const auto volume = [&](int of) { return signed_volume(make_revolution({.silhouette = flask, .rings = of})); };
    return std::abs(volume(rings) - volume(512));
  };
  EXPECT_LT(error(16), error(8));
  EXPECT_LT(error(32), error(8) / 8);
}

TEST(Revolution, BendsBelowFortyDegreesAreSmoothAndOthersSharp) {
  const auto vertices = [](double degrees) {
    const double bend = radians(degrees);
    return make_revolution(
               lines({{1, 0},
                      {1, 1},
                      {static_cast<float>(1 - 0.5 * std::sin(bend)), static_cast<float>(1 + 0.5 * std::cos(bend))}},
                     8))
        .vertex_count();
  };
  EXPECT_EQ(vertices(41), vertices(39) + 9);
}

TEST(Revolution, VolumesOfWedgesAreProportionalToTheirSweep) {
  for (const Silhouette& silhouette : {kCone, kCup, half_circle(9)}) {
    SolidOfRevolution solid = lines(silhouette, 24);
    const double whole = signed_volume(make_revolution(solid));
    for (const int columns : {1, 5, 12, 19, 23}) {
      solid.sweep = 2 * kPi * columns / 24;
      const Mesh wedge = make_revolution(solid);
      EXPECT_TRUE(check_mesh(wedge));
      EXPECT_EQ(euler_number(wedge), 2);
      EXPECT_NEAR(signed_volume(wedge) / whole, columns / 24.0, 1e-5);
    }
  }
}

TEST(Revolution, SlimWedgesAndThreeCornersAreClosed) {
  for (const double sweep : {1.0, 119.0, 121.0, 359.0}) {
    SolidOfRevolution solid = lines(kCup, 3);
    solid.sweep = radians(sweep);
    EXPECT_TRUE(check_mesh(make_revolution(solid))) << sweep;
  }
}

TEST(Revolution, WedgesWithThreeCornersOnALineAreClosed) {
  SolidOfRevolution solid =
      lines({{18.11952F, 0.985915F}, {9.05976F, 7.605628F}, {18.11952F, 14.225342F}, {0, 19.85914F}});
  solid.sweep = 0.1;
  EXPECT_TRUE(check_mesh(make_revolution(solid)));
}

/// Returns a body with bumps and, half the time, a hollow inside. Every third body begins or ends in a disc.
Silhouette random_silhouette(RandomKey key) {
  Silhouette outside;
  const int points = 3 + static_cast<int>(key.uniform(0) * 12);
  for (int k = 0; k < points; ++k) {
    outside.emplace_back(key.child("radius").uniform(k, 1, 2), k + key.child("height").uniform(k, -0.3, 0.3));
  }
  if (key.uniform(1) < 0.6) outside.insert(outside.begin(), {0, outside.front().y - 0.2F});
  if (key.uniform(2) < 0.5) {
    outside.emplace_back(0.8F, outside.back().y);
    outside.emplace_back(0.5F, 0.6F);
    outside.emplace_back(0, 0.6F);
  }
  return outside;
}

TEST(Revolution, RandomSilhouettesGiveClosedBodies) {
  int splines = 0;
  for (std::uint64_t k = 0; k < 300; ++k) {
    const RandomKey key = RandomKey(7).child(k);
    SolidOfRevolution solid = lines(random_silhouette(key), 3 + static_cast<int>(key.uniform(3) * 20));
    if (key.uniform(4) < 0.5) solid.sweep = key.uniform(5, 0.1, 2 * kPi);
    solid.rings = 1 + static_cast<int>(key.uniform(6) * 60);
    ASSERT_FALSE(find_error(solid)) << find_error(solid)->message;
    EXPECT_TRUE(check_mesh(make_revolution(solid))) << k;
    solid.kind = CurveKind::spline;
    if (find_error(solid)) continue;  // the spline may cross itself
    ++splines;
    EXPECT_TRUE(check_mesh(make_revolution(solid))) << k << " as a spline";
  }
  EXPECT_GT(splines, 100);
}

TEST(Revolution, TrianglesAreCountedWithoutAMesh) {
  for (const Silhouette& silhouette : {kCone, kCup, Silhouette{{1, 0}, {1, 2}}, half_circle(9)}) {
    for (const CurveKind kind : {CurveKind::linear, CurveKind::spline}) {
      for (const double sweep : {2 * kPi, 0.3 * kPi}) {
        SolidOfRevolution solid = lines(silhouette, 7);
        solid.kind = kind;
        solid.sweep = sweep;
        if (find_error(solid)) continue;
        EXPECT_EQ(revolution_triangles(solid), make_revolution(solid).triangle_count());
      }
    }
  }
}

TEST(Revolution, UvsGoAroundAndAlongFromBaseToTip) {
  const Mesh cylinder = make_revolution(lines({{1, 0}, {1, 2}}, 4));
  for (std::size_t i = 0; i < cylinder.vertex_count(); ++i) {
    const Vec3 at = cylinder.positions[i];
    const double along = at.y == 0 ? std::hypot(at.x, at.z) : 4 - std::hypot(at.x, at.z);
    EXPECT_NEAR(cylinder.uvs[i].y, along / 4, 1e-6);
    const double turn = 2 * kPi * cylinder.uvs[i].x;
    if (at.x == 0 && at.z == 0) continue;
    EXPECT_NEAR(at.x, std::sin(turn), 1e-6);
    EXPECT_NEAR(at.z, std::cos(turn), 1e-6);
  }
}

TEST(Revolution, TwiceTheSizeGivesEightTimesTheVolume) {
  Silhouette doubled = half_circle(9);
  for (Vec2& point : doubled) point *= 2;
  EXPECT_NEAR(signed_volume(make_revolution({.silhouette = doubled})) /
                  signed_volume(make_revolution({.silhouette = half_circle(9)})),
              8, 1e-4);
}

TEST(Revolution, FaultsNameTheirPoint) {
  const auto error = [](Silhouette silhouette, CurveKind kind = CurveKind::linear) {
    const auto found = find_error({.silhouette = std::move(silhouette), .kind = kind});
    if (!found) return std::string("none");
    return found->message + (found->point ? " @" + std::to_string(*found->point) : "");
  };
  EXPECT_EQ(error({{1, 0}}), "the silhouette has fewer than two points");
  EXPECT_EQ(error(Silhouette(501, Vec2(1, 1))), "the silhouette has 501 points");
  EXPECT_EQ(error({{0, 0}, {NAN, 1}}), "the silhouette has a number that is not finite @1");
  EXPECT_EQ(error({{0, 0}, {-1, 1}, {0, 2}}), "the radius -1 is negative @1");
  EXPECT_EQ(error({{0, 0}, {0, 1}}), "all of the silhouette lies on the axis");
  EXPECT_EQ(error({{0, 0}, {1, 1}, {1, 1}, {0, 2}}), "the point repeats the one before it @2");
  EXPECT_EQ(error({{0, 0}, {1, 1}, {0, 2}, {1, 3}}), "the silhouette meets the axis before its end @2");
  const std::string crossing = "the silhouette crosses or touches itself, or a disc that closes it";
  EXPECT_EQ(error({{0, 0}, {2, 0}, {1, 2}, {1, -1}, {2, 2}, {0, 3}}), crossing);
  EXPECT_EQ(error({{0, 0}, {1, 1}, {2, 0.5F}, {2, 2}, {1, 0.5F}}), crossing);
  EXPECT_EQ(error({{0, 0}, {1, 0}, {1, 2}, {0.5F, 2}, {0, 0}}), crossing);
  EXPECT_EQ(error({{0, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1e-6F}, {0, 1}}), crossing) << "nearly";
  EXPECT_EQ(error({{0, 2}, {1, 1}, {0, 0}}), "the silhouette runs down around the body");
  EXPECT_EQ(error({{0, 0}, {2, 0}, {0.01F, 1}, {0.01F, 2}, {2, 3}, {0, 4}}, CurveKind::spline),
            "after this point the spline swings across the axis @2");
  EXPECT_EQ(error(kCup), "none");
}

TEST(Revolution, RejectsWhatMakesNoBody) {
  EXPECT_THROW(make_revolution(lines(kCone, 2)), std::invalid_argument);
  EXPECT_THROW(make_revolution(lines({{1, 0}})), std::invalid_argument);
  EXPECT_THROW(make_revolution({.rings = 0}), std::invalid_argument);
  EXPECT_THROW(make_revolution({.sweep = 0}), std::invalid_argument);
}

}  // namespace meristem::revolution_test
