// SPDX-License-Identifier: Apache-2.0
// Maps of space for tests, and properties that every map must have.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "meristem/base/deform/function_map.h"
#include "meristem/base/random.h"

namespace meristem {

/// Returns a map from three expressions. An empty one leaves its coordinate unchanged.
inline FunctionMap functions(const std::string& x, const std::string& y, const std::string& z) {
  std::array<std::optional<Expression>, 3> made;
  const std::array<std::string, 3> texts{x, y, z};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!texts[k].empty()) made[k] = Expression::compile(texts[k], {FunctionMap::coordinate_names(), {}});
  }
  return FunctionMap(std::move(made));
}

struct Mapped {
  DVec3 point{0};
  DMat3 jacobian{0};
};

inline Mapped mapped_by(const SpaceMap& map, DVec3 point) {
  DMat3 jacobian(0);
  map.map(std::span(&point, 1), std::span(&jacobian, 1));
  return {point, jacobian};
}

/// Returns random points in a box of 4 m around the origin.
inline std::vector<DVec3> scattered_points(std::size_t count = 100) {
  std::vector<DVec3> points;
  const RandomKey key = RandomKey(11).child("points");
  for (std::size_t k = 0; k < count; ++k) {
    const auto number = [&](std::uint64_t i) { return 4 * key.uniform(3 * k + i) - 2; };
    points.emplace_back(number(0), number(1), number(2));
  }
  return points;
}

/// Checks that the map changes no bit of any point and returns the exact identity as its Jacobian.
inline void expect_identity(const SpaceMap& map) {
  for (const DVec3& point : scattered_points()) {
    const Mapped found = mapped_by(map, point);
    EXPECT_EQ(found.point, point);
    EXPECT_EQ(found.jacobian, DMat3(1));
  }
}

inline void expect_jacobian_of_differences(const SpaceMap& map) {
  constexpr double kStep = 1e-5;
  for (const DVec3& point : scattered_points()) {
    const DMat3 found = mapped_by(map, point).jacobian;
    for (int k = 0; k < 3; ++k) {
      DVec3 above = point, below = point;
      above[k] += kStep;
      below[k] -= kStep;
      const DVec3 difference = (mapped_by(map, above).point - mapped_by(map, below).point) / (2 * kStep);
      EXPECT_LT(glm::distance(found[k], difference), 1e-6);
    }
  }
}

/// Checks that the result for a point does not depend on the other points of the batch.
inline void expect_same_in_batches(const SpaceMap& map) {
  const std::vector<DVec3> before = scattered_points(1500);
  std::vector<DVec3> points = before;
  std::vector<DMat3> jacobians(points.size());
  map.map(points, jacobians);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Mapped one = mapped_by(map, before[k]);
    EXPECT_EQ(points[k], one.point);
    EXPECT_EQ(jacobians[k], one.jacobian);
  }
}

inline std::uint64_t fingerprint_of(const SpaceMap& map) {
  Fingerprint fingerprint;
  map.add_to(fingerprint);
  return fingerprint.hash();
}

}  // namespace meristem
