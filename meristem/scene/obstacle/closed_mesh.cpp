// SPDX-License-Identifier: Apache-2.0
// Decides exactly whether a point is inside a closed mesh. A vertical line rises from the point. Every triangle above
// the point counts +1 or -1, depending on its orientation. On ties the point is treated as moved by (e, e^3, e^2) with
// infinitely small e, for all triangles alike. The line therefore never meets an edge or a vertex and never runs along
// a face.
//
// Triangles are found through grids over x and z of 1, 4, 16, ... cells. Each triangle is in the finest grid whose
// cells are as large as the triangle, hence in at most four cells. A query reads one cell per grid. Memory is linear,
// independent of the size of the triangles.
//
// Based on: H. Edelsbrunner, E. Mücke, Simulation of simplicity (1990).
#include "meristem/scene/obstacle/closed_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "meristem/base/reading_stop.h"
#include "meristem/base/vec.h"

namespace meristem {

namespace {

__extension__ using Wide = __int128;

constexpr int kGridBits = 26;
constexpr int kMaxLevels = 12;
constexpr double kSteps = 1 << kGridBits;

template <class T>
int sign(T value) {
  return (value > 0) - (value < 0);
}

/// Returns the side of the line from a to b, seen along y, on which the moved point lies. Returns 0 only if a and b are
/// equal.
int side_of(const std::array<std::int32_t, 3>& a, const std::array<std::int32_t, 3>& b,
            const std::array<std::int32_t, 3>& point) {
  const std::int64_t x = std::int64_t{b[0]} - a[0];
  const std::int64_t z = std::int64_t{b[2]} - a[2];
  const std::int64_t turn = x * (std::int64_t{point[2]} - a[2]) - z * (std::int64_t{point[0]} - a[0]);
  if (turn != 0) return sign(turn);
  return z != 0 ? -sign(z) : sign(x);
}

std::int32_t cell_of(std::int32_t coordinate, int level) {
  return std::min(coordinate >> (kGridBits - level), (1 << level) - 1);
}

std::size_t cell_index(std::int32_t x, std::int32_t z, int level) {
  return (static_cast<std::size_t>(z) << static_cast<unsigned>(level)) + static_cast<std::size_t>(x);
}

}  // namespace

ClosedMesh::ClosedMesh(const TriangleMesh& mesh) : positions_(mesh.positions), triangles_(mesh.triangles) {
  StopCounter stop;
  for (const auto& triangle : triangles_) {
    stop.step();
    for (const std::uint32_t vertex : triangle) {
      if (vertex >= positions_.size()) throw std::invalid_argument("closed mesh: an index is out of range");
    }
  }
  if (positions_.empty()) return;
  low_ = positions_[0];
  DVec3 high = low_;
  for (const DVec3 position : positions_) {
    stop.step();
    low_ = glm::min(low_, position);
    high = glm::max(high, position);
  }
  for (int k = 0; k < 3; ++k) steps_[k] = high[k] > low_[k] ? kSteps / (high[k] - low_[k]) : 0;
  snapped_.reserve(positions_.size());
  for (const DVec3 position : positions_) {
    stop.step();
    Grid3& snapped = snapped_.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const double steps = std::floor((position[k] - low_[k]) * steps_[k] + 0.5);
      snapped[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(std::clamp(steps, 0.0, kSteps));
    }
  }
  double sum = 0;
  for (const auto& [a, b, c] : triangles_) {
    stop.step();
    sum += glm::dot(positions_[a] - low_, glm::cross(positions_[b] - low_, positions_[c] - low_));
  }
  volume_ = std::abs(sum) / 6;
  build_levels();
}

void ClosedMesh::build_levels() {
  int finest = 0;
  while (finest < kMaxLevels && (std::size_t{1} << (2 * finest)) < triangles_.size()) ++finest;
  // Finds the level and the cells of a triangle.
  StopCounter stop;
  const auto for_cells = [&](const std::array<std::uint32_t, 3>& triangle, auto&& see) {
    stop.step();
    const Grid3& a = snapped_[triangle[0]];
    const Grid3& b = snapped_[triangle[1]];
    const Grid3& c = snapped_[triangle[2]];
    const auto [x_low, x_high] = std::minmax({a[0], b[0], c[0]});
    const auto [z_low, z_high] = std::minmax({a[2], b[2], c[2]});
    const std::int32_t extent = std::max(x_high - x_low, z_high - z_low);
    int level = finest;
    while (level > 0 && (1 << (kGridBits - level)) < extent) --level;
    for (std::int32_t z = cell_of(z_low, level); z <= cell_of(z_high, level); ++z) {
      for (std::int32_t x = cell_of(x_low, level); x <= cell_of(x_high, level); ++x) {
        see(levels_[static_cast<std::size_t>(level)], cell_index(x, z, level));
      }
    }
  };

  // Count the triangles of each cell, sum up the counts, and fill in the triangles.
  levels_.resize(static_cast<std::size_t>(finest) + 1);
  for (int level = 0; level <= finest; ++level) {
    levels_[static_cast<std::size_t>(level)].begin.resize((std::size_t{1} << (2 * level)) + 1);
  }
  for (const auto& triangle : triangles_) {
    for_cells(triangle, [](Level& level, std::size_t cell) { ++level.begin[cell + 1]; });
  }
  for (Level& level : levels_) {
    for (std::size_t cell = 1; cell < level.begin.size(); ++cell) level.begin[cell] += level.begin[cell - 1];
    level.triangles.resize(level.begin.back());
  }
  for (std::size_t k = triangles_.size(); k-- > 0;) {
    // From the last to the first triangle, so that each cell's end moves down to its begin.
    for_cells(triangles_[k], [k](Level& level, std::size_t cell) {
      level.triangles[--level.begin[cell + 1]] = static_cast<std::uint32_t>(k);
    });
  }
  for (Level& level : levels_) {
    // Now begin[cell + 1] is the begin of the cell.
    std::rotate(level.begin.begin(), level.begin.begin() + 1, level.begin.end());
    level.begin.back() = static_cast<std::uint32_t>(level.triangles.size());
  }
}

int ClosedMesh::winding_number(DVec3 point) const {
  if (levels_.empty()) return 0;
  Grid3 snapped{};
  for (int k = 0; k < 3; ++k) {
    const double steps = std::floor((point[k] - low_[k]) * steps_[k] + 0.5);
    if (!(steps >= 0 && steps <= kSteps)) return 0;
    snapped[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(steps);
  }
  int winding = 0;
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    const int level = static_cast<int>(k);
    const auto cell = cell_index(cell_of(snapped[0], level), cell_of(snapped[2], level), level);
    for (std::uint32_t t = levels_[k].begin[cell]; t < levels_[k].begin[cell + 1]; ++t) {
      add_crossing(triangles_[levels_[k].triangles[t]], snapped, winding);
    }
  }
  return winding;
}

void ClosedMesh::add_crossing(const std::array<std::uint32_t, 3>& triangle, const Grid3& point, int& winding) const {
  const Grid3& a = snapped_[triangle[0]];
  const Grid3& b = snapped_[triangle[1]];
  const Grid3& c = snapped_[triangle[2]];
  if (a[1] < point[1] && b[1] < point[1] && c[1] < point[1]) return;
  const int side = side_of(a, b, point);
  if (side == 0 || side != side_of(b, c, point) || side != side_of(c, a, point)) return;

  // Compute the triangle's normal, and the distance of the point along it.
  std::array<std::int64_t, 3> u{};
  std::array<std::int64_t, 3> v{};
  std::array<std::int64_t, 3> w{};
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = std::int64_t{b[k]} - a[k];
    v[k] = std::int64_t{c[k]} - a[k];
    w[k] = std::int64_t{point[k]} - a[k];
  }
  const std::int64_t x = u[1] * v[2] - u[2] * v[1];
  const std::int64_t y = u[2] * v[0] - u[0] * v[2];
  const std::int64_t z = u[0] * v[1] - u[1] * v[0];
  const Wide along = Wide{x} * w[0] + Wide{y} * w[1] + Wide{z} * w[2];
  int before = sign(along);
  if (before == 0) before = x != 0 ? sign(x) : z != 0 ? sign(z) : sign(y);
  // The triangle is above if the point is behind an upward face or in front of a downward one.
  if (before != sign(y)) winding += sign(y);
}

}  // namespace meristem
