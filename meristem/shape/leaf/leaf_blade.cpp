// SPDX-License-Identifier: Apache-2.0
// Builds the mesh of a leaf blade. The blade is a surface S(t, a), with t along the midrib from 0 to 1 and a metres
// across from it, both measured on the surface. The midrib is an arc of a circle that turns by `curl`. Each
// cross-section is, on either side, an arc of a circle that starts raised by `fold` and sinks, lifted by profile and
// waves. The flat outline is cut into triangles, whose corners are then put on the surface with its exact normals.
#include "meristem/shape/leaf/leaf_blade.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <glm/geometric.hpp>

#include "meristem/base/math.h"
#include "meristem/shape/flat/arc.h"
#include "meristem/shape/flat/cut_polygon.h"
#include "meristem/shape/leaf/leaf_outline.h"

namespace meristem {
namespace {

constexpr double kRunOut = 0.2;            // share of the length: maximum distance at which a petiole is visible on the
                                           // midrib
constexpr double kRunOutRadii = 8;         // the same distance in radii of the petiole
constexpr double kRowTolerance = 1e-3;     // share of the length: corners nearer to a row lie on it
constexpr double kColumnTolerance = 0.02;  // share of half the width: corners nearer to a column lie on it
constexpr double kMinLength = 0.1;         // minimum share of the length along the surface where it is bent back on
                                           // itself
constexpr std::size_t kPetioleTriangles = 9;
constexpr double kVeinWidth = 0.05;  // share of half the width: minimum width of the blade at the petiole's
                                     // picture

bool is_right_edge(const std::vector<Vec2>& polygon) {
  const auto is_beside = [](Vec2 p) { return std::isfinite(p.x + p.y) && p.x >= 0; };
  return std::all_of(polygon.begin(), polygon.end(), is_beside) &&
         std::any_of(polygon.begin(), polygon.end(), [](Vec2 p) { return p.x > 0; });
}

void check(const LeafBlade& blade) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw std::invalid_argument(message);
  };
  const auto is_length = [](double value) { return std::isfinite(value) && value > 0; };
  require(is_length(blade.length) && is_length(blade.width), "a leaf blade needs a positive length and width");
  require(std::isfinite(blade.petiole) && blade.petiole >= 0, "a petiole's length must be at least 0");
  require(blade.petiole == 0 || is_length(blade.petiole_radius), "a petiole needs a positive radius");
  require(std::isfinite(blade.curl + blade.curl_across + blade.fold), "a leaf blade's angles must be finite");
  require(std::isfinite(blade.heart) && blade.heart >= 0, "a leaf's heart must be at least 0");
  require(blade.teeth >= 0 && std::isfinite(blade.teeth_depth + blade.teeth_lean),
          "a leaf's teeth must be finite and not negative");
  require(blade.waves >= 0 && std::isfinite(blade.waves_depth), "a leaf's waves must be finite and not negative");
  require(blade.polygon.empty() || is_right_edge(blade.polygon), "a leaf's polygon must lie beside the midrib");
  require(blade.rows >= 1, "a leaf blade needs at least 1 row");
  require(blade.across >= 2 && blade.across % 2 == 0, "a leaf blade needs an even number of quads across");
}

/// Maps points of the flat half blade to the surface. x is in metres from the midrib, y in shares of the length from
/// the joint.
class BladeSurface {
 public:
  explicit BladeSurface(const LeafBlade& blade) : blade_(blade) {}

  struct Place {
    Vec3 position, normal;
  };

  /// `across` is in metres to the right.
  Place operator()(double across, double along) const {
    const ArcPoint midrib = along_arc(0, blade_.curl * along, blade_.length * along);
    const DVec3 right{1, 0, 0};
    const DVec3 ahead{0, math::cos(midrib.angle), math::sin(midrib.angle)};
    const DVec3 upper{0, -ahead.z, ahead.y};
    const double away = std::abs(across);
    const double side = across > 0 ? 1 : across < 0 ? -1 : 0;
    const ArcPoint section = along_arc(blade_.fold, blade_.curl_across / blade_.width * away, away);
    const Relief relief = relief_at(away, along);
    const double up = section.up + relief.height;
    const DVec3 position =
        DVec3(0, blade_.petiole + midrib.forward, midrib.up) + side * section.forward * right + up * upper;
    // The cross product of the surface's derivatives across and along. On the midrib it is the mean of both halves.
    const double length = std::max(blade_.length + up * blade_.curl, kMinLength * blade_.length);
    const double forward_slope = math::cos(section.angle), up_slope = math::sin(section.angle) + relief.across_slope;
    const DVec3 normal =
        forward_slope * (length * upper - relief.along_slope * ahead) - side * up_slope * length * right;
    return {Vec3(position), Vec3(glm::normalize(normal))};
  }

 private:
  /// The height of profile and waves, with its slopes per metre across and per share along.
  struct Relief {
    double height = 0, across_slope = 0, along_slope = 0;
  };

  Relief relief_at(double away, double along) const {
    const double half = blade_.width / 2;
    const double share = away / half;
    Relief relief{half * blade_.profile(share), blade_.profile.slope(share), 0};
    if (blade_.waves == 0) return relief;
    const double turns = 2 * kPi * blade_.waves;
    const double crest = half * blade_.waves_depth * share * share;
    relief.height += crest * math::sin(turns * along);
    relief.across_slope += 2 * blade_.waves_depth * share * math::sin(turns * along);
    relief.along_slope = crest * turns * math::cos(turns * along);
    return relief;
  }

  const LeafBlade& blade_;
};

/// Returns columns of points beside the midrib, in the metric of the flat half blade.
std::vector<double> column_lines(const LeafBlade& blade, double half_width) {
  std::vector<double> columns;
  const int half = blade.across / 2;
  for (int k = 1; k < half; ++k) columns.push_back(half_width * k / half);
  return columns;
}

class BladeMesher {
 public:
  explicit BladeMesher(const LeafBlade& blade)
      : blade_(blade), surface_(blade), outline_(mesh_outline(blade)), half_width_(0.5 * blade.width / blade.length) {}

  Mesh run() {
    if (blade_.petiole > 0) add_petiole();
    const std::vector<FlatTriangle> triangles = flat_triangles();
    add_points(triangles);
    for (const FlatTriangle& triangle : triangles) {
      add_triangle(triangle[0], triangle[1], triangle[2]);
      add_triangle(mirrored(triangle[0]), mirrored(triangle[2]), mirrored(triangle[1]));
    }
    return std::move(mesh_);
  }

  std::size_t triangle_count() const {
    return 2 * flat_triangles().size() + (blade_.petiole > 0 ? kPetioleTriangles : 0);
  }

 private:
  using Point = glm::dvec2;

  static Point mirrored(Point point) { return {-point.x, point.y}; }
  static bool is_before(Point a, Point b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }

  /// Returns the triangles of the right half. Both coordinates are in lengths of the blade.
  std::vector<FlatTriangle> flat_triangles() const {
    std::vector<Point> corners;
    for (const Point point : outline_.edge) corners.emplace_back(half_width_ * point.x, point.y);
    return cut_polygon(
        corners, {outline_.rows, column_lines(blade_, half_width_), kRowTolerance * std::min(1.0, 10 * half_width_),
                  std::min(kColumnTolerance, 0.2 / blade_.across) * half_width_});
  }

  /// Adds vertices for both halves, from base to tip and from left to right.
  void add_points(const std::vector<FlatTriangle>& triangles) {
    for (const FlatTriangle& triangle : triangles) {
      for (const Point point : triangle) {
        points_.push_back(point);
        if (point.x > 0) points_.push_back(mirrored(point));
      }
    }
    std::sort(points_.begin(), points_.end(), is_before);
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    first_ = static_cast<std::uint32_t>(mesh_.vertex_count());
    for (const Point point : points_) {
      const auto place = surface_(point.x * blade_.length, point.y);
      add_vertex(place.position, place.normal, {0.5 + 0.5 * point.x / half_width_, v_at(point.y)});
    }
  }

  void add_triangle(Point a, Point b, Point c) {
    const auto index = [&](Point point) {
      const auto found = std::lower_bound(points_.begin(), points_.end(), point, is_before);
      return first_ + static_cast<std::uint32_t>(found - points_.begin());
    };
    mesh_.triangles.push_back({index(a), index(b), index(c)});
  }

  double v_at(double along) const { return (along - outline_.low) / (outline_.high - outline_.low); }

  /// Adds a three-sided tube from the origin to the joint, which fades into the midrib. Its uvs are a spot of the
  /// midrib where the blade exists on both sides.
  void add_petiole() {
    const double r = blade_.petiole_radius;
    const double v = v_at(picture_of_stalk());
    for (const double y : {0.0, blade_.petiole}) {
      for (int k = 0; k < 3; ++k) {
        const Vec3 out = petiole_side(k);
        add_vertex(Vec3(0, static_cast<float>(y), 0) + static_cast<float>(r) * out, out,
                   {0.495 + 0.005 * k, v + 0.01 * (y / blade_.petiole - 1)});
      }
    }
    const double share = std::min(kRunOut, kRunOutRadii * r / blade_.length);
    const ArcPoint end = along_arc(0, blade_.curl * share, blade_.length * share);
    const DVec3 at{0, blade_.petiole + end.forward, end.up};
    for (int k = 0; k < 3; ++k) {
      // Between this side and the next.
      add_vertex(Vec3(at), -petiole_side(k + 2), {0.4975 + 0.005 * k, v + 0.01});
    }
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t next = (k + 1) % 3;
      mesh_.triangles.push_back({k, next, 3 + next});
      mesh_.triangles.push_back({k, 3 + next, 3 + k});
      mesh_.triangles.push_back({3 + k, 3 + next, 6 + k});
    }
    mesh_.stalk_triangles = static_cast<std::uint32_t>(mesh_.triangle_count());
  }

  /// Returns the first position along the midrib where the blade is wide enough on both sides of it.
  double picture_of_stalk() const {
    const bool is_hull = blade_.edge == LeafBlade::Edge::picture;
    const std::vector<Point> edge = is_hull ? full_outline(blade_).edge : outline_.edge;
    for (double along = 0.04; along < 1; along += 0.02) {
      double width = 1;
      for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
        const Point low = edge[i].y < edge[i + 1].y ? edge[i] : edge[i + 1];
        const Point high = edge[i].y < edge[i + 1].y ? edge[i + 1] : edge[i];
        const double near = along - 0.02, far = along + 0.02;
        if (high.y >= near && low.y <= far) width = std::min({width, low.x, high.x});
      }
      if (width > kVeinWidth) return along;
    }
    return 0.5;
  }

  /// Returns one of three directions about y, counter-clockwise as seen from the tip. One of them is down.
  static Vec3 petiole_side(int k) {
    const double angle = 2 * kPi * (k % 3) / 3;
    return {-static_cast<float>(math::sin(angle)), 0, -static_cast<float>(math::cos(angle))};
  }

  void add_vertex(Vec3 position, Vec3 normal, glm::dvec2 uv) {
    mesh_.positions.push_back(position);
    mesh_.normals.push_back(normal);
    mesh_.uvs.emplace_back(uv);
  }

  const LeafBlade& blade_;
  BladeSurface surface_;
  LeafOutline outline_;
  double half_width_;  // in lengths of the blade
  std::vector<Point> points_;
  std::uint32_t first_ = 0;  // vertex of the first point
  Mesh mesh_;
};

}  // namespace

Mesh make_leaf_blade(const LeafBlade& blade) {
  check(blade);
  return BladeMesher(blade).run();
}

std::size_t leaf_blade_triangles(const LeafBlade& blade) {
  check(blade);
  return BladeMesher(blade).triangle_count();
}

TextureShape leaf_texture_shape(const LeafBlade& blade) {
  check(blade);
  const LeafOutline outline = full_outline(blade);
  TextureShape shape;
  shape.masked = blade.edge == LeafBlade::Edge::picture;
  shape.aspect = blade.width / (blade.length * (outline.high - outline.low));
  const auto add = [&](double side, glm::dvec2 point) {
    shape.outline.emplace_back(0.5 + 0.5 * side * point.x, (point.y - outline.low) / (outline.high - outline.low));
  };
  for (const glm::dvec2 point : outline.edge) add(1, point);
  for (std::size_t i = outline.edge.size() - 1; i-- > 1;) {
    if (outline.edge[i].x > 0) add(-1, outline.edge[i]);
  }
  return shape;
}

}  // namespace meristem
