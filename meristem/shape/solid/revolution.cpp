// SPDX-License-Identifier: Apache-2.0
// Turns a silhouette about the axis. Each edge of the silhouette's chain becomes a band of quads, or of triangles at
// the axis. The flat sides of a wedge are the polygon of chain and axis.
#include "meristem/shape/solid/revolution.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "meristem/base/math.h"
#include "meristem/shape/flat/cut_polygon.h"
#include "meristem/shape/solid/silhouette.h"

namespace meristem {
namespace {

using Point = glm::dvec2;

constexpr double kWholeTurn = 1e-9;  // radians

class RevolutionMesher {
 public:
  explicit RevolutionMesher(const SolidOfRevolution& solid)
      : chain_(silhouette_chain(solid)),
        sweep_(std::min(solid.sweep, 2 * kPi)),
        is_whole_(sweep_ > 2 * kPi - kWholeTurn),
        columns_(is_whole_ ? solid.segments
                           : static_cast<int>(std::ceil(solid.segments * sweep_ / (2 * kPi) - kWholeTurn))) {}

  Mesh run() {
    double length = 0;
    for (std::size_t k = 0; k + 1 < chain_.size(); ++k) length += glm::distance(chain_[k].at, chain_[k + 1].at);
    double along = 0;
    std::uint32_t upper = 0;
    for (std::size_t k = 0; k + 1 < chain_.size(); ++k) {
      const SilhouetteCorner& low = chain_[k];
      const bool is_smooth = k > 0 && low.arriving == low.leaving;
      const std::uint32_t lower = is_smooth ? upper : add_row(low.at, low.leaving, along / length);
      along += glm::distance(low.at, chain_[k + 1].at);
      upper = add_row(chain_[k + 1].at, chain_[k + 1].arriving, along / length);
      add_band(lower, upper, k == 0, k + 2 == chain_.size());
    }
    if (!is_whole_) add_sides();
    return std::move(mesh_);
  }

  std::size_t triangle_count() const {
    const std::size_t bands = chain_.size() - 1;
    // The first and the last band end on the axis and have one triangle for each column.
    const std::size_t round = static_cast<std::size_t>(columns_) * (2 * bands - 2);
    return round + (is_whole_ ? 0 : 2 * cut_polygon(in_unit_square(corners_of(chain_)), {}).size());
  }

 private:
  /// Returns the direction away from the axis after a number of half columns. Whole turns give the same bytes as none.
  DVec3 outward(int halves) const {
    if (is_whole_) halves %= 2 * columns_;
    const double angle = sweep_ * halves / (2 * columns_);
    return {math::sin(angle), 0, math::cos(angle)};
  }

  static DVec3 turned(Point point, DVec3 outward) { return point.x * outward + DVec3(0, point.y, 0); }

  std::uint32_t add_vertex(DVec3 position, DVec3 normal, Point uv) {
    mesh_.positions.emplace_back(position);
    mesh_.normals.emplace_back(normal);
    mesh_.uvs.emplace_back(uv);
    return static_cast<std::uint32_t>(mesh_.vertex_count() - 1);
  }

  /// Adds a vertex for each border of a column, or on the axis for the middle of each column. Returns the number of the
  /// first.
  std::uint32_t add_row(Point at, Point direction, double v) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertex_count());
    const bool is_pole = at.x == 0;
    const Point normal{direction.y, -direction.x};
    for (int k = 0; k < columns_ + (is_pole ? 0 : 1); ++k) {
      const int halves = is_pole ? 2 * k + 1 : 2 * k;
      const DVec3 out = outward(halves);
      add_vertex(turned(at, out), turned(normal, out), {sweep_ / (2 * kPi) * halves / (2 * columns_), v});
    }
    return first;
  }

  void add_band(std::uint32_t lower, std::uint32_t upper, bool is_lower_pole, bool is_upper_pole) {
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(columns_); ++k) {
      if (!is_lower_pole) mesh_.triangles.push_back({lower + k, lower + k + 1, upper + k + (is_upper_pole ? 0 : 1)});
      if (!is_upper_pole) mesh_.triangles.push_back({lower + k, upper + k + 1, upper + k});
    }
  }

  /// Returns the corners of a flat side in the unit square, where flat and slim bodies are cut as well as others.
  static std::vector<Point> in_unit_square(const std::vector<Point>& corners) {
    Point low = corners[0], high = corners[0];
    for (const Point corner : corners) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
    std::vector<Point> pictured;
    for (const Point corner : corners) pictured.push_back((corner - low) / (high - low));
    return pictured;
  }

  void add_sides() {
    const std::vector<Point> corners = corners_of(chain_);
    const std::vector<Point> pictured = in_unit_square(corners);
    const std::vector<FlatTriangle> triangles = cut_polygon(pictured, {});
    for (const bool is_first : {true, false}) {
      const DVec3 out = outward(is_first ? 0 : 2 * columns_);
      const DVec3 ahead{out.z, 0, -out.x};
      const auto first = static_cast<std::uint32_t>(mesh_.vertex_count());
      for (std::size_t k = 0; k < corners.size(); ++k) {
        add_vertex(turned(corners[k], out), is_first ? -ahead : ahead, pictured[k]);
      }
      const auto index = [&](Point point) {
        const auto found = std::find(pictured.begin(), pictured.end(), point);
        return first + static_cast<std::uint32_t>(found - pictured.begin());
      };
      for (const auto& [a, b, c] : triangles) {
        mesh_.triangles.push_back({index(a), index(is_first ? b : c), index(is_first ? c : b)});
      }
    }
  }

  std::vector<SilhouetteCorner> chain_;
  double sweep_;
  bool is_whole_;
  int columns_;
  Mesh mesh_;
};

}  // namespace

namespace {

void check(const SolidOfRevolution& solid) {
  if (solid.segments < 3) throw std::invalid_argument("a body of revolution needs at least 3 segments");
  if (solid.rings < 1) throw std::invalid_argument("a body of revolution needs at least 1 ring");
  if (!(solid.sweep > 0) || !std::isfinite(solid.sweep)) {
    throw std::invalid_argument("a body of revolution needs a sweep above 0");
  }
  if (const auto error = find_error(solid)) throw std::invalid_argument(error->message);
}

}  // namespace

Mesh make_revolution(const SolidOfRevolution& solid) {
  check(solid);
  return RevolutionMesher(solid).run();
}

std::size_t revolution_triangles(const SolidOfRevolution& solid) {
  check(solid);
  return RevolutionMesher(solid).triangle_count();
}

}  // namespace meristem
