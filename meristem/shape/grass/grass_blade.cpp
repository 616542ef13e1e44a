// SPDX-License-Identifier: Apache-2.0
// Builds the mesh of a grass blade as rows of points across the midrib. A section is an arc on either side, turned
// about the midrib's tangent by the torsion. Its vector is cos t * j + sin t * n, with j level across and n the
// midrib's normal, so its length stays. The source adds (cos t, 1, sin t), which changes the length and widens the
// leaf.
//
// Based on: Fournier and Pradal (2012), equations 3 to 7.
#include "meristem/shape/grass/grass_blade.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "meristem/base/math.h"
#include "meristem/shape/flat/arc.h"
#include "meristem/shape/mesh/shading.h"

namespace meristem {

namespace {

constexpr double kNoWidth = 1e-3;   // share of the largest width; a blade with a narrower end ends in a point
constexpr double kMinWidth = 1e-3;  // minimum width elsewhere
constexpr double kNoLength = 1e-6;  // in lengths; a shorter piece has no direction
constexpr double kMaxClasp = 2.8;   // radians; maximum bend of a half around a sheath
constexpr int kSheathSides = 14;
constexpr int kLiguleSides = 6;
constexpr double kLiguleArc = 2.4;      // radians
constexpr double kLiguleEnds = 0.1;     // share of the height in its middle
constexpr float kLiguleInside = 0.97F;  // radius of its inner face
constexpr double kSheathFoot = 0.94;    // radius at the lower end, as a share

class BladeRows {
 public:
  BladeRows(const GrassLeaf& leaf, const GrassBlade& blade) : leaf_(leaf), blade_(blade) {}

  Mesh run() {
    const std::size_t last = leaf_.point_count() - 1;
    const auto columns = static_cast<std::size_t>(blade_.across) + 1;
    mesh_.positions.reserve((last + 1) * columns);
    mesh_.uvs.reserve((last + 1) * columns);
    mesh_.triangles.reserve(2 * last * (columns - 1));
    Row below = add_row(0);
    for (std::size_t k = 1; k <= last; ++k) {
      const Row row = add_row(k);
      join(below, row);
      below = row;
    }
    return smooth_shaded(mesh_);
  }

  /// Returns the points of all rows from left to right, equally many per row.
  std::vector<Vec3> points() {
    std::vector<Vec3> points;
    for (std::size_t k = 0; k < leaf_.point_count(); ++k) {
      const Row row = add_row(k);
      for (int c = 0; c <= blade_.across; ++c) {
        points.push_back(mesh_.positions[row.first + (row.is_point ? 0U : static_cast<std::uint32_t>(c))]);
      }
    }
    return points;
  }

 private:
  struct Row {
    std::uint32_t first = 0;
    bool is_point = false;
  };

  /// Returns the direction of a piece, or 0 if the midrib does not advance.
  glm::dvec2 direction(std::size_t piece) const {
    const glm::dvec2 along(leaf_.x[piece + 1] - leaf_.x[piece], leaf_.y[piece + 1] - leaf_.y[piece]);
    const double length = glm::length(along);
    return length > kNoLength ? along / length : glm::dvec2(0);
  }

  /// Returns the direction of the midrib at a point: the mean of the pieces around it, or the direction of one piece,
  /// or up.
  glm::dvec2 tangent(std::size_t k) const {
    const glm::dvec2 before = k > 0 ? direction(k - 1) : glm::dvec2(0);
    const glm::dvec2 after = k + 1 < leaf_.point_count() ? direction(k) : glm::dvec2(0);
    for (const glm::dvec2 along : {before + after, after, before}) {
      const double length = glm::length(along);
      if (length > kNoLength) return along / length;
    }
    return {0, 1};
  }

  /// Returns the bend of a section per metre of its width.
  double curvature(double place) const {
    double curvature = blade_.roll / leaf_.width;
    if (blade_.clasp_radius > 0 && place < blade_.clasp) {
      const double left = 1 - place / blade_.clasp;
      curvature += left * left * (3 - 2 * left) / blade_.clasp_radius;
    }
    return curvature;
  }

  double wave(double place, double u) const {
    const EdgeWaves& waves = blade_.waves;
    if (waves.number == 0 || waves.depth == 0) return 0;
    const double phase = u < 0 ? waves.left : waves.right;
    return waves.depth * 4 * u * u * math::sin(2 * kPi * waves.number * place + phase);
  }

  DVec3 displacement(double place, double u) const {
    if (!blade_.displace) return DVec3(0);
    const DVec3 moved = leaf_.width * blade_.displace(place, u);
    return {moved.z, moved.y, -moved.x};
  }

  Row add_row(std::size_t k) {
    const bool is_end = k == 0 || k + 1 == leaf_.point_count();
    const double share = leaf_.r[k];
    const Row row{static_cast<std::uint32_t>(mesh_.positions.size()), is_end && share < kNoWidth};
    const glm::dvec2 along = tangent(k);
    DVec3 across(1, 0, 0), up(0, along.x, along.y);
    if (blade_.twist != 0) {
      const double turn = torsion(blade_, leaf_.s[k]);
      const double sine = math::sin(turn), cosine = math::cos(turn);
      const DVec3 level = across;
      across = cosine * level + sine * up;
      up = cosine * up - sine * level;
    }
    const DVec3 midrib = leaf_.length * DVec3(0, leaf_.y[k], -leaf_.x[k]);
    if (row.is_point) {
      add_vertex(midrib + displacement(leaf_.s[k], 0), 0.5, leaf_.s[k]);
      return row;
    }
    const double width = leaf_.width * std::max(share, kMinWidth);
    const double bend = std::clamp(curvature(leaf_.s[k]), -2 * kMaxClasp / width, 2 * kMaxClasp / width);
    for (int c = 0; c <= blade_.across; ++c) {
      const double u = static_cast<double>(c) / blade_.across - 0.5;
      const double away = std::abs(u) * width;
      double forward = away, height = 0;
      if (bend != 0 || blade_.fold != 0) {
        const ArcPoint arc = along_arc(blade_.fold, -bend * away, away);
        forward = arc.forward;
        height = arc.up;
      }
      height += wave(leaf_.s[k], u) * 0.5 * width;
      const DVec3 point = midrib + (u < 0 ? -forward : forward) * across + height * up;
      add_vertex(point + displacement(leaf_.s[k], u), 0.5 + u * share, leaf_.s[k]);
    }
    return row;
  }

  void join(const Row& below, const Row& above) {
    const auto columns = static_cast<std::uint32_t>(blade_.across);
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t a = below.first + (below.is_point ? 0 : c), b = below.first + (below.is_point ? 0 : c + 1);
      const std::uint32_t d = above.first + (above.is_point ? 0 : c), e = above.first + (above.is_point ? 0 : c + 1);
      // The diagonals are symmetric on both sides of the midrib.
      const bool is_left = 2 * c < columns;
      if (!below.is_point) mesh_.triangles.push_back({a, b, above.is_point || is_left ? e : d});
      if (!above.is_point) mesh_.triangles.push_back({below.is_point || is_left ? a : b, e, d});
    }
  }

  void add_vertex(DVec3 position, double u, double v) {
    mesh_.positions.emplace_back(position);
    mesh_.uvs.emplace_back(static_cast<float>(u), static_cast<float>(v));
  }

  const GrassLeaf& leaf_;
  const GrassBlade& blade_;
  Mesh mesh_;
};

/// Adds a strip about the y axis, from `middle - arc / 2` to `middle + arc / 2` from +z toward +x, seen from outside.
template <class Point>
Mesh make_strip(double arc, int sides, Point point) {
  Mesh mesh;
  for (int row = 0; row < 2; ++row) {
    for (int k = 0; k <= sides; ++k) {
      const double share = static_cast<double>(k) / sides;
      const double turn = kPi + arc * (share - 0.5);
      mesh.positions.emplace_back(point(row, share, math::sin(turn), math::cos(turn)));
      mesh.uvs.emplace_back(static_cast<float>(share), static_cast<float>(row));
    }
  }
  const auto columns = static_cast<std::uint32_t>(sides) + 1;
  for (std::uint32_t k = 0; k + 1 < columns; ++k) {
    mesh.triangles.push_back({k, k + 1, columns + k + 1});
    mesh.triangles.push_back({k, columns + k + 1, columns + k});
  }
  return smooth_shaded(mesh);
}

}  // namespace

double torsion(const GrassBlade& blade, double place) { return blade.twist * blade.twist_along(place); }

Mesh make_grass_blade(const GrassLeaf& leaf, const GrassBlade& blade) {
  check_grass_leaf(leaf);
  if (blade.across < 2 || blade.across % 2 != 0) {
    throw std::invalid_argument("a grass blade needs an even number of quads across");
  }
  const EdgeWaves& waves = blade.waves;
  if (!std::isfinite(blade.twist + blade.fold + blade.roll + blade.clasp + blade.clasp_radius + waves.number +
                     waves.depth + waves.left + waves.right)) {
    throw std::invalid_argument("the numbers of a grass blade must be finite");
  }
  return BladeRows(leaf, blade).run();
}

std::vector<std::vector<double>> blade_relief(const GrassLeaf& leaf, const GrassBlade& blade) {
  const bool has_waves = blade.waves.number != 0 && blade.waves.depth != 0;
  const bool has_clasp = blade.clasp > 0 && blade.clasp_radius > 0;
  if (blade.twist == 0 && !has_waves && !has_clasp && !blade.displace) return {};
  GrassBlade narrow = blade;
  narrow.across = 2;
  const std::vector<Vec3> points = BladeRows(leaf, narrow).points();
  std::vector<std::vector<double>> relief(9, std::vector<double>(leaf.point_count()));
  for (std::size_t k = 0; k < leaf.point_count(); ++k) {
    const DVec3 midrib = leaf.length * DVec3(0, leaf.y[k], -leaf.x[k]);
    const double half = 0.5 * leaf.width * leaf.r[k];
    for (int c = 0; c < 3; ++c) {
      const DVec3 moved = DVec3(points[3 * k + static_cast<std::size_t>(c)]) - midrib - DVec3((c - 1) * half, 0, 0);
      for (int axis = 0; axis < 3; ++axis) {
        relief[static_cast<std::size_t>(3 * c + axis)][k] = moved[axis] / leaf.length;
      }
    }
  }
  return relief;
}

Mesh make_sheath(double open) {
  return make_strip(2 * kPi - open, kSheathSides, [](int row, double, double sine, double cosine) {
    const double radius = row == 0 ? kSheathFoot : 1;
    return DVec3(radius * sine, row - 1, radius * cosine);
  });
}

Mesh make_ligule() {
  Mesh mesh = make_strip(kLiguleArc, kLiguleSides, [](int row, double share, double sine, double cosine) {
    const double height = row * (1 - (1 - kLiguleEnds) * (2 * share - 1) * (2 * share - 1));
    return DVec3(sine, height, cosine);
  });
  // The inner face lies slightly inward, so that no two triangles coincide.
  const auto vertices = static_cast<std::uint32_t>(mesh.vertex_count());
  const std::size_t triangles = mesh.triangle_count();
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const Vec3 outer = mesh.positions[v];
    mesh.positions.emplace_back(kLiguleInside * outer.x, outer.y, kLiguleInside * outer.z);
    mesh.normals.push_back(-mesh.normals[v]);
    mesh.uvs.push_back(mesh.uvs[v]);
  }
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    mesh.triangles.push_back({vertices + a, vertices + c, vertices + b});
  }
  return mesh;
}

}  // namespace meristem
