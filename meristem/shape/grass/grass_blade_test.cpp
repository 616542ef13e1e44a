// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/grass/grass_blade.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "meristem/shape/grass/reduce_leaf.h"
#include "tests/support/check_mesh.h"
#include "tests/support/grass_leaves.h"

namespace meristem::grass_blade_test {

constexpr MeshPromises kOpen{.closed = false, .outward = false};

/// Returns a level leaf whose tip is a point.
GrassLeaf level(std::size_t pieces) { return with_blade(arching_leaf(pieces, kPi / 2, kPi / 2)); }

GrassLeaf arching(std::size_t pieces) { return with_blade(arching_leaf(pieces, 0.2, 2.3)); }

/// Returns the vertices from edge to edge at a point of the leaf.
std::vector<DVec3> row_of(const Mesh& mesh, std::size_t point, int across) {
  const auto columns = static_cast<std::size_t>(across) + 1;
  std::vector<DVec3> row;
  for (std::size_t c = 0; c < columns; ++c) row.emplace_back(mesh.positions[point * columns + c]);
  return row;
}

DVec3 place_of(const GrassLeaf& leaf, std::size_t point) {
  return leaf.length * DVec3(0, leaf.y[point], -leaf.x[point]);
}

double polyline(const std::vector<DVec3>& points) {
  double length = 0;
  for (std::size_t k = 1; k < points.size(); ++k) length += glm::distance(points[k - 1], points[k]);
  return length;
}

TEST(GrassBlade, AFlatLevelBladeHasTheLeafsArea) {
  for (const std::size_t pieces : {1, 2, 7, 40}) {
    GrassLeaf leaf = level(pieces);
    if (pieces == 1) leaf.r = {1, 0};
    for (const int across : {2, 6}) {
      const Mesh mesh = make_grass_blade(leaf, {.across = across});
      EXPECT_TRUE(check_mesh(mesh, kOpen));
      EXPECT_NEAR(surface_area(mesh) / area(leaf), 1, 1e-6);
    }
  }
}

TEST(GrassBlade, HasFourTrianglesAPieceAndTwoLessAtATipOfNoWidth) {
  for (const std::size_t pieces : {2, 5, 30}) {
    EXPECT_EQ(make_grass_blade(arching(pieces), {}).triangle_count(), 4 * pieces - 2);
    GrassLeaf blunt = arching(pieces);
    blunt.r.back() = 0.2;
    EXPECT_EQ(make_grass_blade(blunt, {}).triangle_count(), 4 * pieces);
    GrassLeaf pointed = arching(pieces);
    pointed.r.front() = 0;
    EXPECT_EQ(make_grass_blade(pointed, {}).triangle_count(), 4 * pieces - 4);
    EXPECT_EQ(make_grass_blade(arching(pieces), {.across = 6}).triangle_count(), 12 * pieces - 6);
  }
}

TEST(GrassBlade, TheTipIsOneTriangleASide) {
  const Mesh mesh = make_grass_blade(arching(10), {});
  const auto tip = static_cast<std::uint32_t>(mesh.vertex_count() - 1);
  EXPECT_EQ(std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                          [&](const auto& t) { return t[0] == tip || t[1] == tip || t[2] == tip; }),
            2);
  EXPECT_NEAR(glm::distance(DVec3(mesh.positions[tip]), place_of(arching(10), 10)), 0, 1e-7);
}

TEST(GrassBlade, ItsUpperFaceIsFront) {
  const Mesh flat = make_grass_blade(level(6), {});
  for (const Vec3 normal : flat.normals) EXPECT_NEAR(normal.y, 1, 1e-6);
  // An upright blade faces the stem.
  const Mesh upright = make_grass_blade(with_blade(arching_leaf(6, 0, 0)), {});
  for (const Vec3 normal : upright.normals) EXPECT_NEAR(normal.z, 1, 1e-6);
}

TEST(GrassBlade, StartsAtTheCollarAndLeadsAwayToMinusZ) {
  const GrassLeaf leaf = level(6);
  const Mesh mesh = make_grass_blade(leaf, {});
  EXPECT_EQ(mesh.positions[1], Vec3(0));
  EXPECT_LT(mesh.positions[0].x, 0);
  EXPECT_NEAR(mesh.positions.back().z, -leaf.length, 1e-7);
}

TEST(GrassBlade, PictureCoordinatesAreTheFlatBlade) {
  const GrassLeaf leaf = arching(12);
  const Mesh mesh = make_grass_blade(leaf, {.twist = 1, .fold = 0.2});
  for (std::size_t k = 0; k < 12; ++k) {
    EXPECT_NEAR(mesh.uvs[3 * k].x, 0.5 - 0.5 * leaf.r[k], 1e-6);
    EXPECT_EQ(mesh.uvs[3 * k + 1].x, 0.5F);
    EXPECT_NEAR(mesh.uvs[3 * k + 2].y, leaf.s[k], 1e-6);
  }
}

TEST(GrassBlade, TorsionKeepsWidthsAndTheMidrib) {
  const GrassLeaf leaf = arching(40);
  for (const double twist : {-9.0, -1.0, 0.5, 3.0, 20.0}) {
    const Mesh mesh = make_grass_blade(leaf, {.twist = twist});
    EXPECT_TRUE(check_mesh(mesh, kOpen)) << twist;
    for (std::size_t k = 0; k < 40; ++k) {
      const std::vector<DVec3> row = row_of(mesh, k, 2);
      EXPECT_NEAR(glm::distance(row[0], row[2]), leaf.width * leaf.r[k], 1e-7) << twist;
      EXPECT_NEAR(glm::distance(row[1], place_of(leaf, k)), 0, 1e-7);
    }
  }
}

TEST(GrassBlade, TorsionReachesItsAngleAlongItsCurve) {
  const GrassLeaf leaf = arching_leaf(20, kPi / 2, kPi / 2);
  const GrassBlade blade{.twist = 1.2, .twist_along = Curve({{0, 0}, {0.5F, 1}, {1, 1}}, CurveKind::linear)};
  EXPECT_NEAR(torsion(blade, 0.25), 0.6, 1e-6);
  const Mesh mesh = make_grass_blade(leaf, blade);
  for (const auto& [point, angle] : {std::pair(0, 0.0), std::pair(5, 0.6), std::pair(20, 1.2)}) {
    const std::vector<DVec3> row = row_of(mesh, static_cast<std::size_t>(point), 2);
    EXPECT_NEAR(std::atan2(row[2].y - row[0].y, row[2].x - row[0].x), angle, 1e-5);
  }
}

TEST(GrassBlade, FoldAndRollKeepTheWidthAlongTheSection) {
  const GrassLeaf leaf = level(8);
  const GrassBlade folded{.fold = 0.5};
  const Mesh vee = make_grass_blade(leaf, folded);
  EXPECT_NEAR(polyline(row_of(vee, 3, 2)), leaf.width * leaf.r[3], 1e-7) << "a V is made of lines";
  const auto shortfall = [&](int across) {
    const Mesh mesh = make_grass_blade(leaf, {.fold = 0.3, .roll = 2.5, .across = across});
    return leaf.width * leaf.r[3] - polyline(row_of(mesh, 3, across));
  };
  EXPECT_GT(shortfall(8), 0);
  EXPECT_NEAR(shortfall(8) / shortfall(16), 4, 0.1);
}

TEST(GrassBlade, FoldAndRollRaiseTheEdgesByTheirAngles) {
  GrassLeaf leaf = arching_leaf(4, kPi / 2, kPi / 2);
  leaf.r = {1, 1, 0.5, 1, 1};
  const std::vector<DVec3> vee = row_of(make_grass_blade(leaf, {.fold = 0.4}), 1, 2);
  EXPECT_NEAR(vee[0].y, 0.5 * leaf.width * std::sin(0.4), 1e-7);
  EXPECT_NEAR(vee[2].y, 0.5 * leaf.width * std::sin(0.4), 1e-7);
  EXPECT_NEAR(vee[1].y, 0, 1e-9);
  // A section that bends by `roll` from edge to edge is an arc. At half the width it bends by half.
  const Mesh rolled = make_grass_blade(leaf, {.roll = 1.5, .across = 20});
  const double radius = leaf.width / 1.5;
  for (const auto& [point, half] : {std::pair(1, 0.75), std::pair(2, 0.375)}) {
    const std::vector<DVec3> arc = row_of(rolled, static_cast<std::size_t>(point), 20);
    EXPECT_NEAR(arc.back().y, radius * (1 - std::cos(half)), 1e-7);
    EXPECT_NEAR(arc.back().x, radius * std::sin(half), 1e-7);
    EXPECT_NEAR(arc.front().x, -arc.back().x, 1e-9);
  }
}

TEST(GrassBlade, WavesLeaveTheMidribAndRiseWithTheSquareToTheEdge) {
  const GrassLeaf leaf = arching_leaf(50, kPi / 2, kPi / 2);
  const GrassBlade blade{.waves = {.number = 4, .depth = 0.6, .left = 0.3, .right = 2}, .across = 4};
  const Mesh mesh = make_grass_blade(leaf, blade);
  EXPECT_TRUE(check_mesh(mesh, kOpen));
  for (std::size_t k = 0; k <= 50; ++k) {
    const std::vector<DVec3> row = row_of(mesh, k, 4);
    const double phase = 2 * kPi * 4 * leaf.s[k];
    EXPECT_NEAR(glm::distance(row[2], place_of(leaf, k)), 0, 1e-7);
    EXPECT_NEAR(row[0].y, 0.3 * leaf.width * std::sin(phase + 0.3), 1e-7);
    EXPECT_NEAR(row[4].y, 0.3 * leaf.width * std::sin(phase + 2), 1e-7);
    EXPECT_NEAR(row[1].y, 0.25 * row[0].y, 1e-7);
  }
}

TEST(GrassBlade, ItsBaseClaspsTheSheathsRound) {
  const GrassLeaf leaf = arching_leaf(30, 0, 0);
  const double radius = 0.004;
  const GrassBlade clasping{.across = 12, .clasp = 0.2, .clasp_radius = radius};
  const Mesh mesh = make_grass_blade(leaf, clasping);
  EXPECT_TRUE(check_mesh(mesh, kOpen));
  const std::vector<DVec3> base = row_of(mesh, 0, 12);
  for (const DVec3 point : base) EXPECT_NEAR(std::hypot(point.x, point.z - radius), radius, 1e-8);
  // The edges lie on the sheath, from the blade's middle at -z around it by half the width.
  EXPECT_NEAR(std::atan2(base.back().x, radius - base.back().z), 0.5 * leaf.width / radius, 1e-5);
  for (std::size_t k = 6; k <= 30; ++k) {
    for (const DVec3 point : row_of(mesh, k, 12)) EXPECT_NEAR(point.z, 0, 1e-9);
  }
}

TEST(GrassBlade, ABladeWiderThanItsSheathDoesNotRunThroughItself) {
  GrassLeaf leaf = arching_leaf(30, 0, 0);
  leaf.width = 0.1;
  const GrassBlade clasping{.across = 24, .clasp = 0.3, .clasp_radius = 0.004};
  const Mesh mesh = make_grass_blade(leaf, clasping);
  const std::vector<DVec3> base = row_of(mesh, 0, 24);
  EXPECT_LT(base.front().x, base.back().x);
  EXPECT_NEAR(polyline(base), leaf.width, 0.01 * leaf.width);
}

TEST(GrassBlade, HooksMoveAwayAlongAndAcrossInWidths) {
  const GrassLeaf leaf = arching(10);
  GrassBlade blade;
  blade.displace = [](double s, double u) { return DVec3(0.5 * s, 2 * u, 0.25 * s * u); };
  const Mesh plain = make_grass_blade(leaf, {}), moved = make_grass_blade(leaf, blade);
  for (std::size_t k = 0; k < 10; ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double s = leaf.s[k], u = 0.5 * static_cast<double>(c) - 0.5;
      const DVec3 shift = DVec3(moved.positions[3 * k + c]) - DVec3(plain.positions[3 * k + c]);
      EXPECT_NEAR(-shift.z, leaf.width * 0.5 * s, 1e-7);
      EXPECT_NEAR(shift.y, leaf.width * 2 * u, 1e-7);
      EXPECT_NEAR(shift.x, leaf.width * 0.25 * s * u, 1e-7);
    }
  }
}

TEST(GrassBlade, HooksMoveThePointOfTheTipAsWell) {
  GrassBlade blade;
  blade.displace = [](double, double) { return DVec3(0, 1, 0); };
  const GrassLeaf leaf = arching(10);
  const Mesh plain = make_grass_blade(leaf, {}), moved = make_grass_blade(leaf, blade);
  EXPECT_NEAR(moved.positions.back().y - plain.positions.back().y, leaf.width, 1e-7);
}

TEST(GrassBlade, NarrowPlacesBetweenKeepTheBladeInOnePart) {
  GrassLeaf leaf = arching(10);
  leaf.r[4] = leaf.r[5] = 0;
  const Mesh mesh = make_grass_blade(leaf, {});
  EXPECT_TRUE(check_mesh(mesh, kOpen));
  EXPECT_EQ(mesh.triangle_count(), 38U);
}

TEST(GrassBlade, AMidribThatComesBackToAPlaceStaysFinite) {
  GrassLeaf leaf = arching_leaf(4, 0.5, 0.5);
  for (const std::size_t k : {2, 3}) leaf.x[k] = leaf.x[1], leaf.y[k] = leaf.y[1];
  const Mesh mesh = make_grass_blade(leaf, {.twist = 1});
  for (const Vec3 position : mesh.positions) EXPECT_TRUE(std::isfinite(position.x + position.y + position.z));
  for (const Vec3 normal : mesh.normals) EXPECT_NEAR(glm::length(normal), 1, 1e-5);
}

TEST(GrassBlade, WithAllEffectsTheMeshIsSound) {
  const GrassBlade blade{.twist = 2,
                         .fold = 0.3,
                         .roll = 0.8,
                         .waves = {.number = 6, .depth = 0.3},
                         .across = 6,
                         .clasp = 0.1,
                         .clasp_radius = 0.004};
  EXPECT_TRUE(check_mesh(make_grass_blade(arching(80), blade), kOpen));
}

TEST(GrassBlade, ATwistIsSharedOutOverThePiecesThatStay) {
  // A straight leaf of constant width: without twist, no inner point matters.
  const GrassLeaf leaf = arching_leaf(48, 0.3, 0.3);
  EXPECT_TRUE(blade_relief(leaf, {}).empty());
  const GrassBlade twisted{.twist = kPi};
  const auto kept = points_kept(reduction_order(leaf, blade_relief(leaf, twisted)), 8);
  ASSERT_EQ(kept.size(), 9U);
  for (std::size_t k = 1; k < kept.size(); ++k) {
    EXPECT_GE(kept[k] - kept[k - 1], 4U);
    EXPECT_LE(kept[k] - kept[k - 1], 10U);
  }
}

TEST(GrassBlade, WhatHooksAndClaspMoveIsKeptByAReduction) {
  const GrassLeaf leaf = arching_leaf(48, 0.3, 0.3);
  GrassBlade bump;
  bump.displace = [](double s, double) { return DVec3(s > 0.4 && s < 0.6 ? 1 : 0, 0, 0); };
  const auto within = points_within(reduction_order(leaf, blade_relief(leaf, bump)), 1e-4);
  // Both flanks of the bump: four points besides the ends.
  EXPECT_EQ(within.size(), 6U);
  const GrassBlade clasping{.clasp = 0.1, .clasp_radius = 0.004};
  const auto kept = points_kept(reduction_order(leaf, blade_relief(leaf, clasping)), 4);
  EXPECT_LE(leaf.s[kept[2]], 0.1) << "where the blade unrolls";
}

TEST(GrassBlade, RejectsWhatIsNoBlade) {
  const GrassLeaf leaf = arching(4);
  EXPECT_THROW(make_grass_blade(leaf, {.across = 3}), std::invalid_argument);
  EXPECT_THROW(make_grass_blade(leaf, {.across = 0}), std::invalid_argument);
  EXPECT_THROW(make_grass_blade(leaf, {.twist = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(make_grass_blade(leaf, {.waves = {.number = 1, .depth = std::nan("")}}), std::invalid_argument);
  GrassLeaf unseen = leaf;
  unseen.length = 0;
  EXPECT_THROW(make_grass_blade(unseen, {}), std::invalid_argument);
}

/// Returns true if the midrib has a kink so sharp that normals between its sides lie on the front of neither.
bool is_broken(const GrassLeaf& leaf) {
  const std::vector<double> angles = piece_angles(leaf);
  for (std::size_t k = 1; k < angles.size(); ++k) {
    if (std::abs(angles[k] - angles[k - 1]) > 0.45 * kPi) return true;
  }
  return false;
}

TEST(GrassBlade, MeasuredLeavesAreSoundAtAnyLevelOfDetail) {
  for (const MeasuredGrass& grass : measured_grasses()) {
    SCOPED_TRACE(grass.name);
    const std::vector<GrassLeaf> leaves = grass.fitted(50);
    std::size_t sound = 0;
    for (std::size_t k = 0; k < leaves.size(); ++k) {
      const ReductionOrder order = reduction_order(leaves[k]);
      for (const std::size_t pieces : {1, 3, 16, 48}) {
        const GrassLeaf leaf = reduced(leaves[k], points_kept(order, pieces));
        if (is_broken(leaf)) continue;
        EXPECT_TRUE(check_mesh(make_grass_blade(leaf, {.twist = 0.5}), kOpen)) << k << ", " << pieces;
        ++sound;
      }
    }
    EXPECT_GT(10 * sound, 9 * 4 * leaves.size()) << "few leaves are broken";
  }
}

TEST(GrassSheath, IsAnOpenTubeOfRadius1) {
  for (const double open : {0.0, 0.5, 3.0}) {
    const Mesh sheath = make_sheath(open);
    EXPECT_TRUE(check_mesh(sheath, kOpen));
    for (const Vec3 position : sheath.positions) {
      const double radius = std::hypot(position.x, position.z);
      EXPECT_NEAR(radius, position.y == 0 ? 1 : 0.94, 1e-6);
      EXPECT_TRUE(position.y == 0 || position.y == -1);
      // The slit is at +z.
      EXPECT_GE(std::abs(std::atan2(position.x, position.z)), 0.5 * open - 1e-6);
    }
  }
}

TEST(GrassSheath, ALigulesFootStandsOnItsRimAndItsMiddleIs1High) {
  const Mesh ligule = make_ligule();
  EXPECT_TRUE(check_mesh(ligule, kOpen));
  float highest = 0;
  for (const Vec3 position : ligule.positions) {
    EXPECT_NEAR(std::hypot(position.x, position.z), 0.985, 0.0151) << "its outer and its inner face";
    EXPECT_LT(position.z, 0) << "on the blade's side";
    highest = std::max(highest, position.y);
  }
  EXPECT_NEAR(highest, 1, 1e-6);
}

}  // namespace meristem::grass_blade_test
