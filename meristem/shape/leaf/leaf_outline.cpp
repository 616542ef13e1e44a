// SPDX-License-Identifier: Apache-2.0
// Computes the edge of half a blade, a chain of points from the joint to the tip, in steps. The edge is sampled from
// the curve or taken from the polygon, drawn back beside the joint for a heart, thinned out, and cut into teeth. A
// plain curve is handled differently: its rows are placed where they reduce the error most, and the edge has its points
// on the rows. The heart is a shear along the midrib, monotone in y, so an edge that does not cross itself never will.
#include "meristem/shape/leaf/leaf_outline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "meristem/base/math.h"
#include "meristem/shape/flat/cut_polygon.h"
#include "meristem/shape/flat/segment.h"

namespace meristem {
namespace {

using Point = glm::dvec2;
using Chain = std::vector<Point>;

constexpr int kCandidates = 128;        // even positions along the midrib where a row may stand
constexpr double kNearestShare = 1e-3;  // share of the length: closer candidates count as one
constexpr double kLobe = 0.05;          // share of half the width: smaller turns of the outline are not lobes
constexpr double kPointed = 1e-3;       // share of half the width: narrower rows are one point
constexpr double kCoarse = 0.12;        // share of half the width: allowed error of the mesh with one row
constexpr double kFine = 0.002;         // share of half the width: allowed error of the outline for textures
constexpr double kSliver = 0.008;       // share of half the width: details that the mesh always leaves out
constexpr double kRowGap = 2.5e-3;      // share of the length: minimum distance of rows from each other and from the
                                        // ends
constexpr double kMaxHeartFactor = 6;   // the largest move of a base, in hearts
constexpr double kHeartShare = 0.97;    // a base that reaches back by this share of its heart is moved no farther
constexpr int kHeartSteps = 40;         // halvings of the interval in which the move is sought
constexpr int kBaseSteps = 12;          // points of a blunt base that becomes a heart
constexpr double kSnap = 0.3;           // share of the space between rows: maximum move of a row to meet a corner of
                                        // the edge
constexpr double kEntireBase = 0.08;    // share of the edge, from the joint, without teeth
constexpr double kFullDepth = 1.5;      // 1 divided by the half width from which teeth have their full depth
constexpr double kThinnest = 0.35;      // minimum share of the half width that teeth leave
constexpr double kParallel = 1e-12;     // cross product below which edges count as parallel

/// A position along the midrib and the outline's half width there, both as shares.
struct Station {
  double along, half_width;
};

/// Returns the possible rows: the outline's own points and even positions between.
std::vector<Station> candidates(const Curve& outline) {
  std::vector<double> places;
  for (const Vec2 point : outline.points()) {
    if (point.x > kNearestShare && point.x < 1 - kNearestShare) places.push_back(point.x);
  }
  const std::size_t own = places.size();
  for (int k = 1; k < kCandidates; ++k) {
    const double place = static_cast<double>(k) / kCandidates;
    const auto next = std::lower_bound(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(own), place);
    const bool is_near_next =
        next != places.begin() + static_cast<std::ptrdiff_t>(own) && *next - place < kNearestShare;
    const bool is_near_last = next != places.begin() && place - *(next - 1) < kNearestShare;
    if (!is_near_next && !is_near_last) places.push_back(place);
  }
  places.push_back(0);
  places.push_back(1);
  std::sort(places.begin(), places.end());
  std::vector<Station> stations;
  for (const double place : places) {
    // A spline can exceed its points, but the blade must keep its given width.
    const double half_width = std::min(1.0, outline(place));
    stations.push_back({place, half_width < kPointed ? 0 : half_width});
  }
  return stations;
}

/// Returns the indices at which the width changes from growing to falling, or back, by more than a lobe's depth.
std::vector<std::size_t> turning_points(const std::vector<Station>& stations) {
  std::vector<std::size_t> turns;
  std::size_t extreme = 0;
  int direction = 0;  // 0 until the width has changed
  for (std::size_t i = 1; i < stations.size(); ++i) {
    const double change = stations[i].half_width - stations[extreme].half_width;
    if (direction == 0 ? std::abs(change) > kLobe : direction * change < -kLobe) {
      if (direction != 0) turns.push_back(extreme);
      direction = change > 0 ? 1 : -1;
      extreme = i;
    } else if (direction * change > 0) {
      extreme = i;
    }
  }
  return turns;
}

/// Candidates i to j as one straight row of quads: the error, and the best position for a cut.
struct Gap {
  std::size_t begin, end;
  double error = 0;
  std::size_t cut = 0;

  Gap(const LeafBlade& blade, const std::vector<Station>& stations, std::size_t begin_, std::size_t end_)
      : begin(begin_), end(end_), cut((begin_ + end_) / 2) {
    if (end - begin < 2) return;
    const Station& low = stations[begin];
    const Station& high = stations[end];
    const double span = high.along - low.along;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const double share = (stations[i].along - low.along) / span;
      const double straight = low.half_width + share * (high.half_width - low.half_width);
      const double off = std::abs(stations[i].half_width - straight) * blade.width / 2;
      if (off > error) {
        error = off;
        cut = i;
      }
    }
    // The height of the midrib's arc above its chord.
    const double sagitta = blade.length * std::abs(blade.curl) * span * span / 8;
    if (sagitta < error) return;
    error = sagitta;
    const double middle = 0.5 * (low.along + high.along);
    cut = begin + 1;
    while (cut + 1 < end && stations[cut].along < middle - kNearestShare) ++cut;
  }
};

/// Returns the rows from base to tip.
std::vector<Station> choose_rows(const LeafBlade& blade) {
  const std::vector<Station> stations = candidates(blade.outline);
  // Begin with the ends and every lobe and bay.
  std::vector<std::size_t> ends = turning_points(stations);
  ends.push_back(stations.size() - 1);
  std::vector<Gap> gaps;
  std::size_t begin = 0;
  for (const std::size_t end : ends) {
    if (end == begin) continue;
    gaps.emplace_back(blade, stations, begin, end);
    begin = end;
  }
  // Cut the gap with the largest error until there are enough rows. If no gap has an error, cut the widest.
  while (gaps.size() < static_cast<std::size_t>(blade.rows)) {
    const auto worst = std::max_element(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) {
      return a.error != b.error ? a.error < b.error : a.end - a.begin < b.end - b.begin;
    });
    if (worst->end - worst->begin < 2) break;
    const Gap cut = *worst;
    *worst = Gap(blade, stations, cut.begin, cut.cut);
    gaps.insert(worst + 1, Gap(blade, stations, cut.cut, cut.end));
  }
  std::vector<Station> rows{stations.front()};
  for (const Gap& gap : gaps) rows.push_back(stations[gap.end]);
  return rows;
}

/// Returns the length of a step of x on the blade, relative to a step of y.
double aspect_of(const LeafBlade& blade) { return 0.5 * blade.width / blade.length; }

double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }

void append(Chain& chain, Point point) {
  if (chain.empty() || chain.back() != point) chain.push_back(point);
}

/// Returns the chain from the joint over the given points to the tip.
Chain joined_to_midrib(const Chain& points) {
  Chain chain{{0, 0}};
  for (const Point point : points) append(chain, point);
  append(chain, {0, 1});
  return chain;
}

Chain chain_of(const std::vector<Station>& stations) {
  Chain chain;
  for (const Station station : stations) chain.emplace_back(station.half_width, station.along);
  return joined_to_midrib(chain);
}

/// Returns the chain with its corners cut off twice, a quarter of the way to their neighbours, by G. Chaikin (1974).
/// Joint and tip stay.
Chain rounded(Chain chain) {
  for (int pass = 0; pass < 2; ++pass) {
    Chain next{chain.front()};
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      append(next, 0.25 * chain[i - 1] + 0.75 * chain[i]);
      append(next, 0.75 * chain[i] + 0.25 * chain[i + 1]);
    }
    append(next, chain.back());
    chain = std::move(next);
  }
  // Restore the maximum width.
  double widest = 0;
  for (const Point point : chain) widest = std::max(widest, point.x);
  for (Point& point : chain) point.x /= widest;
  return chain;
}

Chain polygon_chain(const LeafBlade& blade) {
  Chain points;
  for (const Vec2 point : blade.polygon) points.emplace_back(point);
  Chain chain = joined_to_midrib(points);
  return blade.corners == LeafBlade::Corners::round ? rounded(std::move(chain)) : chain;
}

/// Adds points to a blunt base, so that it can be bent.
Chain with_base_points(const Chain& chain) {
  if (chain.size() < 2 || chain[1].y > 0) return chain;
  Chain out;
  for (int k = 0; k < kBaseSteps; ++k) out.push_back(chain[0] + (k / double{kBaseSteps}) * (chain[1] - chain[0]));
  out.insert(out.end(), chain.begin() + 1, chain.end());
  return out;
}

/// Returns the position along the blade of a point that is moved toward the stalk. The move is `factor` beside the
/// joint, a third of the way to the edge, and 0 at the midrib and at the tip.
double moved_back(Point point, double factor) {
  if (point.x <= 0) return point.y;
  const double lobe = math::sin(kPi * math::pow(std::min(point.x, 1.0), 0.6));
  const double to_tip = std::max(0.0, 1 - point.y);
  return point.y - factor * lobe * to_tip * to_tip * to_tip;
}

/// Draws the base back until its lowest point lies `heart` behind the joint. A base that is narrow where the move is
/// large must be moved farther. Blades that begin as a narrow stalk would be torn apart, so the move has a limit.
void draw_back(Chain& chain, double heart) {
  const auto lowest = [&](double factor) {
    double low = 0;
    for (const Point point : chain) low = std::min(low, moved_back(point, factor));
    return low;
  };
  double low = heart;
  double high = heart;
  if (lowest(heart) > -kHeartShare * heart) high = kMaxHeartFactor * heart;
  for (int k = 0; k < kHeartSteps && low < high; ++k) {
    const double factor = 0.5 * (low + high);
    (lowest(factor) > -heart ? low : high) = factor;
  }
  for (Point& point : chain) point.y = moved_back(point, high);
}

/// Returns the edge without teeth as many points.
Chain entire_edge(const LeafBlade& blade) {
  Chain chain = blade.polygon.empty() ? chain_of(candidates(blade.outline)) : polygon_chain(blade);
  if (blade.heart > 0) {
    chain = with_base_points(chain);
    draw_back(chain, blade.heart);
  }
  return chain;
}

/// Returns the distance of a point from the segment, all scaled by `scale`.
double distance_to(Point point, Point from, Point to, Point scale) {
  return glm::length(from_segment(scale * (point - from), scale * (to - from)));
}

/// Returns the points of the chain that are needed to stay within `tolerance` half widths of it, by D. Douglas and T.
/// Peucker (1973).
Chain thinned(const Chain& chain, double aspect, double tolerance) {
  const Point scale{1, 1 / aspect};
  std::vector<bool> is_kept(chain.size(), false);
  is_kept.front() = is_kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> spans{{0, chain.size() - 1}};
  while (!spans.empty()) {
    const auto [begin, end] = spans.back();
    spans.pop_back();
    std::size_t farthest = begin;
    double max = tolerance;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const double distance = distance_to(chain[i], chain[begin], chain[end], scale);
      if (distance <= max) continue;
      max = distance;
      farthest = i;
    }
    if (farthest == begin) continue;
    is_kept[farthest] = true;
    spans.emplace_back(begin, farthest);
    spans.emplace_back(farthest, end);
  }
  Chain out;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (is_kept[i]) out.push_back(chain[i]);
  }
  return out;
}

/// The depth of cuts at each arc length of the edge.
struct Cuts {
  std::vector<double> place, depth;

  double at(double arc) const {
    const auto next = static_cast<std::size_t>(std::upper_bound(place.begin(), place.end(), arc) - place.begin());
    if (next == 0 || next == place.size()) return 0;
    const double span = place[next] - place[next - 1];
    const double share = span > 0 ? (arc - place[next - 1]) / span : 0;
    return depth[next - 1] + share * (depth[next] - depth[next - 1]);
  }
};

/// Returns teeth that get smaller toward base and tip. `depth` is in lengths.
Cuts make_cuts(const LeafBlade& blade, double total, double depth) {
  // The start of the k-th tooth: steps grow toward the middle, to three times the steps at the ends.
  const double begin = kEntireBase * total;
  const auto border = [&](int k) {
    const double even = static_cast<double>(k) / blade.teeth;
    return begin + (total - begin) * even * (0.4 + even * (1.8 - 1.2 * even));
  };
  const double largest = 1.3 * (total - begin) / blade.teeth;
  const double lean = 0.5 + 0.45 * blade.teeth_lean;
  Cuts cuts;
  for (int k = 0; k < blade.teeth; ++k) {
    const double from = border(k), to = border(k + 1);
    cuts.place.push_back(from);
    cuts.depth.push_back(k == 0 ? 0 : std::min(depth / largest, 0.8) * (to - from));
    cuts.place.push_back(from + lean * (to - from));
    cuts.depth.push_back(0);
  }
  cuts.place.push_back(total);
  cuts.depth.push_back(0);
  return cuts;
}

/// Returns an outline without an edge, as long as the chain.
LeafOutline outline_within(const Chain& chain) {
  LeafOutline outline;
  for (const Point point : chain) {
    outline.low = std::min(outline.low, point.y);
    outline.high = std::max(outline.high, point.y);
  }
  return outline;
}

/// Returns the chain with its edge cut inward.
Chain with_cuts(const Chain& chain, double aspect, const std::vector<double>& arcs, const Cuts& cuts) {
  const Point scale{aspect, 1};
  const auto inward = [&](std::size_t segment) {
    const Point along = scale * (chain[segment + 1] - chain[segment]);
    return glm::normalize(Point(-along.y, along.x));
  };
  const LeafOutline extent = outline_within(chain);
  Chain out;
  const auto cut_at = [&](Point point, Point direction, double depth) {
    Point moved = point + depth * std::min(1.0, kFullDepth * point.x) * direction / scale;
    moved = {std::max(moved.x, kThinnest * point.x), std::clamp(moved.y, extent.low, extent.high)};
    append(out, moved);
  };
  std::size_t cut = 0;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    // The corner itself, then the teeth's points on the way to the next corner.
    const Point at_corner = i == 0 ? inward(0) : inward(i - 1) + inward(i);
    const double size = glm::length(at_corner);
    if (i > 0) cut_at(chain[i], size > 0.1 ? at_corner / size : inward(i), cuts.at(arcs[i]));
    if (i == 0) append(out, chain[0]);
    for (; cut < cuts.place.size() && cuts.place[cut] < arcs[i + 1]; ++cut) {
      const double share = (cuts.place[cut] - arcs[i]) / (arcs[i + 1] - arcs[i]);
      cut_at(chain[i] + share * (chain[i + 1] - chain[i]), inward(i), cuts.depth[cut]);
    }
  }
  append(out, chain.back());
  return out;
}

Chain with_teeth(const LeafBlade& blade, const Chain& chain) {
  if (blade.teeth == 0 || blade.teeth_depth <= 0) return chain;
  const double aspect = aspect_of(blade);
  std::vector<double> arcs{0};
  for (std::size_t i = 1; i < chain.size(); ++i) {
    arcs.push_back(arcs.back() + glm::length(Point(aspect, 1) * (chain[i] - chain[i - 1])));
  }
  // Deep cuts between narrow lobes would meet, so reduce the depth until they do not.
  for (double depth = blade.teeth_depth * aspect; depth > 0.1 * blade.teeth_depth * aspect; depth /= 2) {
    Chain cut = with_cuts(chain, aspect, arcs, make_cuts(blade, arcs.back(), depth));
    if (!crosses_itself(cut)) return cut;
  }
  return chain;
}

/// Returns the right side of the convex hull of the blade and its mirror image, by A. Andrew's monotone chain (1979).
Chain convex_hull(Chain points, double low, double high) {
  points.emplace_back(0, low);
  points.emplace_back(0, high);
  std::sort(points.begin(), points.end(), [&](Point a, Point b) {
    // On the highest line, sort from right to left, so that the chain ends on the midrib.
    if (a.y != b.y) return a.y < b.y;
    return a.y >= high ? a.x > b.x : a.x < b.x;
  });
  Chain hull;
  for (const Point point : points) {
    while (hull.size() >= 2) {
      const Point a = hull[hull.size() - 2], b = hull.back();
      if (cross(b - a, point - a) > kParallel) break;
      hull.pop_back();
    }
    append(hull, point);
  }
  return hull;
}

/// Returns the point where the edges before and after edge i meet, outside of it.
std::optional<Point> meeting_beyond(const Chain& hull, std::size_t i) {
  const Point gap = hull[i + 1] - hull[i], in = hull[i] - hull[i - 1], out = hull[i + 1] - hull[i + 2];
  const double converge = cross(in, out);
  if (std::abs(converge) < kParallel) return std::nullopt;
  const double reach = cross(gap, out) / converge;
  if (reach <= 0) return std::nullopt;
  return hull[i] + reach * in;
}

/// Returns a convex hull that contains `hull`, lies in its box and has at most `count` edges, if possible.
Chain simpler_hull(Chain hull, std::size_t count, double low, double high) {
  while (hull.size() > count + 1) {
    // Remove the edge whose neighbours meet with the smallest gain in area.
    std::optional<std::size_t> best;
    double min = std::numeric_limits<double>::infinity();
    Point corner{0};
    for (std::size_t i = 1; i + 2 < hull.size(); ++i) {
      const auto meeting = meeting_beyond(hull, i);
      if (!meeting || meeting->x > 1 || meeting->y < low || meeting->y > high) continue;
      const double gained = std::abs(cross(hull[i + 1] - hull[i], *meeting - hull[i]));
      if (gained >= min) continue;
      min = gained;
      best = i;
      corner = *meeting;
    }
    if (!best) break;
    hull[*best] = corner;
    hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(*best) + 1);
  }
  return hull;
}

/// Returns even rows between base and tip. A row moves to the nearest corner of the edge if one is near.
std::vector<double> even_rows(int count, const LeafOutline& outline) {
  std::vector<double> corners;
  for (const Point point : outline.edge) corners.push_back(point.y);
  std::sort(corners.begin(), corners.end());
  std::vector<double> rows;
  const double space = (outline.high - outline.low) / count;
  for (int k = 1; k < count; ++k) {
    const double even = outline.low + k * space;
    const auto next = std::lower_bound(corners.begin(), corners.end(), even);
    double nearest = even;
    double distance = kSnap * space;
    if (next != corners.end() && *next - even < distance) distance = *next - even, nearest = *next;
    if (next != corners.begin() && even - *(next - 1) < distance) nearest = *(next - 1);
    rows.push_back(nearest);
  }
  return rows;
}

/// Sorts rows and keeps them at a distance from each other and from both ends.
void tidy_rows(LeafOutline& outline) {
  std::sort(outline.rows.begin(), outline.rows.end());
  std::vector<double> rows;
  for (const double row : outline.rows) {
    const bool is_inside = row > outline.low + kRowGap && row < outline.high - kRowGap;
    if (is_inside && (rows.empty() || row > rows.back() + kRowGap)) rows.push_back(row);
  }
  outline.rows = std::move(rows);
}

}  // namespace

LeafOutline full_outline(const LeafBlade& blade) {
  const Chain entire = entire_edge(blade);
  LeafOutline outline = outline_within(entire);
  outline.edge = with_teeth(blade, thinned(entire, aspect_of(blade), kFine));
  return outline;
}

LeafOutline mesh_outline(const LeafBlade& blade) {
  LeafOutline outline;
  const bool is_plain = blade.polygon.empty() && blade.heart <= 0 && blade.teeth == 0;
  if (is_plain && blade.edge == LeafBlade::Edge::shape) {
    const std::vector<Station> stations = choose_rows(blade);
    outline.edge = chain_of(stations);
    for (const Station station : stations) outline.rows.push_back(station.along);
  } else {
    const Chain entire = entire_edge(blade);
    outline = outline_within(entire);
    if (blade.edge == LeafBlade::Edge::picture) {
      // Teeth lie inside, except on a narrow lobe, where a tooth can come out on the other side.
      Chain points = with_teeth(blade, entire);
      points.insert(points.end(), entire.begin(), entire.end());
      outline.edge = simpler_hull(convex_hull(std::move(points), outline.low, outline.high),
                                  static_cast<std::size_t>(blade.rows), outline.low, outline.high);
      for (const Point point : outline.edge) outline.rows.push_back(point.y);
    } else {
      // Remove teeth that are so flat that they would only make slivers.
      const double aspect = aspect_of(blade);
      outline.edge = thinned(with_teeth(blade, thinned(entire, aspect, kCoarse / blade.rows)), aspect, kSliver);
      outline.rows = even_rows(blade.rows, outline);
    }
  }
  if (blade.waves > 0) {
    // Rows at crests, troughs and between. Other rows would hit different phases of the waves and show as streaks.
    outline.rows.clear();
    const int fourths = 4 * blade.waves;
    const int rows = fourths * std::max(1, blade.rows / fourths);
    const int last = static_cast<int>(std::ceil(outline.high * rows));
    for (int k = static_cast<int>(std::floor(outline.low * rows)); k < last; ++k) {
      outline.rows.push_back(static_cast<double>(k) / rows);
    }
  }
  tidy_rows(outline);
  return outline;
}

bool polygon_crosses_itself(const LeafBlade& blade) {
  LeafBlade sharp = blade;
  sharp.corners = LeafBlade::Corners::sharp;
  return crosses_itself(polygon_chain(sharp));
}

}  // namespace meristem
