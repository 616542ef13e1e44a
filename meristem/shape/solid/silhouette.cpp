// SPDX-License-Identifier: Apache-2.0
// Converts a silhouette to a chain of straight edges that begins and ends on the axis. Lines stay as they are, splines
// are sampled where they bend most, and an open end gets an edge to the axis for its disc. Each corner of the chain
// stores the directions in which the true silhouette arrives and leaves, which differ only at sharp edges.
#include "meristem/shape/solid/silhouette.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "meristem/shape/flat/cut_polygon.h"

namespace meristem {
namespace {

using Point = glm::dvec2;
using CornerChain = std::vector<SilhouetteCorner>;

constexpr std::size_t kMaxPoints = 500;
constexpr double kNearest = 1e-5;        // share of the silhouette's length: nearer points count as equal
constexpr double kCreaseCosine = 0.766;  // cosine of 40°: lines that bend by more make a sharp edge
constexpr double kSteepest = 0.2;  // cosine between a smooth direction and its edge; below it, the direction of the
                                   // edge is used
constexpr double kStraightShare = 1e-6;  // share of the silhouette's length: edges with a smaller error are not cut

Point direction(Point from, Point to) { return glm::normalize(to - from); }

/// Returns the distance below which two points are one.
double resolution(const std::vector<Vec2>& silhouette) {
  double length = 0, farthest = 0;
  for (std::size_t k = 0; k < silhouette.size(); ++k) {
    farthest = std::max({farthest, double{silhouette[k].x}, std::abs(double{silhouette[k].y})});
    if (k > 0) length += glm::distance(Point(silhouette[k]), Point(silhouette[k - 1]));
  }
  return kNearest * std::max(length, farthest);
}

/// Radius and height as functions of the length of the lines between the points.
struct Spline {
  Curve radius, height;

  explicit Spline(const std::vector<Vec2>& silhouette) {
    std::vector<Vec2> radii, heights;
    double along = 0;
    for (std::size_t k = 0; k < silhouette.size(); ++k) {
      if (k > 0) along += glm::distance(Point(silhouette[k]), Point(silhouette[k - 1]));
      radii.emplace_back(along, silhouette[k].x);
      heights.emplace_back(along, silhouette[k].y);
    }
    radius = Curve(std::move(radii));
    height = Curve(std::move(heights));
  }

  double along(std::size_t point) const { return radius.points()[point].x; }
  Point at(double along) const { return {radius(along), height(along)}; }
  Point slope(double along) const { return {radius.slope(along), height.slope(along)}; }
};

/// Returns the sample positions of the spline, ascending: its points, and positions between where straight edges have
/// the largest error.
std::vector<double> sampled_places(const Spline& spline, std::size_t points, int rings) {
  struct Edge {
    double begin, end, error;
  };
  const auto edge = [&](double begin, double end) {
    const double middle = 0.5 * (begin + end);
    return Edge{begin, end, glm::distance(spline.at(middle), 0.5 * (spline.at(begin) + spline.at(end)))};
  };
  std::vector<Edge> edges;
  for (std::size_t k = 0; k + 1 < points; ++k) edges.push_back(edge(spline.along(k), spline.along(k + 1)));
  const double tolerance = kStraightShare * spline.along(points - 1);
  while (edges.size() < static_cast<std::size_t>(rings)) {
    const auto worst =
        std::max_element(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.error < b.error; });
    if (worst->error < tolerance) break;
    const double begin = worst->begin, end = worst->end, middle = 0.5 * (begin + end);
    *worst = edge(begin, middle);
    edges.insert(worst + 1, edge(middle, end));
  }
  std::vector<double> places{edges.front().begin};
  for (const Edge& each : edges) places.push_back(each.end);
  return places;
}

CornerChain spline_chain(const SolidOfRevolution& solid) {
  const Spline spline(solid.silhouette);
  CornerChain chain;
  for (const double place : sampled_places(spline, solid.silhouette.size(), solid.rings)) {
    const Point slope = spline.slope(place);
    const double steepness = glm::length(slope);
    const Point smooth = steepness > 0 ? slope / steepness : Point(0);
    chain.push_back({spline.at(place), smooth, smooth});
  }
  return chain;
}

/// Sets one direction for both sides of a corner that is not sharp.
void smooth_over(SilhouetteCorner& corner) {
  if (glm::dot(corner.arriving, corner.leaving) < kCreaseCosine) return;
  corner.arriving = corner.leaving = glm::normalize(corner.arriving + corner.leaving);
}

CornerChain line_chain(const SolidOfRevolution& solid) {
  CornerChain chain;
  for (const Vec2 point : solid.silhouette) chain.push_back({Point(point)});
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
    chain[k].leaving = chain[k + 1].arriving = direction(chain[k].at, chain[k + 1].at);
  }
  for (std::size_t k = 1; k + 1 < chain.size(); ++k) smooth_over(chain[k]);
  return chain;
}

/// Moves ends near the axis onto it. A blunt end is round there. Other ends get their disc.
void close_ends(CornerChain& chain, double nearest) {
  const auto is_on_axis = [&](const SilhouetteCorner& corner) { return corner.at.x <= nearest; };
  const auto mirrored = [](Point direction) { return Point(direction.x, -direction.y); };
  SilhouetteCorner& first = chain.front();
  SilhouetteCorner& last = chain.back();
  first.arriving = mirrored(first.leaving);
  last.leaving = mirrored(last.arriving);
  for (SilhouetteCorner* end : {&first, &last}) {
    if (!is_on_axis(*end)) continue;
    end->at.x = 0;
    smooth_over(*end);
  }
  if (!is_on_axis(first)) {
    first.arriving = {1, 0};
    chain.insert(chain.begin(), SilhouetteCorner{{0, first.at.y}, {1, 0}, {1, 0}});
  }
  if (!is_on_axis(chain.back())) {
    chain.back().leaving = {-1, 0};
    chain.push_back(SilhouetteCorner{{0, chain.back().at.y}, {-1, 0}, {-1, 0}});
  }
}

}  // namespace

std::vector<SilhouetteCorner> silhouette_chain(const SolidOfRevolution& solid) {
  CornerChain chain = solid.kind == CurveKind::linear ? line_chain(solid) : spline_chain(solid);
  close_ends(chain, resolution(solid.silhouette));
  // If few edges follow a tight bend, normals must still lie on the front of their triangles.
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
    const Point edge = direction(chain[k].at, chain[k + 1].at);
    for (Point* smooth : {&chain[k].leaving, &chain[k + 1].arriving}) {
      if (glm::dot(*smooth, edge) < kSteepest) *smooth = edge;
    }
  }
  return chain;
}

std::vector<glm::dvec2> corners_of(const std::vector<SilhouetteCorner>& chain) {
  std::vector<glm::dvec2> corners;
  corners.reserve(chain.size());
  for (const SilhouetteCorner& corner : chain) corners.push_back(corner.at);
  return corners;
}

namespace {

double signed_area(const std::vector<Point>& polygon) {
  double doubled = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point a = polygon[k], b = polygon[(k + 1) % polygon.size()];
    doubled += a.x * b.y - b.x * a.y;
  }
  return doubled / 2;
}

using Error = std::optional<SilhouetteError>;

Error point_error(const std::vector<Vec2>& silhouette) {
  if (silhouette.size() < 2) {
    return SilhouetteError{"the silhouette has fewer than two points", "pairs [radius, height] from base to tip", {}};
  }
  if (silhouette.size() > kMaxPoints) {
    return SilhouetteError{
        fmt::format("the silhouette has {} points", silhouette.size()), fmt::format("at most {}", kMaxPoints), {}};
  }
  for (std::size_t k = 0; k < silhouette.size(); ++k) {
    const Vec2 point = silhouette[k];
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
      return SilhouetteError{"the silhouette has a number that is not finite", "finite numbers", k};
    }
    if (point.x < 0) {
      return SilhouetteError{fmt::format("the radius {:.7g} is negative", point.x), "a radius of at least 0", k};
    }
  }
  return {};
}

Error place_error(const std::vector<Vec2>& silhouette) {
  const double nearest = resolution(silhouette);
  const auto is_on_axis = [&](Vec2 point) { return point.x <= nearest; };
  if (std::all_of(silhouette.begin(), silhouette.end(), is_on_axis)) {
    return SilhouetteError{"all of the silhouette lies on the axis", "a radius above 0 somewhere", {}};
  }
  for (std::size_t k = 1; k < silhouette.size(); ++k) {
    if (glm::distance(Point(silhouette[k]), Point(silhouette[k - 1])) <= nearest) {
      return SilhouetteError{"the point repeats the one before it", "points that differ", k};
    }
    if (k + 1 < silhouette.size() && is_on_axis(silhouette[k])) {
      return SilhouetteError{"the silhouette meets the axis before its end",
                             "a radius above 0 at all points but the first and the last", k};
    }
  }
  return {};
}

/// Checks whether splines swing beyond their points into an invalid shape.
Error swing_error(const SolidOfRevolution& solid) {
  const std::size_t points = solid.silhouette.size();
  const double nearest = resolution(solid.silhouette);
  const Spline spline(solid.silhouette);
  const std::vector<double> places = sampled_places(spline, points, solid.rings);
  std::size_t point = 0;
  for (std::size_t k = 1; k + 1 < places.size(); ++k) {
    while (spline.along(point + 1) <= places[k]) ++point;
    if (spline.at(places[k]).x > nearest) continue;
    return SilhouetteError{"after this point the spline swings across the axis",
                           "another point between this one and the next, or the kind 'linear'", point};
  }
  return {};
}

double distance_to(Point point, Point from, Point to) {
  const Point along = to - from;
  const double squared = glm::dot(along, along);
  const double share = squared > 0 ? std::clamp(glm::dot(along, point - from) / squared, 0.0, 1.0) : 0;
  return glm::distance(point, from + share * along);
}

/// Returns true if a corner of the closed polygon is nearer than this distance to an edge that does not end there.
bool comes_near_itself(const std::vector<Point>& polygon, double nearest) {
  const std::size_t count = polygon.size();
  for (std::size_t edge = 0; edge < count; ++edge) {
    const std::size_t next = (edge + 1) % count;
    for (std::size_t k = 0; k < count; ++k) {
      if (k == edge || k == next) continue;
      if (distance_to(polygon[k], polygon[edge], polygon[next]) < nearest) return true;
    }
  }
  return false;
}

Error way_error(const SolidOfRevolution& solid) {
  const std::vector<Point> corners = corners_of(silhouette_chain(solid));
  if (crosses_itself(corners) || comes_near_itself(corners, resolution(solid.silhouette))) {
    return SilhouetteError{"the silhouette crosses or touches itself, or a disc that closes it",
                           "a line from base to tip around a body",
                           {}};
  }
  if (!(signed_area(corners) > 0)) {
    return SilhouetteError{
        "the silhouette runs down around the body", "its points in their order from base to tip", {}};
  }
  return {};
}

}  // namespace

std::optional<SilhouetteError> find_error(const SolidOfRevolution& solid) {
  if (Error error = point_error(solid.silhouette)) return error;
  if (Error error = place_error(solid.silhouette)) return error;
  if (solid.kind == CurveKind::spline) {
    if (Error error = swing_error(solid)) return error;
  }
  return way_error(solid);
}

}  // namespace meristem
