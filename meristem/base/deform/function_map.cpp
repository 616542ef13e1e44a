// SPDX-License-Identifier: Apache-2.0
// Maps points by expressions of their coordinates. Blocks of points are evaluated together with the slopes of the
// expressions, and these slopes are the map's Jacobian.
#include "meristem/base/deform/function_map.h"

#include <algorithm>
#include <cassert>

namespace meristem {

namespace {

constexpr std::size_t kPointsTogether = 512;  // number of points that are mapped together

}  // namespace

const std::vector<std::string>& FunctionMap::coordinate_names() {
  static const std::vector<std::string> names{"x", "y", "z"};
  return names;
}

FunctionMap::FunctionMap(std::array<std::optional<Expression>, 3> functions, std::vector<double> others, RandomKey key)
    : functions_(std::move(functions)), others_(std::move(others)), key_(key) {}

void FunctionMap::map(std::span<DVec3> points, std::span<DMat3> jacobians) const {
  assert(points.size() == jacobians.size());
  if (points.empty()) return;
  const std::size_t lanes = std::min(points.size(), kPointsTogether);
  // The coordinates as columns, then the values that are equal at all points.
  std::vector<double> coordinates(3 * lanes);
  std::vector<double> constants(others_.size() * lanes);
  std::vector<const double*> variables;
  for (std::size_t k = 0; k < 3; ++k) variables.push_back(coordinates.data() + k * lanes);
  for (std::size_t k = 0; k < others_.size(); ++k) {
    std::fill_n(constants.begin() + static_cast<std::ptrdiff_t>(k * lanes), lanes, others_[k]);
    variables.push_back(constants.data() + k * lanes);
  }
  const std::vector<RandomKey> keys(lanes, key_);
  std::vector<double> results(4 * lanes);
  const std::array<std::size_t, 3> by{0, 1, 2};
  const std::array<double*, 3> slopes{&results[lanes], &results[2 * lanes], &results[3 * lanes]};

  for (std::size_t begin = 0; begin < points.size(); begin += lanes) {
    const std::size_t count = std::min(lanes, points.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      for (int k = 0; k < 3; ++k) coordinates[static_cast<std::size_t>(k) * lanes + i] = points[begin + i][k];
      jacobians[begin + i] = DMat3(1);
    }
    for (int row = 0; row < 3; ++row) {
      const std::optional<Expression>& function = functions_[static_cast<std::size_t>(row)];
      if (!function) continue;
      function->evaluate_with_slopes(count, variables, keys, results.data(), by, slopes);
      for (std::size_t i = 0; i < count; ++i) {
        points[begin + i][row] = results[i];
        for (int k = 0; k < 3; ++k) jacobians[begin + i][k][row] = slopes[static_cast<std::size_t>(k)][i];
      }
    }
  }
}

void FunctionMap::add_to(Fingerprint& fingerprint) const {
  for (const std::optional<Expression>& function : functions_) fingerprint.add(function ? function->hash() : 0);
  fingerprint.add_array(others_).add(key_.bits());
}

}  // namespace meristem
