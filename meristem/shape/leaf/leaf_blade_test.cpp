// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/leaf/leaf_blade.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include <glm/vec2.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/check_mesh.h"

namespace meristem::leaf_blade_test {

constexpr MeshPromises kOpen{.closed = false, .outward = false};

/// Returns the outline of an oak leaf: lobes and bays on a wedge.
Curve oak_outline() {
  return Curve({{0, 0},
                {0.12F, 0.2F},
                {0.2F, 0.12F},
                {0.34F, 0.62F},
                {0.44F, 0.34F},
                {0.58F, 1},
                {0.7F, 0.5F},
                {0.84F, 0.75F},
                {1, 0}});
}

double integral(const Curve& outline) {
  constexpr int kSteps = 20000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += std::max(0.0, outline((i + 0.5) / kSteps));
  return sum / kSteps;
}

/// Returns the length of the midrib, from the vertices with u = 0.5, which are in the order of the rows.
double midrib_length(const Mesh& mesh) {
  double length = 0;
  Vec3 last(0);
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    if (mesh.uvs[i].x != 0.5F) continue;
    length += glm::distance(last, mesh.positions[i]);
    last = mesh.positions[i];
  }
  return length;
}

/// Returns the length of the polyline across the widest row.
double widest_length(const Mesh& mesh, int across) {
  double widest = 0;
  const auto row_points = static_cast<std::size_t>(across) + 1;
  for (std::size_t i = 0; i + row_points <= mesh.vertex_count(); ++i) {
    if (mesh.uvs[i].y != mesh.uvs[i + row_points - 1].y) continue;
    double length = 0;
    for (std::size_t k = 1; k < row_points; ++k) {
      length += glm::distance(mesh.positions[i + k - 1], mesh.positions[i + k]);
    }
    widest = std::max(widest, length);
  }
  return widest;
}

TEST(LeafBlade, FlatLeafOfStraightLinesHasExactlyTheOutlinesArea) {
  LeafBlade blade;
  blade.outline = Curve({{0, 0}, {0.3F, 1}, {0.6F, 0.4F}, {1, 0}}, CurveKind::linear);
  blade.rows = 3;
  const Mesh leaf = make_leaf_blade(blade);
  EXPECT_TRUE(check_mesh(leaf, kOpen));
  EXPECT_NEAR(surface_area(leaf) / (blade.length * blade.width), 0.5 * 0.3 + 0.7 * 0.3 + 0.2 * 0.4, 1e-6);
  EXPECT_EQ(leaf.vertex_count(), 1U + 3 + 3 + 1);
}

TEST(LeafBlade, FlatAreaConvergesToTheIntegralOfTheOutline) {
  for (const Curve& outline : {LeafBlade{}.outline, oak_outline()}) {
    LeafBlade blade;
    blade.outline = outline;
    const auto error = [&](int rows) {
      blade.rows = rows;
      return std::abs(surface_area(make_leaf_blade(blade)) / (blade.length * blade.width * integral(outline)) - 1);
    };
    EXPECT_LT(error(24), 0.015);
    EXPECT_LT(error(96), 0.001);
  }
}

TEST(LeafBlade, LobesAndBaysHaveRowsHoweverFewAreAskedFor) {
  LeafBlade blade;
  blade.outline = oak_outline();
  blade.rows = 1;
  const Mesh leaf = make_leaf_blade(blade);
  EXPECT_TRUE(check_mesh(leaf, kOpen));
  for (const float turn : {0.2F, 0.34F, 0.44F, 0.58F, 0.7F, 0.84F}) {
    const bool is_there =
        std::any_of(leaf.uvs.begin(), leaf.uvs.end(), [turn](Vec2 uv) { return std::abs(uv.y - turn) < 0.04F; });
    EXPECT_TRUE(is_there) << turn;
  }
}

TEST(LeafBlade, FrontFaceIsUpAndNormalsOfAFlatLeafAreZ) {
  const Mesh leaf = make_leaf_blade({});
  EXPECT_TRUE(check_mesh(leaf, kOpen));
  for (const Vec3 normal : leaf.normals) EXPECT_EQ(normal, Vec3(0, 0, 1));
}

TEST(LeafBlade, CurlKeepsTheMidribsLengthToSecondOrder) {
  LeafBlade blade;
  blade.outline = Curve({{0, 1}});
  blade.curl = 2.5;
  const auto shortfall = [&](int rows) {
    blade.rows = rows;
    return blade.length - midrib_length(make_leaf_blade(blade));
  };
  EXPECT_GT(shortfall(8), 0);
  EXPECT_NEAR(shortfall(8) / shortfall(16), 4, 0.2);
}

TEST(LeafBlade, CurlAcrossAndFoldKeepTheWidthToSecondOrder) {
  LeafBlade blade;
  blade.outline = Curve({{0, 1}});
  blade.curl_across = 2.5;
  blade.fold = 0.4;
  blade.rows = 1;
  const auto shortfall = [&](int across) {
    blade.across = across;
    return blade.width - widest_length(make_leaf_blade(blade), across);
  };
  EXPECT_GT(shortfall(8), 0);
  EXPECT_NEAR(shortfall(8) / shortfall(16), 4, 0.2);
}

TEST(LeafBlade, PositiveCurlSinksTheTipOnACircle) {
  LeafBlade blade;
  blade.curl = kPi / 2;
  const Mesh leaf = make_leaf_blade(blade);
  const double radius = blade.length / blade.curl;
  EXPECT_NEAR(leaf.positions.back().y, radius, 1e-6);
  EXPECT_NEAR(leaf.positions.back().z, -radius, 1e-6);
  EXPECT_NEAR(leaf.normals.back().y, 1, 1e-6);
}

TEST(LeafBlade, PositiveCurlAcrossSinksTheEdgesAndFoldRaisesThem) {
  LeafBlade blade;
  blade.curl_across = 1;
  const auto lowest_and_highest = [](const Mesh& mesh) {
    Box box;
    for (const Vec3 position : mesh.positions) box.add(position);
    return std::pair(box.low.z, box.high.z);
  };
  EXPECT_LT(lowest_and_highest(make_leaf_blade(blade)).first, -0.005F);
  EXPECT_EQ(lowest_and_highest(make_leaf_blade(blade)).second, 0.0F);
  blade.curl_across = 0;
  blade.fold = radians(30);
  EXPECT_NEAR(lowest_and_highest(make_leaf_blade(blade)).second, blade.width / 2 * 0.5, 1e-4);
}

TEST(LeafBlade, NormalsAreTheSurfacesOwn) {
  // Compares normals with the triangles around each vertex on a fine blade.
  LeafBlade blade;
  blade.curl = 1.2;
  blade.curl_across = -0.8;
  blade.rows = 100;
  blade.across = 40;
  const Mesh leaf = make_leaf_blade(blade);
  EXPECT_TRUE(check_mesh(leaf, kOpen));
  for (const auto& triangle : leaf.triangles) {
    const Vec3 a = leaf.positions[triangle[0]];
    const Vec3 flat = glm::normalize(glm::cross(leaf.positions[triangle[1]] - a, leaf.positions[triangle[2]] - a));
    for (const auto vertex : triangle) EXPECT_GT(glm::dot(flat, leaf.normals[vertex]), 0.995F);
  }
}

TEST(LeafBlade, PetioleStartsAtTheOriginAndMovesTheBlade) {
  LeafBlade blade;
  blade.petiole = 0.03;
  const Mesh leaf = make_leaf_blade(blade);
  EXPECT_TRUE(check_mesh(leaf, kOpen));
  EXPECT_NEAR(leaf.positions.back().y, blade.petiole + blade.length, 1e-6);
  EXPECT_EQ(leaf.triangle_count(), make_leaf_blade({}).triangle_count() + 9);
  EXPECT_EQ(std::min_element(leaf.positions.begin(), leaf.positions.end(), [](Vec3 a, Vec3 b) { return a.y < b.y; })->y,
            0.0F);
}

TEST(LeafBlade, AnOutlineThatIsZeroInBetweenMakesTwoPartsThatMeetInAPoint) {
  LeafBlade blade;
  blade.outline = Curve({{0, 0}, {0.25F, 1}, {0.4F, 0}, {0.6F, 0}, {0.75F, 1}, {1, 0}}, CurveKind::linear);
  const Mesh leaf = make_leaf_blade(blade);
  EXPECT_TRUE(check_mesh(leaf, kOpen));
  EXPECT_NEAR(surface_area(leaf) / (blade.length * blade.width), 0.4, 1e-6);
}

/// Returns a leaf with overhanging lobes and a base that extends behind the joint.
LeafBlade palmate() {
  LeafBlade blade;
  blade.polygon = {{0.35F, -0.1F}, {0.3F, 0.12F}, {0.8F, 0.1F},  {0.65F, 0.25F}, {1, 0.55F},
                   {0.7F, 0.5F},   {0.45F, 0.4F}, {0.4F, 0.75F}, {0.25F, 0.7F},  {0, 1}};
  return blade;
}

/// Returns the area of a closed polygon that runs counter-clockwise.
double area_of(const std::vector<Vec2>& corners) {
  double doubled = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 a(corners[i]), b(corners[(i + 1) % corners.size()]);
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}

TEST(LeafBlade, AFlatPolygonHasItsExactArea) {
  LeafBlade blade = palmate();
  blade.across = 8;
  blade.rows = 20;
  std::vector<Vec2> corners{{0, 0}};
  corners.insert(corners.end(), blade.polygon.begin(), blade.polygon.end());
  const Mesh leaf = make_leaf_blade(blade);
  EXPECT_TRUE(check_mesh(leaf, kOpen));
  EXPECT_NEAR(surface_area(leaf) / (2 * area_of(corners) * blade.length * blade.width / 2), 1, 1e-5);
}

TEST(LeafBlade, ItsPictureIsTheOutlineThatTheMeshCovers) {
  LeafBlade blade = palmate();
  blade.heart = 0.1;
  blade.rows = 40;
  const TextureShape shape = leaf_texture_shape(blade);
  Mesh flat = make_leaf_blade(blade);
  for (std::size_t i = 0; i < flat.vertex_count(); ++i) flat.positions[i] = Vec3(flat.uvs[i], 0);
  EXPECT_NEAR(surface_area(flat), area_of(shape.outline), 2e-3);
  EXPECT_FALSE(shape.masked);
  Box box;
  for (const Vec2 uv : shape.outline) box.add(Vec3(uv, 0));
  EXPECT_EQ(box.low, Vec3(0));
  EXPECT_EQ(box.high, Vec3(1, 1, 0));
}

TEST(LeafBlade, AHullCoversThePictureWithFewTriangles) {
  LeafBlade blade = palmate();
  blade.teeth = 20;
  blade.rows = 4;
  blade.edge = LeafBlade::Edge::picture;
  blade.petiole = 0.02;
  const Mesh leaf = make_leaf_blade(blade);
  EXPECT_TRUE(check_mesh(leaf, kOpen));
  EXPECT_LE(leaf.triangle_count(), 9U + 2 * 2 * 5);
  EXPECT_TRUE(leaf_texture_shape(blade).masked);
  for (const Vec2 uv : leaf.uvs) EXPECT_TRUE(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1);
}

TEST(LeafBlade, ThePictureOfTheStalkLiesOnTheLeaf) {
  LeafBlade blade;
  blade.petiole = 0.02;
  blade.edge = LeafBlade::Edge::picture;
  const Mesh leaf = make_leaf_blade(blade);
  for (std::size_t i = 0; i < 9; ++i) {
    const double across = std::abs(leaf.uvs[i].x - 0.5) * 2;
    EXPECT_LT(across, blade.outline(leaf.uvs[i].y));
  }
}

TEST(LeafBlade, TeethCostTwoTrianglesEachOnEitherSide) {
  LeafBlade blade = palmate();
  blade.rows = 1;
  const std::size_t entire = make_leaf_blade(blade).triangle_count();
  blade.teeth = 10;
  EXPECT_LE(make_leaf_blade(blade).triangle_count(), entire + 2 * 2 * 10);
}

TEST(LeafBlade, TheProfileLiftsEdges) {
  LeafBlade blade;
  blade.outline = Curve({{0, 1}});
  blade.profile = Curve({{0, 0}, {0.5F, -0.1F}, {1, 0.3F}}, CurveKind::linear);
  blade.across = 20;
  const Mesh leaf = make_leaf_blade(blade);
  EXPECT_TRUE(check_mesh(leaf, kOpen));
  Box box;
  for (const Vec3 position : leaf.positions) box.add(position);
  EXPECT_NEAR(box.high.z, 0.3 * blade.width / 2, 1e-6);
  EXPECT_NEAR(box.low.z, -0.1 * blade.width / 2, 2e-4);
}

TEST(LeafBlade, WavesRunAlongBothEdges) {
  LeafBlade blade;
  blade.outline = Curve({{0, 1}});
  blade.waves = 4;
  blade.waves_depth = 0.2;
  blade.across = 6;
  const Mesh leaf = make_leaf_blade(blade);
  EXPECT_TRUE(check_mesh(leaf, kOpen));
  int crests = 0, troughs = 0;
  for (const Vec3 position : leaf.positions) {
    if (std::abs(position.z - 0.2 * blade.width / 2) < 1e-6) ++crests;
    if (std::abs(position.z + 0.2 * blade.width / 2) < 1e-6) ++troughs;
  }
  EXPECT_EQ(crests, 2 * 4);
  EXPECT_EQ(troughs, 2 * 4);
}

RC_GTEST_PROP(LeafBlade, ALobedBladeIsSoundHoweverItIsBent, ()) {
  const auto share = [] { return *rc::gen::inRange(0, 1001) / 1000.0; };
  LeafBlade blade = palmate();
  blade.corners = *rc::gen::element(LeafBlade::Corners::sharp, LeafBlade::Corners::round);
  blade.edge = *rc::gen::element(LeafBlade::Edge::shape, LeafBlade::Edge::picture);
  blade.heart = 0.3 * share();
  blade.curl = share() - 0.5;
  blade.curl_across = share() - 0.5;
  blade.fold = 0.3 * share();
  blade.waves = *rc::gen::inRange(0, 4);
  blade.waves_depth = 0.1;
  blade.rows = *rc::gen::inRange(6, 30);
  blade.across = 2 * *rc::gen::inRange(1, 5);
  blade.petiole = *rc::gen::element(0.0, 0.04);
  RC_ASSERT(check_mesh(make_leaf_blade(blade), kOpen));
}

RC_GTEST_PROP(LeafBlade, IsSoundForAnyShape, ()) {
  const auto share = [] { return *rc::gen::inRange(0, 1001) / 1000.0; };
  LeafBlade blade;
  const int points = *rc::gen::inRange(2, 9);
  std::vector<Vec2> outline;
  for (int i = 0; i < points; ++i) outline.emplace_back(i / (points - 1.0F), share());
  blade.outline = Curve(outline, *rc::gen::element(CurveKind::linear, CurveKind::spline));
  blade.curl = 4 * share() - 2;
  blade.curl_across = 2 * share() - 1;
  blade.fold = share();
  blade.petiole = *rc::gen::element(0.0, 0.0005, 0.04);
  blade.rows = *rc::gen::inRange(1, 40);
  blade.across = 2 * *rc::gen::inRange(1, 5);
  RC_ASSERT(check_mesh(make_leaf_blade(blade), kOpen));
}

RC_GTEST_PROP(LeafBlade, TrianglesAreCountedWithoutAMesh, ()) {
  const auto share = [] { return *rc::gen::inRange(0, 1001) / 1000.0; };
  LeafBlade blade = *rc::gen::element(LeafBlade(), palmate());
  if (blade.polygon.empty() && *rc::gen::arbitrary<bool>()) blade.outline = oak_outline();
  blade.corners = *rc::gen::element(LeafBlade::Corners::sharp, LeafBlade::Corners::round);
  blade.edge = *rc::gen::element(LeafBlade::Edge::shape, LeafBlade::Edge::picture);
  blade.heart = 0.3 * share();
  blade.teeth = *rc::gen::inRange(0, 12);
  blade.waves = *rc::gen::inRange(0, 4);
  blade.curl = share();
  blade.rows = *rc::gen::inRange(1, 30);
  blade.across = 2 * *rc::gen::inRange(1, 5);
  blade.petiole = *rc::gen::element(0.0, 0.04);
  RC_ASSERT(leaf_blade_triangles(blade) == make_leaf_blade(blade).triangle_count());
}

TEST(LeafBlade, RejectsWhatMakesNoBlade) {
  const auto rejects = [](const std::function<void(LeafBlade&)>& change) {
    LeafBlade blade;
    change(blade);
    EXPECT_THROW(make_leaf_blade(blade), std::invalid_argument);
    EXPECT_THROW(leaf_blade_triangles(blade), std::invalid_argument);
  };
  rejects([](LeafBlade& blade) { blade.length = 0; });
  rejects([](LeafBlade& blade) { blade.width = -1; });
  rejects([](LeafBlade& blade) { blade.petiole = -0.1; });
  rejects([](LeafBlade& blade) { blade.petiole = 0.1, blade.petiole_radius = 0; });
  rejects([](LeafBlade& blade) { blade.curl = std::numeric_limits<double>::quiet_NaN(); });
  rejects([](LeafBlade& blade) { blade.heart = -0.1; });
  rejects([](LeafBlade& blade) { blade.teeth = -1; });
  rejects([](LeafBlade& blade) { blade.waves_depth = std::numeric_limits<double>::infinity(); });
  rejects([](LeafBlade& blade) { blade.polygon = {{-0.5F, 0.5F}}; });
  rejects([](LeafBlade& blade) { blade.polygon = {{0, 0.5F}}; });
  rejects([](LeafBlade& blade) { blade.rows = 0; });
  rejects([](LeafBlade& blade) { blade.across = 3; });
}

}  // namespace meristem::leaf_blade_test
