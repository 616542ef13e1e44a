// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/implicit/isosurface.h"

#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/shape/implicit/brick_field.h"
#include "tests/support/check_mesh.h"
#include "tests/support/sample_fields.h"

namespace meristem::isosurface_test {

Mesh surface_of(const ImplicitBody& body, const IsosurfaceOptions& options = {}, const SizeLimits& limits = {}) {
  Progress progress;
  return extract_isosurface(body, options, limits, "components.tree.surface.resolution", progress);
}

Mesh surface_of(const SampledField& field, float isovalue = 0, const SizeLimits& limits = {}) {
  Progress progress;
  return extract_isosurface(field, isovalue, limits, "field", progress);
}

/// Counts corners of triangles whose normals do not lie in front of them.
std::size_t corners_behind(const Mesh& mesh) {
  std::size_t behind = 0;
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    const DVec3 at(mesh.positions[triangle[0]]);
    const DVec3 front = glm::cross(DVec3(mesh.positions[triangle[1]]) - at, DVec3(mesh.positions[triangle[2]]) - at);
    for (const std::uint32_t vertex : triangle) behind += glm::dot(front, DVec3(mesh.normals[vertex])) > 0 ? 0 : 1;
  }
  return behind;
}

ImplicitBody ring(double radius, double tube, DVec3 centre = {}) {
  ImplicitBody body;
  for (int k = 0; k < 24; ++k) {
    const auto at = [&](int i) { return centre + radius * DVec3(std::cos(i * kPi / 12), 0, std::sin(i * kPi / 12)); };
    body.unite(ImplicitBody::capsule(at(k), at((k + 1) % 24), tube));
  }
  return body;
}

TEST(Isosurface, SphereAreaConvergesAtSecondOrder) {
  const ImplicitBody ball = ImplicitBody::sphere({0.1, 0.2, 0.3}, 1);
  std::array<double, 4> area{};
  std::array<double, 4> volume{};
  for (int k = 0; k < 4; ++k) {
    const Mesh mesh = surface_of(ball, {.resolution = 10 << k});
    EXPECT_TRUE(check_mesh(mesh));
    area[k] = 4 * kPi - surface_area(mesh);
    volume[k] = 4 * kPi / 3 - signed_volume(mesh);
    EXPECT_GT(area[k], 0);
    EXPECT_GT(volume[k], 0);
    if (k == 0) continue;
    EXPECT_NEAR(area[k - 1] / area[k], 4, 0.4);
    EXPECT_NEAR(volume[k - 1] / volume[k], 4, 0.4);
  }
  EXPECT_LT(area[3], 0.003 * 4 * kPi);
}

TEST(Isosurface, CornersLieOnTheSurface) {
  const Mesh mesh = surface_of(ImplicitBody::sphere({}, 1), {.resolution = 50});
  for (std::size_t k = 0; k < mesh.vertex_count(); ++k) {
    // A chord of a cell lies inside a circle by the square of its length divided by eight radii.
    EXPECT_NEAR(glm::length(mesh.positions[k]), 1, 0.04 * 0.04 / 8 + 1e-4);
    EXPECT_GT(glm::dot(mesh.positions[k], mesh.normals[k]), 0.999F);
  }
}

TEST(Isosurface, EulerNumbersAreThoseOfTheBodies) {
  const ImplicitBody ball = ImplicitBody::sphere({}, 0.4);
  const ImplicitBody torus = ring(1, 0.2);
  const auto euler = [](const ImplicitBody& body) {
    const Mesh mesh = surface_of(body, {.resolution = 40});
    EXPECT_TRUE(check_mesh(mesh));
    return euler_number(mesh);
  };
  EXPECT_EQ(euler(ball), 2);
  EXPECT_EQ(euler(torus), 0);
  EXPECT_EQ(euler(ImplicitBody(torus).unite(ball)), 2);
  EXPECT_EQ(euler(ImplicitBody(torus).unite(ImplicitBody::sphere({1, 0, 0}, 0.4))), 0);
  EXPECT_EQ(euler(ImplicitBody(torus).unite(ring(1, 0.2, {3, 0, 0}))), 0);
  EXPECT_EQ(euler(ImplicitBody(torus).unite(ring(1, 0.2, {2, 0, 0}))), -2);
  EXPECT_EQ(euler(ImplicitBody(ball).unite(ImplicitBody::sphere({1, 0, 0}, 0.4))), 4);
  EXPECT_EQ(euler(ImplicitBody(ball).unite(ImplicitBody::sphere({0.5, 0, 0}, 0.4))), 2);
  EXPECT_EQ(euler(ImplicitBody(ball).subtract(ImplicitBody::sphere({}, 0.2))), 4);  // hollow
}

TEST(Isosurface, AnEmptyBodyHasNone) {
  EXPECT_TRUE(surface_of(ImplicitBody()).positions.empty());
  ImplicitBody gone = ImplicitBody::sphere({}, 1);
  gone.subtract(ImplicitBody(gone));
  EXPECT_TRUE(surface_of(gone).triangles.empty());
  ImplicitBody apart = ImplicitBody::sphere({}, 1);
  apart.intersect(ImplicitBody::sphere({5, 5, 5}, 1));
  EXPECT_TRUE(surface_of(apart).triangles.empty());
}

TEST(Isosurface, AFieldIsClosedWhereItEnds) {
  for (const glm::ivec3 size : {glm::ivec3(1), glm::ivec3(2, 1, 1), glm::ivec3(7, 8, 9), glm::ivec3(30, 1, 17)}) {
    SampledField field{.size = size, .origin = {5, 6, 7}, .spacing = 0.5};
    field.values.assign(static_cast<std::size_t>(size.x) * size.y * size.z, -1);
    const Mesh mesh = surface_of(field);
    EXPECT_TRUE(check_mesh(mesh));
    EXPECT_EQ(euler_number(mesh), 2);
  }
  // A ball that leaves the grid on all sides is cut off at the border.
  const SampledField cut = field_of(20, [](DVec3 p) { return glm::length(p) - 11; });
  const Mesh mesh = surface_of(cut);
  EXPECT_TRUE(check_mesh(mesh));
  EXPECT_EQ(euler_number(mesh), 2);
}

TEST(Isosurface, AFieldLiesWhereItsGridSays) {
  SampledField field = field_of(21, [](DVec3 p) { return glm::length(p) - 7; });
  field.origin = {100, 200, 300};
  field.spacing = 0.5;
  const Mesh mesh = surface_of(field, -1);
  EXPECT_TRUE(check_mesh(mesh));
  Box box;
  for (const Vec3 position : mesh.positions) box.add(position);
  EXPECT_LT(glm::length(box.centre() - Vec3(105, 205, 305)), 1e-3F);
  EXPECT_LT(glm::length(box.size() - Vec3(6)), 2e-2F);
}

TEST(Isosurface, ValuesAtTheIsovalueAreOutside) {
  // A box whose faces, edges and corners lie on the grid, a plane, and a diagonal plane.
  const auto box = [](DVec3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - 4; };
  const Mesh mesh = surface_of(field_of(15, box));
  EXPECT_TRUE(check_mesh(mesh));
  EXPECT_EQ(euler_number(mesh), 2);
  EXPECT_NEAR(signed_volume(mesh), 512 - 12 * 7 * 0.5, 3);  // minus half a cell along its edges
  EXPECT_TRUE(surface_of(field_of(9, [](DVec3) { return 0; })).triangles.empty());
  EXPECT_TRUE(surface_of(field_of(9, [](DVec3) { return 3; }), 3).triangles.empty());
  EXPECT_TRUE(check_mesh(surface_of(field_of(9, [](DVec3 p) { return p.x + p.y + p.z; }))));
  EXPECT_TRUE(
      check_mesh(surface_of(field_of(9, [](DVec3 p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z) - 3; }))));
  // The box as a body, whose cells do not match its size.
  EXPECT_TRUE(check_mesh(surface_of(ImplicitBody::box({}, {1, 1, 1}), {.resolution = 10, .normals = false})));
}

TEST(Isosurface, AnyFieldOfSmallNumbersIsClosed) {
  const RandomKey key(21);
  for (std::uint64_t k = 0; k < 50; ++k) {
    const RandomKey draw = key.child(k);
    const auto range = static_cast<int>(1 + k % 4);
    SampledField field{.size = {5 + k % 7, 6 + k % 5, 4 + k % 9}};
    field.values.resize(static_cast<std::size_t>(field.size.x) * field.size.y * field.size.z);
    for (std::size_t i = 0; i < field.values.size(); ++i) {
      field.values[i] = static_cast<float>(std::floor(draw.uniform(i, -range, range + 1)));
    }
    const Mesh mesh = surface_of(field);
    EXPECT_TRUE(check_mesh(mesh)) << k;
  }
}

TEST(Isosurface, TakesNumbersThatAreNone) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float largest = std::numeric_limits<float>::max();
  const float min = std::numeric_limits<float>::denorm_min();
  const std::array<float, 10> odd{infinity, -infinity, std::nanf(""), largest, -largest, min, -min, 0.0F, -0.0F, 1};
  const RandomKey key(22);
  for (std::uint64_t k = 0; k < 20; ++k) {
    SampledField field{.size = {9, 8, 7}};
    field.values.resize(9 * 8 * 7);
    for (std::size_t i = 0; i < field.values.size(); ++i) {
      field.values[i] = odd[static_cast<std::size_t>(key.child(k).uniform(i, 0, 10))];
    }
    for (const float isovalue : {0.0F, 1.0F, -largest, largest})
      EXPECT_TRUE(check_mesh(surface_of(field, isovalue))) << k;
  }
  SampledField none{.size = {4, 4, 4}, .values = std::vector<float>(64, std::nanf(""))};
  EXPECT_TRUE(surface_of(none).triangles.empty());
}

TEST(Isosurface, RejectsFieldsThatAreNone) {
  const SampledField good{.size = {2, 2, 2}, .values = std::vector<float>(8)};
  const auto rejects = [&](auto change) {
    SampledField field = good;
    float isovalue = 0;
    change(field, isovalue);
    EXPECT_THROW(surface_of(field, isovalue), std::invalid_argument);
  };
  rejects([](SampledField& field, float&) { field.size.x = 3; });
  rejects([](SampledField& field, float&) { field.size = {-2, -2, 2}; });
  rejects([](SampledField& field, float&) {
    field.size = {1 << 22, 1 << 21, 1 << 21};  // the product is 2^64
    field.values.clear();
  });
  rejects([](SampledField& field, float&) { field.spacing = 0; });
  rejects([](SampledField& field, float&) { field.spacing = std::numeric_limits<double>::infinity(); });
  rejects([](SampledField& field, float&) { field.origin.y = std::nan(""); });
  rejects([](SampledField&, float& isovalue) { isovalue = std::nanf(""); });
  EXPECT_TRUE(surface_of(SampledField{}).triangles.empty());
}

// Tests resolutions 10 to 60. Most are coarse, so that bodies are thinner than cells.
void expect_closed(std::uint64_t first, std::uint64_t count) {
  std::size_t corners = 0;
  std::size_t behind = 0;
  for (std::uint64_t k = first; k < first + count; ++k) {
    const RandomKey key = RandomKey(31).child(k);
    const double share = key.uniform(0);
    const int resolution = 10 + static_cast<int>(51 * share * share * share * share * share * share);
    Mesh mesh = surface_of(random_body(key), {.resolution = resolution});
    corners += 3 * mesh.triangle_count();
    behind += corners_behind(mesh);
    mesh.normals.clear();
    EXPECT_TRUE(check_mesh(mesh)) << k << " at " << resolution;
  }
  EXPECT_LT(behind, corners / 10000);
}

TEST(Isosurface, AnyBodyIsClosed) { expect_closed(0, 70); }
TEST(Isosurface, AnyOtherBodyIsClosed) { expect_closed(70, 70); }
TEST(Isosurface, AnyThirdBodyIsClosed) { expect_closed(140, 70); }

TEST(Isosurface, NormalsOfSmoothBodiesLieInFrontOfTheirTriangles) {
  ImplicitBody tree = ImplicitBody::round_cone({0, 0, 0}, 0.3, {0, 3, 0}, 0.15);
  tree.blend(ImplicitBody::round_cone({0, 1.5, 0}, 0.2, {1, 3, 0}, 0.1), BlendKind::poly, 0.3);
  tree.blend(ImplicitBody::ellipsoid({.origin = {0, 3.5F, 0}}, {1, 0.6F, 0.8F}), BlendKind::poly, 0.5);
  for (const int resolution : {10, 17, 40, 90}) {
    EXPECT_TRUE(check_mesh(surface_of(tree, {.resolution = resolution}))) << resolution;
    EXPECT_TRUE(check_mesh(surface_of(ring(1, 0.3), {.resolution = resolution}))) << resolution;
  }
}

/// Returns a tree's body: a chain of cones, each blended with all cones before it over some cells.
ImplicitBody blended_chain(const RandomKey& key, BlendKind kind, double max_width) {
  ImplicitBody body;
  DVec3 from(0);
  std::vector<DVec3> ends{from};
  for (std::uint64_t k = 0; k < 40; ++k) {
    const RandomKey draw = key.child(k);
    from = ends[static_cast<std::size_t>(draw.uniform(0, 0, static_cast<double>(ends.size())))];
    const DVec3 to = from + draw.uniform(1, 0.2, 1) * DVec3(draw.direction(2));
    const double radius = draw.uniform(3, 0.02, 0.2);
    const double width = draw.uniform(4) < 0.2 ? 0 : draw.uniform(5, 0, max_width);
    body.blend(k % 5 == 0 ? ImplicitBody::flat_cone(from, radius, to, 0.5 * radius)
                          : ImplicitBody::round_cone(from, radius, to, draw.uniform(6, 0, radius)),
               kind, width);
    ends.push_back(to);
  }
  return body;
}

/// Returns balls in rows in which each blend still lowers the next one, the worst case for dropped clauses.
ImplicitBody blended_row(BlendKind kind, double width) {
  ImplicitBody body;
  for (int k = 0; k < 50; ++k) {
    const double height = 1 + 0.9 * width * (1 - 0.012 * k);
    body.blend(ImplicitBody::capsule({-3, height + 0.3 * width * (k % 7), 0.1 * k}, {3, height, 0.1 * k}, 0.5), kind,
               width);
  }
  return body;
}

/// Returns the largest error of values less than two cells from the surface, in cells.
double worst_error(const ImplicitBody& body, int resolution) {
  Progress progress;
  const double cell = cell_size(body, resolution);
  const BodyBricks bricks = sample_body(body, cell, {}, "", progress);
  double worst = 0;
  for (const BrickChunk& chunk : bricks.grid.chunks) {
    for (std::size_t brick = 0; brick < chunk.at.size(); ++brick) {
      for (int k = static_cast<int>(brick % 5); k < kBrickSize; k += 5) {
        const glm::ivec3 corner(k % kBrickSide, k / kBrickSide % kBrickSide, k / (kBrickSide * kBrickSide));
        const double value = body.value(bricks.grid.position(kBrickSide * chunk.at[brick] + corner));
        const double found = chunk.values_of(brick)[k];
        // Away from the surface, only the sign counts.
        if (std::abs(value) > 2 * cell || std::abs(found) == static_cast<float>(cell)) continue;
        worst = std::max(worst, std::abs(found - value) / cell);
      }
    }
  }
  return worst;
}

TEST(Isosurface, HierarchyAgreesWithEverything) {
  const RandomKey key(41);
  for (std::uint64_t k = 0; k < 4; ++k) {
    for (const double width : {0.0, 0.05, 0.5, 4.0}) {
      EXPECT_LT(worst_error(blended_chain(key.child(k), BlendKind::poly, width), 60), 1e-4) << k << " " << width;
      if (k > 0) continue;
      EXPECT_LT(worst_error(blended_chain(key.child(k), BlendKind::root, width), 40), 1e-3) << k << " " << width;
      EXPECT_LT(worst_error(blended_chain(key.child(k), BlendKind::pasko, width), 40), 1e-3) << k << " " << width;
    }
  }
}

TEST(Isosurface, HierarchyAgreesWithEverythingForTheWorstRows) {
  for (const double width : {0.2, 1.0, 5.0}) {
    EXPECT_LT(worst_error(blended_row(BlendKind::poly, width), 40), 1e-4) << width;
    EXPECT_LT(worst_error(blended_row(BlendKind::root, width), 30), 1e-3) << width;
    EXPECT_LT(worst_error(blended_row(BlendKind::pasko, width), 30), 1e-3) << width;
  }
}

TEST(Isosurface, HierarchyAgreesWithEverythingForLongBodies) {
  ImplicitBody trunk = ImplicitBody::flat_cone({0, 0, 0}, 0.01, {1, 3, 2}, 0.007);
  trunk.blend(ImplicitBody::round_cone({0, 0, 0}, 0.008, {3, 1, 2}, 0), BlendKind::poly, 0.01);
  trunk.unite(ImplicitBody::box(frame_along({1, 1, 1}, glm::normalize(Vec3(1, 2, 1)), kUp), {0.02F, 1.5F, 0.01F}));
  trunk.unite(
      ImplicitBody::ellipsoid(frame_along({2, 1, 1}, glm::normalize(Vec3(1, 1, 1)), kUp), {0.01F, 1.2F, 0.02F}));
  for (const int resolution : {50, 300, 1000}) EXPECT_LT(worst_error(trunk, resolution), 1e-4) << resolution;
}

/// Returns all values of a body's grid.
SampledField dense_field(const ImplicitBody& body, int resolution) {
  Progress progress;
  SampledField field{.spacing = cell_size(body, resolution)};
  field.origin = sample_body(body, field.spacing, {}, "", progress).grid.origin;
  field.size = glm::ivec3(glm::ceil((body.high() + body.reach() - field.origin) / field.spacing)) + 2;
  for (int z = 0; z < field.size.z; ++z) {
    for (int y = 0; y < field.size.y; ++y) {
      for (int x = 0; x < field.size.x; ++x) {
        field.values.push_back(static_cast<float>(body.value(field.origin + field.spacing * DVec3(x, y, z))));
      }
    }
  }
  return field;
}

TEST(Isosurface, MissesNoSurface) {
  for (std::uint64_t k = 0; k < 60; ++k) {
    const ImplicitBody body =
        k % 10 == 0 ? blended_chain(RandomKey(42).child(k), BlendKind::poly, 0.3) : random_body(RandomKey(43).child(k));
    const Mesh mesh = surface_of(body, {.resolution = 20, .normals = false});
    if (!(cell_size(body, 20) > 0)) continue;  // balls without common space
    const Mesh dense = surface_of(dense_field(body, 20));
    if (dense.triangles.empty() && mesh.triangles.empty()) continue;
    // Rounding can change the sign of values near 0.
    EXPECT_NEAR(signed_volume(mesh), signed_volume(dense), 1e-4 * signed_volume(dense)) << k;
    EXPECT_NEAR(static_cast<double>(mesh.vertex_count()) / dense.vertex_count(), 1, 0.05) << k;
    EXPECT_EQ(euler_number(mesh), euler_number(dense)) << k;
  }
}

TEST(Isosurface, HasTheSameBytesOnAnyNumberOfThreads) {
  const ImplicitBody body = blended_chain(RandomKey(44), BlendKind::poly, 0.2);
  const Mesh expected = surface_of(body, {.resolution = 120});
  const SampledField field = field_of(40, [](DVec3 p) { return std::sin(p.x) + std::sin(p.y) + std::sin(p.z); });
  const Mesh expected_field = surface_of(field);
  EXPECT_TRUE(check_mesh(expected_field));
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    const Mesh mesh = surface_of(body, {.resolution = 120});
    EXPECT_EQ(mesh.positions, expected.positions) << threads;
    EXPECT_EQ(mesh.normals, expected.normals) << threads;
    EXPECT_EQ(mesh.triangles, expected.triangles) << threads;
    const Mesh mesh_of_field = surface_of(field);
    EXPECT_EQ(mesh_of_field.positions, expected_field.positions) << threads;
    EXPECT_EQ(mesh_of_field.triangles, expected_field.triangles) << threads;
  }
}

TEST(Isosurface, TakesResolutionsOf10To1024) {
  const ImplicitBody rod = ImplicitBody::capsule({}, {0, 1, 0}, 0.005);
  for (const int resolution : {10, 1024}) EXPECT_NO_THROW(surface_of(rod, {.resolution = resolution}));
  for (const int resolution : {-1, 0, 9, 1025}) {
    EXPECT_THROW(surface_of(rod, {.resolution = resolution}), std::invalid_argument) << resolution;
  }
  EXPECT_TRUE(check_mesh(surface_of(rod, {.resolution = 1024})));
}

std::string error_of(const ImplicitBody& body, const SizeLimits& limits) {
  try {
    surface_of(body, {.resolution = 100}, limits);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Isosurface, LimitsAreFaultsAtThePath) {
  const ImplicitBody ball = ImplicitBody::sphere({}, 1);
  EXPECT_EQ(error_of(ball, {}), "no error");
  const std::string triangles = error_of(ball, {.triangles = 1000});
  EXPECT_EQ(triangles.find("components.tree.surface.resolution: "), 0U) << triangles;
  EXPECT_NE(triangles.find("limits.triangles"), std::string::npos) << triangles;
  std::string bytes;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    const std::string error = error_of(ball, {.mesh_bytes = 100'000});
    EXPECT_EQ(error.find("components.tree.surface.resolution: "), 0U) << error;
    EXPECT_NE(error.find("limits.mesh_bytes"), std::string::npos) << error;
    if (threads > 1) {
      EXPECT_EQ(error, bytes);
    }
    bytes = error;
  }
  EXPECT_THROW(surface_of(field_of(20, [](DVec3) { return -1; }), 0, {.mesh_bytes = 20'000}), InputError);
  EXPECT_THROW(surface_of(field_of(20, [](DVec3) { return -1; }), 0, {.triangles = 1000}), InputError);
}

TEST(Isosurface, StopsWhenAskedInEachStage) {
  const ImplicitBody body = blended_chain(RandomKey(45), BlendKind::poly, 0.2);
  Progress before;
  before.cancel();
  EXPECT_THROW(extract_isosurface(body, {}, {}, "", before), Cancelled);
  Progress* told = nullptr;
  Progress first([&](std::string_view, double) { told->cancel(); });
  told = &first;
  EXPECT_THROW(extract_isosurface(body, {.resolution = 1024}, {}, "", first), Cancelled);
  Progress other;
  std::thread canceller([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    other.cancel();
  });
  EXPECT_THROW(extract_isosurface(body, {.resolution = 1024}, {}, "", other), Cancelled);
  canceller.join();
  EXPECT_THROW(extract_isosurface(field_of(20, [](DVec3 p) { return p.x; }), 0, {}, "", before), Cancelled);
}

TEST(Isosurface, HasTheSameTopologyFarFromTheOrigin) {
  const DVec3 far(1e5, -1e5, 1e5);
  ImplicitBody body = ring(100, 20);
  body.blend(ImplicitBody::sphere({100, 30, 0}, 30), BlendKind::poly, 10);
  ImplicitBody moved = ring(100, 20, far);
  moved.blend(ImplicitBody::sphere(far + DVec3(100, 30, 0), 30), BlendKind::poly, 10);
  for (const int resolution : {20, 200}) {
    const Mesh mesh = surface_of(body, {.resolution = resolution});
    const Mesh other = surface_of(moved, {.resolution = resolution});
    EXPECT_TRUE(check_mesh(other)) << resolution;
    EXPECT_EQ(other.triangles, mesh.triangles) << resolution;
    EXPECT_EQ(euler_number(other), 0) << resolution;
  }
}

}  // namespace meristem::isosurface_test
