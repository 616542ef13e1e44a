// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/mesh/simplify.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/check_mesh.h"
#include "tests/support/field_mesh.h"
#include "tests/support/sample_bodies.h"

namespace meristem::simplify_test {

/// Returns a sphere, with 32,768 triangles at 6 splits.
Mesh sphere(int splits, Vec3 centre = Vec3(0)) {
  Mesh mesh;
  const TriangleMesh body = sphere_mesh(splits);
  for (const DVec3 position : body.positions) mesh.positions.push_back(Vec3(position) + centre);
  mesh.triangles = body.triangles;
  return mesh;
}

Mesh torus(double tube) {
  const Box box{Vec3(-1.5F, -0.5F, -1.5F), Vec3(1.5F, 0.5F, 1.5F)};
  return field_mesh([&](Vec3 p) { return static_cast<float>(std::hypot(std::hypot(p.x, p.z) - 1, p.y) - tube); }, box,
                    60);
}

/// Returns a closed prism of rows of triangles, with `sides` sides.
Mesh prism(std::uint32_t sides, std::uint32_t rows, double radius) {
  Mesh mesh;
  for (std::uint32_t row = 0; row <= rows; ++row) {
    for (std::uint32_t k = 0; k < sides; ++k) {
      const double angle = 2 * kPi * k / sides;
      mesh.positions.emplace_back(radius * std::sin(angle), static_cast<double>(row) / rows, radius * std::cos(angle));
    }
  }
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t a = row * sides + k;
      const std::uint32_t b = row * sides + (k + 1) % sides;
      mesh.triangles.push_back({a, b, b + sides});
      mesh.triangles.push_back({a, b + sides, a + sides});
    }
  }
  for (std::uint32_t k = 1; k + 1 < sides; ++k) {
    mesh.triangles.push_back({0, k + 1, k});
    mesh.triangles.push_back({rows * sides, rows * sides + k, rows * sides + k + 1});
  }
  return mesh;
}

Mesh simplified(const Mesh& mesh, const SimplifyTarget& target) {
  Progress progress;
  return simplify(mesh, target, progress);
}

TEST(Simplify, KeepsASphereASphere) {
  const Mesh original = sphere(5);
  for (const std::size_t triangles : {4000, 1000, 100, 20, 8, 4}) {
    const Mesh mesh = simplified(original, {triangles});
    EXPECT_LE(mesh.triangle_count(), triangles);
    EXPECT_TRUE(check_mesh(mesh)) << triangles;
    EXPECT_EQ(euler_number(mesh), 2) << triangles;
  }
}

TEST(Simplify, LeavesATetrahedronAtLeast) { EXPECT_EQ(simplified(sphere(3), {0}).triangle_count(), 4U); }

TEST(Simplify, KeepsTheHoleOfATorus) {
  const Mesh original = torus(0.3);
  for (const std::size_t triangles : {2000, 200, 50, 0}) {
    const Mesh mesh = simplified(original, {triangles});
    EXPECT_LE(mesh.triangle_count(), std::max<std::size_t>(triangles, 60));
    EXPECT_TRUE(check_mesh(mesh)) << triangles;
    EXPECT_EQ(euler_number(mesh), 0) << triangles;
  }
}

TEST(Simplify, KeepsEachComponent) {
  Mesh mesh = sphere(4);
  const Mesh other = sphere(3, Vec3(4, 0, 0));
  const auto offset = static_cast<std::uint32_t>(mesh.vertex_count());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({a + offset, b + offset, c + offset});
  for (const std::size_t triangles : {500, 60, 0}) {
    const Mesh less = simplified(mesh, {triangles});
    EXPECT_TRUE(check_mesh(less));
    EXPECT_EQ(euler_number(less), 4);
  }
  EXPECT_EQ(simplified(mesh, {0}).triangle_count(), 8U);
}

TEST(Simplify, KeepsTheFormOfASphere) {
  const Mesh mesh = simplified(sphere(6), {400});
  EXPECT_NEAR(signed_volume(mesh), 4 * kPi / 3, 0.02 * 4 * kPi / 3);
  EXPECT_NEAR(surface_area(mesh), 4 * kPi, 0.02 * 4 * kPi);
}

TEST(Simplify, StaysWithinTheErrorOfASphere) {
  const Mesh original = sphere(6);
  std::size_t last = original.triangle_count();
  for (const float error : {0.0005F, 0.002F, 0.01F, 0.05F}) {
    const Mesh mesh = simplified(original, {.error = error});
    EXPECT_LT(mesh.triangle_count(), last);
    last = mesh.triangle_count();
    EXPECT_TRUE(check_mesh(mesh));
    double farthest = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3 middle = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0F;
      for (const Vec3 at : {middle, mesh.positions[a]})
        farthest = std::max<double>(farthest, std::abs(glm::length(at) - 1));
    }
    EXPECT_LT(farthest, error);
    EXPECT_GT(farthest, 0.5 * error);
  }
}

TEST(Simplify, LeavesOfABoxItsCorners) {
  // The planes of a grid are flat, so the result is the box, except for rounding.
  const Mesh original = prism(4, 40, 0.5);
  const Mesh mesh = simplified(original, {.error = 1e-3F});
  EXPECT_EQ(mesh.triangle_count(), 12U);
  EXPECT_NEAR(signed_volume(mesh), signed_volume(original), 1e-3);
}

TEST(Simplify, DoesNotFoldThinTubesFlat) {
  for (const std::uint32_t sides : {3U, 4U, 8U}) {
    for (const std::size_t triangles : {100, 30, 16, 0}) {
      const Mesh original = prism(sides, 50, 0.004);
      const Mesh mesh = simplified(original, {triangles});
      EXPECT_TRUE(check_mesh(mesh)) << sides << " sides, " << triangles;
      EXPECT_EQ(euler_number(mesh), 2);
      EXPECT_GT(signed_volume(mesh), 0.2 * signed_volume(original)) << sides << " sides, " << triangles;
    }
  }
}

TEST(Simplify, KeepsForkedTrunksClosed) {
  const Mesh original = capsule_mesh(forked_trunk(3), 0.02F, 150);
  for (const std::size_t triangles : {5000, 2000, 700, 300, 100, 0}) {
    const Mesh mesh = simplified(original, {triangles});
    EXPECT_TRUE(check_mesh(mesh)) << triangles;
    EXPECT_EQ(euler_number(mesh), euler_number(original)) << triangles;
  }
}

TEST(Simplify, KeepsCrownsClosed) {
  const Mesh original = capsule_mesh(sphere_crown(40), 0.05F, 50);
  for (const std::size_t triangles : {5000, 1000, 300, 100}) {
    const Mesh mesh = simplified(original, {triangles});
    EXPECT_LE(mesh.triangle_count(), triangles);
    EXPECT_TRUE(check_mesh(mesh)) << triangles;
    EXPECT_EQ(euler_number(mesh), euler_number(original)) << triangles;
    EXPECT_NEAR(signed_volume(mesh), signed_volume(original), 0.02 * signed_volume(original)) << triangles;
  }
}

TEST(Simplify, SweepsOverLargeMeshes) {
  const Mesh original = sphere(7);
  ASSERT_EQ(original.triangle_count(), 131'072U);
  for (const std::size_t triangles : {40'000, 500}) {
    const Mesh mesh = simplified(original, {triangles});
    EXPECT_EQ(mesh.triangle_count(), triangles);
    EXPECT_TRUE(check_mesh(mesh));
    EXPECT_EQ(euler_number(mesh), 2);
    EXPECT_NEAR(surface_area(mesh), surface_area(original), 0.02 * surface_area(original));
  }
}

TEST(Simplify, KeepsBordersInPlace) {
  // Half a sphere, whose border is the equator.
  Mesh mesh = sphere(5);
  std::erase_if(mesh.triangles, [&](const auto& t) {
    return mesh.positions[t[0]].y + mesh.positions[t[1]].y + mesh.positions[t[2]].y < 0;
  });
  const Mesh less = simplified(mesh, {300});
  EXPECT_LE(less.triangle_count(), 300U);
  EXPECT_TRUE(check_mesh(less, {.closed = false}));
  EXPECT_EQ(euler_number(less), 1);
  const auto on_equator = [](const Mesh& m) {
    return std::count_if(m.positions.begin(), m.positions.end(), [](Vec3 p) { return p.y == 0; });
  };
  EXPECT_EQ(on_equator(less), on_equator(mesh));
}

TEST(Simplify, LeavesEdgesOfManyTrianglesAlone) {
  // Three half planes meet in one edge.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  EXPECT_EQ(simplified(mesh, {0}).triangles, mesh.triangles);
}

TEST(Simplify, GivesBackWhatIsSmallEnough) {
  Mesh mesh = sphere(2);
  mesh.normals = mesh.positions;
  for (const std::size_t triangles : {mesh.triangle_count(), mesh.triangle_count() + 1}) {
    const Mesh same = simplified(mesh, {triangles});
    EXPECT_EQ(same.positions, mesh.positions);
    EXPECT_EQ(same.normals, mesh.normals);
    EXPECT_EQ(same.triangles, mesh.triangles);
  }
  EXPECT_EQ(simplified({}, {}).triangle_count(), 0U);
}

TEST(Simplify, MakesNormalsForThoseThereWere) {
  Mesh mesh = sphere(4);
  EXPECT_TRUE(simplified(mesh, {500}).normals.empty());
  mesh.normals = mesh.positions;
  const Mesh less = simplified(mesh, {500});
  EXPECT_TRUE(check_mesh(less));
  ASSERT_EQ(less.normals.size(), less.vertex_count());
}

TEST(Simplify, GrowsWithTheMesh) {
  // Powers of two change no digit.
  const Mesh original = capsule_mesh(forked_trunk(2), 0.02F, 60);
  Mesh large = original;
  for (Vec3& position : large.positions) position *= 4.0F;
  const Mesh small_less = simplified(original, {300});
  const Mesh large_less = simplified(large, {300});
  EXPECT_EQ(small_less.triangles, large_less.triangles);
}

TEST(Simplify, MakesLevelsOfDetailEachFromTheOneBefore) {
  const Mesh original = sphere(5);
  const std::vector<std::size_t> counts{100'000, 4000, 1000, 1000, 50};
  Progress progress;
  const std::vector<Mesh> levels = levels_of_detail(original, counts, progress);
  ASSERT_EQ(levels.size(), counts.size());
  EXPECT_EQ(levels[0].triangles, original.triangles);
  for (std::size_t k = 1; k < levels.size(); ++k) {
    EXPECT_LE(levels[k].triangle_count(), counts[k]);
    EXPECT_GE(levels[k].triangle_count() + 1, counts[k]);
    EXPECT_TRUE(check_mesh(levels[k]));
  }
  EXPECT_EQ(levels[1].triangles, simplified(original, {counts[1]}).triangles);
  EXPECT_EQ(levels[3].triangles, levels[2].triangles);
}

TEST(Simplify, StopsWhenAsked) {
  const Mesh mesh = sphere(5);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(simplify(mesh, {10}, progress), Cancelled);
  EXPECT_THROW(levels_of_detail(mesh, std::vector<std::size_t>{10}, progress), Cancelled);
}

TEST(Simplify, RejectsWhatItCannotKeep) {
  Mesh mesh = sphere(1);
  mesh.uvs.resize(mesh.vertex_count());
  EXPECT_THROW(simplified(mesh, {4}), std::invalid_argument);
  mesh = sphere(1);
  EXPECT_THROW(simplified(mesh, {.error = -1}), std::invalid_argument);
  mesh.triangles[3][1] = 1000;
  EXPECT_THROW(simplified(mesh, {4}), std::invalid_argument);
  mesh = sphere(1);
  mesh.positions[2].x = NAN;
  EXPECT_THROW(simplified(mesh, {4}), std::invalid_argument);
  Progress progress;
  EXPECT_THROW(levels_of_detail(sphere(1), std::vector<std::size_t>{4, 5}, progress), std::invalid_argument);
}

}  // namespace meristem::simplify_test
