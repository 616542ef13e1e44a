// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/implicit/mesh_field.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "tests/support/check_mesh.h"
#include "tests/support/check_printable.h"

namespace meristem::mesh_field_test {

/// Returns a box as a closed mesh.
TriangleMesh block(DVec3 low, DVec3 high) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k) {
    mesh.positions.emplace_back(k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z);
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

Mesh combine(MeshOperation operation, const TriangleMesh& a, const TriangleMesh& b, int resolution = 60) {
  Progress progress;
  return combine_meshes(operation, a, b, {.resolution = resolution}, SizeLimits(), progress);
}

// Two cubes of 1 m³, of which an eighth is common.
const TriangleMesh kFirst = block({0, 0, 0}, {1, 1, 1});
const TriangleMesh kSecond = block({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5});

TEST(MeshField, VolumesOfSetOperationsAreThoseOfTheBlocks) {
  ASSERT_TRUE(closedness_errors(kFirst).empty());
  const auto volume = [](MeshOperation operation) {
    const Mesh mesh = combine(operation, kFirst, kSecond);
    EXPECT_TRUE(check_mesh(mesh));
    EXPECT_TRUE(check_printable(mesh));
    return signed_volume(mesh);
  };
  EXPECT_NEAR(volume(MeshOperation::unite), 1.875, 0.02);
  EXPECT_NEAR(volume(MeshOperation::intersect), 0.125, 0.003);
  EXPECT_NEAR(volume(MeshOperation::subtract), 0.875, 0.01);
}

TEST(MeshField, DistancesAreExactNearTheSurface) {
  Progress progress;
  const double spacing = 0.05;
  const SampledField field = mesh_distances(kFirst, {30, 30, 30}, {-0.2, -0.2, -0.2}, spacing, progress);
  for (int k = 0; k < 30 * 30 * 30; k += 7) {
    const DVec3 p = field.origin + spacing * DVec3(k % 30, k / 30 % 30, k / 900);
    const DVec3 out = glm::abs(p - 0.5) - 0.5;
    const double inner = std::min(std::max({out.x, out.y, out.z}), 0.0);
    const double wanted = glm::length(glm::max(out, 0.0)) + inner;
    ASSERT_NEAR(field.values[k], std::clamp(wanted, -3 * spacing, 3 * spacing), 1e-5)
        << p.x << " " << p.y << " " << p.z;
  }
}

TEST(MeshField, BodiesApartHaveNothingInCommonAndStandAloneInAUnion) {
  const TriangleMesh away = block({3, 0, 0}, {4, 1, 1});
  EXPECT_EQ(combine(MeshOperation::intersect, kFirst, away).triangle_count(), 0U);
  EXPECT_EQ(euler_number(combine(MeshOperation::unite, kFirst, away)), 4);
  EXPECT_NEAR(signed_volume(combine(MeshOperation::subtract, kFirst, away)), 1, 0.01);
  // A hole through a block makes a ring.
  const TriangleMesh rod = block({0.3, 0.3, -1}, {0.7, 0.7, 2});
  EXPECT_EQ(euler_number(combine(MeshOperation::subtract, kFirst, rod)), 0);
}

TEST(MeshField, HasTheSameBytesOnAnyNumberOfThreads) {
  std::vector<Vec3> alone;
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    const Mesh mesh = combine(MeshOperation::unite, kFirst, kSecond, 40);
    if (threads == 1) alone = mesh.positions;
    EXPECT_EQ(mesh.positions, alone) << threads;
  }
}

TEST(MeshField, LimitsAndResolutionsAreChecked) {
  Progress progress;
  const SizeLimits tight{.mesh_bytes = 100'000};
  try {
    combine_meshes(MeshOperation::unite, kFirst, kSecond, {.resolution = 100, .path = "--resolution"}, tight, progress);
    FAIL() << "the limit is exceeded";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().front().path, "--resolution");
  }
  EXPECT_THROW(combine(MeshOperation::unite, kFirst, kSecond, 9), std::invalid_argument);
}

}  // namespace meristem::mesh_field_test
