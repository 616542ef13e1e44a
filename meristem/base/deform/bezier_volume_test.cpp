// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/deform/bezier_volume.h"

#include <stdexcept>

#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "tests/support/space_maps.h"

namespace meristem::bezier_volume_test {

const DVec3 kLow(-1, 0, -2);
const DVec3 kHigh(1, 4, 1);

/// Returns control points with irregular shifts.
std::vector<DVec3> shifted_points(const BezierVolume::Degree& degree, double by = 0.2) {
  std::vector<DVec3> points = BezierVolume::points_at_rest(kLow, kHigh, degree);
  const RandomKey key = RandomKey(3).child("shifts");
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      points[k][static_cast<int>(axis)] += by * (2 * key.uniform(3 * k + axis) - 1);
    }
  }
  return points;
}

BezierVolume shifted(const BezierVolume::Degree& degree) { return {kLow, kHigh, degree, shifted_points(degree)}; }

class BezierVolumes : public testing::TestWithParam<BezierVolume::Degree> {};

INSTANTIATE_TEST_SUITE_P(OfAllDegrees, BezierVolumes,
                         testing::Values(BezierVolume::Degree{1, 1, 1}, BezierVolume::Degree{2, 2, 2},
                                         BezierVolume::Degree{3, 3, 3}, BezierVolume::Degree{1, 3, 2},
                                         BezierVolume::Degree{3, 2, 1}));

TEST_P(BezierVolumes, AtRestAreTheIdentityInEveryBit) {
  expect_identity(BezierVolume(kLow, kHigh, GetParam(), BezierVolume::points_at_rest(kLow, kHigh, GetParam())));
}

TEST_P(BezierVolumes, HaveTheJacobianOfDifferencesInsideAndOutside) {
  expect_jacobian_of_differences(shifted(GetParam()));
}

TEST_P(BezierVolumes, TakeCornersToTheirControlPoints) {
  const BezierVolume::Degree degree = GetParam();
  const std::vector<DVec3> points = shifted_points(degree);
  const BezierVolume volume(kLow, kHigh, degree, points);
  EXPECT_LT(glm::distance(mapped_by(volume, kLow).point, points.front()), 1e-14);
  EXPECT_LT(glm::distance(mapped_by(volume, kHigh).point, points.back()), 1e-14);
  // The second corner is at the end of the first row, toward +x.
  const auto end_of_row = static_cast<std::size_t>(degree[0]);
  EXPECT_LT(glm::distance(mapped_by(volume, {kHigh.x, kLow.y, kLow.z}).point, points[end_of_row]), 1e-14);
  // The lowest layer ends at the corner toward +x and +z.
  const auto end_of_layer = static_cast<std::size_t>((degree[0] + 1) * (degree[2] + 1) - 1);
  EXPECT_LT(glm::distance(mapped_by(volume, {kHigh.x, kLow.y, kHigh.z}).point, points[end_of_layer]), 1e-14);
}

TEST_P(BezierVolumes, ReproduceEveryLinearMap) {
  const DMat3 matrix(DVec3(1.2, 0.1, 0), DVec3(-0.3, 0.9, 0.2), DVec3(0, 0.4, 1.1));
  std::vector<DVec3> points = BezierVolume::points_at_rest(kLow, kHigh, GetParam());
  for (DVec3& point : points) point = matrix * point + DVec3(1, 2, 3);
  const BezierVolume volume(kLow, kHigh, GetParam(), points);
  for (const DVec3& point : scattered_points()) {
    EXPECT_LT(glm::distance(mapped_by(volume, point).point, matrix * point + DVec3(1, 2, 3)), 1e-12);
  }
}

TEST_P(BezierVolumes, GoOnStraightBeyondTheBox) {
  const BezierVolume volume = shifted(GetParam());
  for (int axis = 0; axis < 3; ++axis) {
    DVec3 edge(0.2, 1.1, -0.3);
    edge[axis] = kHigh[axis];
    const Mapped at_edge = mapped_by(volume, edge);
    for (const double beyond : {0.5, 3.0}) {
      DVec3 point = edge;
      point[axis] += beyond;
      EXPECT_LT(glm::distance(mapped_by(volume, point).point, at_edge.point + beyond * at_edge.jacobian[axis]), 1e-12);
    }
  }
}

TEST(BezierVolume, OfDegree1IsTrilinearInterpolation) {
  const std::vector<DVec3> points = shifted_points({1, 1, 1});
  const BezierVolume volume(kLow, kHigh, {1, 1, 1}, points);
  for (const DVec3& point : scattered_points()) {
    const DVec3 t = (point - kLow) / (kHigh - kLow);
    const auto row = [&](std::size_t first) { return glm::mix(points[first], points[first + 1], t.x); };
    const DVec3 expected = glm::mix(glm::mix(row(0), row(2), t.z), glm::mix(row(4), row(6), t.z), t.y);
    EXPECT_LT(glm::distance(mapped_by(volume, point).point, expected), 1e-12);
  }
}

TEST(BezierVolume, OfARaisedDegreeIsTheSame) {
  // Writes a quadratic curve as a cubic curve: Q0, (Q0 + 2 Q1)/3, (2 Q1 + Q2)/3, Q2.
  const std::vector<DVec3> low = shifted_points({1, 2, 1});
  std::vector<DVec3> high;
  for (int layer = 0; layer < 4; ++layer) {
    for (std::size_t k = 0; k < 4; ++k) {
      const DVec3 a = low[k], b = low[4 + k], c = low[8 + k];
      high.push_back(layer == 0 ? a : layer == 1 ? (a + 2.0 * b) / 3.0 : layer == 2 ? (2.0 * b + c) / 3.0 : c);
    }
  }
  const BezierVolume quadratic(kLow, kHigh, {1, 2, 1}, low), cubic(kLow, kHigh, {1, 3, 1}, high);
  for (const DVec3& point : scattered_points()) {
    EXPECT_LT(glm::distance(mapped_by(quadratic, point).point, mapped_by(cubic, point).point), 1e-12);
  }
}

TEST(BezierVolume, APointsPlaceInABatchDoesNotMatter) { expect_same_in_batches(shifted({3, 3, 3})); }

TEST(BezierVolume, RefusesAnotherNumberOfPoints) {
  EXPECT_EQ(BezierVolume::point_count({1, 3, 2}), 24U);
  EXPECT_THROW(BezierVolume(kLow, kHigh, {1, 1, 1}, shifted_points({2, 1, 1})), std::invalid_argument);
}

TEST(BezierVolume, HasANumberForAllThatItDependsOn) {
  const std::uint64_t own = fingerprint_of(shifted({2, 2, 2}));
  EXPECT_EQ(own, fingerprint_of(shifted({2, 2, 2})));
  EXPECT_NE(own, fingerprint_of(BezierVolume(kLow, kHigh, {2, 2, 2}, shifted_points({2, 2, 2}, 0.1))));
  EXPECT_NE(own, fingerprint_of(BezierVolume(kLow, kHigh + 1.0, {2, 2, 2}, shifted_points({2, 2, 2}))));
}

}  // namespace meristem::bezier_volume_test
