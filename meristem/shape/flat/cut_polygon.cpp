// SPDX-License-Identifier: Apache-2.0
// Cuts a polygon along lines and triangulates the parts. Ears are cut off, the best shaped first, then diagonals are
// flipped if that gives better shapes. To split at a line, the crossings of the boundary with the line are sorted along
// it. Between the first and second crossing, the third and fourth and so on, the line lies inside, so the parts of the
// boundary on both sides are closed there. Other points on the line become corners on both sides, so that no gap opens
// when the triangles are bent.
//
// Based on: G. Meisters: Polygons have ears (The American Mathematical Monthly 82, 1975); C. Lawson: Transforming
// triangulations (Discrete Mathematics 3, 1972).
#include "meristem/shape/flat/cut_polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <glm/geometric.hpp>

namespace meristem {
namespace {

using Point = glm::dvec2;
using Polygon = std::vector<Point>;

constexpr double kSliverArea = 1e-6;  // minimum of twice the area divided by the squared longest edge; flatter
                                      // triangles are not made
constexpr double kBetter = 1e-9;      // minimum improvement of the shape that justifies flipping a diagonal
constexpr int kFlipPasses = 8;

/// Returns twice the signed area, positive for counter-clockwise triangles.
double turn(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

double squared_length(Point edge) { return glm::dot(edge, edge); }

/// Returns the shape quality: 1.15 for an equilateral triangle, 0 for a flat one, negative for a clockwise one.
double shape_quality(Point a, Point b, Point c) {
  const double longest = std::max({squared_length(b - a), squared_length(c - b), squared_length(a - c)});
  return longest > 0 ? turn(a, b, c) / longest : 0;
}

void append(Polygon& polygon, Point point) {
  if (polygon.empty() || polygon.back() != point) polygon.push_back(point);
}

/// Splits polygons at one line.
class Splitter {
 public:
  /// Splits at the line where coordinate `axis` is `line`.
  Splitter(const Polygon& polygon, int axis, double line, double tolerance)
      : polygon_(polygon), axis_(axis), line_(line), tolerance_(tolerance) {
    walk();
    pair_up();
  }

  void run(std::vector<Polygon>& before, std::vector<Polygon>& beyond) {
    if (crossings_.empty()) {
      (is_beyond(polygon_.front()) ? beyond : before).push_back(polygon_);
      return;
    }
    for (std::size_t k = 0; k < crossings_.size(); ++k) {
      if (!is_used_[k]) trace(k, crossings_[k].enters_beyond ? beyond : before);
    }
  }

 private:
  /// A position where the boundary changes sides. The part of the boundary after it leads to the next crossing.
  struct Crossing {
    Point at;
    double slant;             // sideways slope of the boundary just before the line
    std::size_t first_after;  // the corner that follows
    bool enters_beyond;
    std::size_t partner = 0;  // the crossing at the other end of the inner part
  };

  bool is_beyond(Point point) const { return point[axis_] >= line_ - tolerance_; }
  double place(Point point) const { return point[1 - axis_]; }

  void walk() {
    const std::size_t count = polygon_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count;
      if (is_beyond(polygon_[i]) != is_beyond(polygon_[next])) add_crossing(i, next);
      if (std::abs(polygon_[i][axis_] - line_) <= tolerance_) on_line_.push_back(polygon_[i]);
    }
    for (const Crossing& crossing : crossings_) on_line_.push_back(crossing.at);
    std::sort(on_line_.begin(), on_line_.end(), [&](Point a, Point b) { return place(a) < place(b); });
    is_used_.assign(crossings_.size(), false);
  }

  void add_crossing(std::size_t from, std::size_t to) {
    const bool enters_beyond = is_beyond(polygon_[to]);
    // Always interpolate from before the line to beyond it, so that neighbours who share the edge get equal points.
    const Point before = polygon_[enters_beyond ? from : to];
    const Point beyond = polygon_[enters_beyond ? to : from];
    const double share = (line_ - before[axis_]) / (beyond[axis_] - before[axis_]);
    Point at = before + share * (beyond - before);
    at[axis_] = line_;
    if (beyond[axis_] <= line_ + tolerance_) at = beyond;
    crossings_.push_back({at, (place(before) - place(at)) / (at[axis_] - before[axis_]), to, enters_beyond});
  }

  void pair_up() {
    std::vector<std::size_t> order(crossings_.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      const double at_a = place(crossings_[a].at), at_b = place(crossings_[b].at);
      if (at_a != at_b) return at_a < at_b;
      if (crossings_[a].slant != crossings_[b].slant) return crossings_[a].slant < crossings_[b].slant;
      return a < b;
    });
    for (std::size_t k = 0; k + 1 < order.size(); k += 2) {
      crossings_[order[k]].partner = order[k + 1];
      crossings_[order[k + 1]].partner = order[k];
    }
  }

  /// Follows the boundary from crossing `start` to its partner and closes the polygon along the line.
  void trace(std::size_t start, std::vector<Polygon>& out) {
    Polygon traced;
    std::size_t at = start;
    while (!is_used_[at] && crossings_[at].enters_beyond == crossings_[start].enters_beyond) {
      is_used_[at] = true;
      const std::size_t next = (at + 1) % crossings_.size();
      append(traced, crossings_[at].at);
      for (std::size_t i = crossings_[at].first_after; i != crossings_[next].first_after;
           i = (i + 1) % polygon_.size()) {
        append(traced, polygon_[i]);
      }
      append(traced, crossings_[next].at);
      append_between(crossings_[next].at, crossings_[crossings_[next].partner].at, traced);
      at = crossings_[next].partner;
    }
    while (traced.size() > 1 && traced.back() == traced.front()) traced.pop_back();
    emit_loops(traced, out);
  }

  /// Where a corner of the boundary touches the line, the polygon meets itself and is split there.
  void emit_loops(const Polygon& traced, std::vector<Polygon>& out) const {
    Polygon open;
    for (const Point point : traced) {
      const bool may_repeat = std::abs(point[axis_] - line_) <= tolerance_;
      const auto same = may_repeat ? std::find(open.begin(), open.end(), point) : open.end();
      if (open.end() - same >= 3) out.emplace_back(same, open.end());
      open.erase(same, open.end());
      open.push_back(point);
    }
    if (open.size() >= 3) out.push_back(std::move(open));
  }

  /// Appends the corners strictly between two points of the line, in the direction from `from` to `to`.
  void append_between(Point from, Point to, Polygon& out) const {
    const double low = std::min(place(from), place(to)), high = std::max(place(from), place(to));
    const auto first = std::upper_bound(on_line_.begin(), on_line_.end(), low,
                                        [&](double value, Point point) { return value < place(point); });
    const auto last = std::lower_bound(on_line_.begin(), on_line_.end(), high,
                                       [&](Point point, double value) { return place(point) < value; });
    if (first >= last) return;
    if (place(from) < place(to)) {
      for (auto it = first; it != last; ++it) append(out, *it);
    } else {
      for (auto it = last; it != first; --it) append(out, *(it - 1));
    }
  }

  const Polygon& polygon_;
  int axis_;
  double line_, tolerance_;
  std::vector<Crossing> crossings_;  // along the boundary
  Polygon on_line_;                  // along the line
  std::vector<bool> is_used_;
};

/// Returns the parts of `polygon` between the lines, in their order. Splits at the middle line first, so that few
/// corners are copied often.
std::vector<Polygon> split_at_lines(Polygon polygon, int axis, const std::vector<double>& lines, double tolerance) {
  struct Part {
    Polygon polygon;
    std::size_t first, last;  // range of lines that may still cross the polygon
  };
  std::vector<Polygon> done;
  std::vector<Part> waiting;
  waiting.push_back({std::move(polygon), 0, lines.size()});
  while (!waiting.empty()) {
    const Part part = std::move(waiting.back());
    waiting.pop_back();
    if (part.first == part.last) {
      done.push_back(part.polygon);
      continue;
    }
    const std::size_t middle = (part.first + part.last) / 2;
    std::vector<Polygon> before, beyond;
    Splitter(part.polygon, axis, lines[middle], tolerance).run(before, beyond);
    for (Polygon& piece : beyond) waiting.push_back({std::move(piece), middle + 1, part.last});
    for (Polygon& piece : before) waiting.push_back({std::move(piece), part.first, middle});
  }
  return done;
}

/// Returns true if the ear at b contains no other corner, and no corner is nearer to the diagonal than `margin` of its
/// length.
bool is_clear(const Polygon& ring, Point a, Point b, Point c, double margin) {
  const double beyond = -margin * squared_length(a - c);
  return std::none_of(ring.begin(), ring.end(), [&](Point point) {
    if (point == a || point == b || point == c) return false;
    return turn(a, b, point) >= 0 && turn(b, c, point) >= 0 && turn(c, a, point) >= beyond;
  });
}

/// Returns the corner whose clear ear has the best shape.
std::optional<std::size_t> best_ear(const Polygon& ring, double margin) {
  std::optional<std::size_t> best;
  double best_quality = kSliverArea;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[(i + ring.size() - 1) % ring.size()], b = ring[i], c = ring[(i + 1) % ring.size()];
    const double quality = shape_quality(a, b, c);
    if (quality <= best_quality || !is_clear(ring, a, b, c, margin)) continue;
    best = i;
    best_quality = quality;
  }
  return best;
}

/// Corners of a polygon by number.
using Corners = std::array<std::size_t, 3>;

double shape_quality(const Polygon& polygon, Corners corners) {
  return shape_quality(polygon[corners[0]], polygon[corners[1]], polygon[corners[2]]);
}

std::vector<Corners> clip_ears(const Polygon& polygon) {
  std::vector<Corners> triangles;
  Polygon ring = polygon;
  std::vector<std::size_t> number(ring.size());
  for (std::size_t i = 0; i < number.size(); ++i) number[i] = i;
  while (ring.size() > 3) {
    // A corner on the diagonal would leave a triangle too flat to be made, and therefore a gap.
    auto ear = best_ear(ring, kSliverArea);
    if (!ear) ear = best_ear(ring, 0);
    if (!ear) break;
    const std::size_t i = *ear;
    triangles.push_back({number[(i + ring.size() - 1) % ring.size()], number[i], number[(i + 1) % ring.size()]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
    number.erase(number.begin() + static_cast<std::ptrdiff_t>(i));
  }
  if (ring.size() == 3 && shape_quality(ring[0], ring[1], ring[2]) > kSliverArea) {
    triangles.push_back({number[0], number[1], number[2]});
  }
  return triangles;
}

/// Flips the diagonal in the quad of two neighbours if this improves the shapes. Returns true if it did.
bool flip(const Polygon& polygon, Corners& one, Corners& other) {
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 3; ++j) {
      const std::size_t u = one[k], v = one[(k + 1) % 3];
      if (other[j] != v || other[(j + 1) % 3] != u) continue;
      const std::size_t left = one[(k + 2) % 3], right = other[(j + 2) % 3];
      const Corners lower{u, right, left}, upper{right, v, left};
      const double now = std::min(shape_quality(polygon, one), shape_quality(polygon, other));
      const double then = std::min(shape_quality(polygon, lower), shape_quality(polygon, upper));
      if (then <= now + kBetter) return false;
      one = lower;
      other = upper;
      return true;
    }
  }
  return false;
}

void triangulate(const Polygon& polygon, std::vector<FlatTriangle>& out) {
  std::vector<Corners> triangles = clip_ears(polygon);
  bool has_changed = true;
  for (int pass = 0; pass < kFlipPasses && has_changed; ++pass) {
    has_changed = false;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (std::size_t j = i + 1; j < triangles.size(); ++j) {
        has_changed = flip(polygon, triangles[i], triangles[j]) || has_changed;
      }
    }
  }
  for (const Corners& corners : triangles)
    out.push_back({polygon[corners[0]], polygon[corners[1]], polygon[corners[2]]});
}

bool do_edges_meet(Point a, Point b, Point c, Point d) {
  const auto opposite = [](double one, double other) { return (one <= 0 && other >= 0) || (one >= 0 && other <= 0); };
  const auto overlap = [](double a0, double a1, double b0, double b1) {
    return std::max(std::min(a0, a1), std::min(b0, b1)) <= std::min(std::max(a0, a1), std::max(b0, b1));
  };
  return opposite(turn(a, b, c), turn(a, b, d)) && opposite(turn(c, d, a), turn(c, d, b)) &&
         overlap(a.x, b.x, c.x, d.x) && overlap(a.y, b.y, c.y, d.y);
}

}  // namespace

std::vector<FlatTriangle> cut_polygon(const std::vector<glm::dvec2>& corners, const CutLines& lines) {
  std::vector<FlatTriangle> triangles;
  if (corners.size() < 3) return triangles;
  for (Polygon& band : split_at_lines(corners, 1, lines.rows, lines.row_tolerance)) {
    for (const Polygon& part : split_at_lines(std::move(band), 0, lines.columns, lines.column_tolerance)) {
      triangulate(part, triangles);
    }
  }
  return triangles;
}

bool crosses_itself(const std::vector<glm::dvec2>& corners) {
  // Sort edges from the lowest up, and test each against those edges that begin below its upper end.
  const std::size_t count = corners.size();
  const auto low = [&](std::size_t i) { return std::min(corners[i].y, corners[(i + 1) % count].y); };
  const auto high = [&](std::size_t i) { return std::max(corners[i].y, corners[(i + 1) % count].y); };
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return low(a) < low(b); });
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t a = order[k];
    for (std::size_t j = k + 1; j < count && low(order[j]) <= high(a); ++j) {
      const std::size_t b = order[j];
      const bool are_neighbours = (a + 1) % count == b || (b + 1) % count == a;
      if (are_neighbours) continue;
      if (do_edges_meet(corners[a], corners[(a + 1) % count], corners[b], corners[(b + 1) % count])) return true;
    }
  }
  return false;
}

}  // namespace meristem
