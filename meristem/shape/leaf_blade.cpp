// SPDX-License-Identifier: Apache-2.0
// The blade is a surface S(t, a): t along the midrib from 0 to 1, a metres across from it, both measured on the
// surface. The midrib is an arc of a circle that turns by `curl`; each cross-section is, on either side, an arc of a
// circle that starts raised by `fold` and sinks. Rows are chosen on the flat outline, where they reduce the error most;
// points are then put on the surface with its own normals.
#include "meristem/shape/leaf_blade.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "meristem/base/math.h"

namespace meristem {
namespace {

constexpr int kCandidates = 128;    // even places along the midrib where a row may stand
constexpr double kNearest = 1e-3;   // shares of the length: candidates closer than this count as one
constexpr double kLobe = 0.05;      // shares of half the width: smaller turns of the outline are not lobes
constexpr double kPointed = 1e-3;   // shares of half the width: narrower rows are one point
constexpr double kRunOut = 0.2;     // of the length: how far a stalk can be seen on the midrib, at most
constexpr double kRunOutRadii = 8;  // the same in radii of the stalk
constexpr double kStraight = 1e-6;  // radians: arcs that bend less are lines

void check(const LeafBlade& blade) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw std::invalid_argument(message);
  };
  const auto is_length = [](double value) { return std::isfinite(value) && value > 0; };
  require(is_length(blade.length) && is_length(blade.width), "a leaf blade needs a positive length and width");
  require(std::isfinite(blade.petiole) && blade.petiole >= 0, "a petiole's length is at least 0");
  require(blade.petiole == 0 || is_length(blade.petiole_radius), "a petiole needs a positive radius");
  require(std::isfinite(blade.curl + blade.curl_across + blade.fold), "a leaf blade's angles are finite");
  require(blade.rows >= 1, "a leaf blade has at least 1 row");
  require(blade.across >= 2 && blade.across % 2 == 0, "a leaf blade has an even number of quads across");
}

/// A place along the midrib and the outline's half width there, both as shares.
struct Station {
  double along, half_width;
};

/// Where rows may stand: the outline's own points and even places between.
std::vector<Station> candidates(const Curve& outline) {
  std::vector<double> places;
  for (const Vec2 point : outline.points()) {
    if (point.x > kNearest && point.x < 1 - kNearest) places.push_back(point.x);
  }
  const std::size_t own = places.size();
  for (int k = 1; k < kCandidates; ++k) {
    const double place = static_cast<double>(k) / kCandidates;
    const auto next = std::lower_bound(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(own), place);
    const bool is_near_next = next != places.begin() + static_cast<std::ptrdiff_t>(own) && *next - place < kNearest;
    const bool is_near_last = next != places.begin() && place - *(next - 1) < kNearest;
    if (!is_near_next && !is_near_last) places.push_back(place);
  }
  places.push_back(0);
  places.push_back(1);
  std::sort(places.begin(), places.end());
  std::vector<Station> stations;
  for (const double place : places) stations.push_back({place, std::max(0.0, outline(place))});
  return stations;
}

/// The indices at which the width turns from growing to falling or back by more than a lobe's depth.
std::vector<std::size_t> turning_points(const std::vector<Station>& stations) {
  std::vector<std::size_t> turns;
  std::size_t extreme = 0;
  int direction = 0;  // 0 until the width has changed at all
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

/// Candidates i to j as one straight row of quads: how far that is off, and where best to cut it.
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
    // The height of the midrib's arc over its chord.
    const double sagitta = blade.length * std::abs(blade.curl) * span * span / 8;
    if (sagitta < error) return;
    error = sagitta;
    const double middle = 0.5 * (low.along + high.along);
    cut = begin + 1;
    while (cut + 1 < end && stations[cut].along < middle - kNearest) ++cut;
  }
};

/// The rows from base to tip.
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
  // Cut the gap with the largest error (the widest where none has any) until there are enough.
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

/// A point of an arc in its own plane, which begins at the origin in a given direction and sinks.
struct ArcPoint {
  double forward, up, angle;
};

ArcPoint along_arc(double start_angle, double turn, double length) {
  const double end_angle = start_angle - turn;
  if (std::abs(turn) < kStraight) {
    const double middle = 0.5 * (start_angle + end_angle);
    return {length * math::cos(middle), length * math::sin(middle), end_angle};
  }
  const double radius = length / turn;
  return {radius * (math::sin(start_angle) - math::sin(end_angle)),
          radius * (math::cos(end_angle) - math::cos(start_angle)), end_angle};
}

class BladeMesher {
 public:
  explicit BladeMesher(const LeafBlade& blade) : blade_(blade) {}

  Mesh run() {
    if (blade_.petiole > 0) add_petiole();
    const std::vector<Station> rows = choose_rows(blade_);
    Row last = add_row(rows.front());
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const Row next = add_row(rows[i]);
      join(last, next);
      last = next;
    }
    return std::move(mesh_);
  }

 private:
  /// `count` vertices from the left edge to the right one, or a single one.
  struct Row {
    std::uint32_t first, count;
    std::uint32_t at(std::uint32_t k) const { return count == 1 ? first : first + k; }
  };

  Row add_row(const Station& station) {
    const Row row{static_cast<std::uint32_t>(mesh_.vertex_count()),
                  station.half_width < kPointed ? 1 : static_cast<std::uint32_t>(blade_.across + 1)};
    const int half = blade_.across / 2;
    for (std::uint32_t k = 0; k < row.count; ++k) {
      const int step = row.count == 1 ? 0 : static_cast<int>(k) - half;
      add_point(station.along, station.half_width * blade_.width / 2 * step / half);
    }
    return row;
  }

  /// The surface's point and normal at share `along` of the midrib, `across` metres to the right.
  void add_point(double along, double across) {
    const ArcPoint midrib = along_arc(0, blade_.curl * along, blade_.length * along);
    const DVec3 ahead{0, math::cos(midrib.angle), math::sin(midrib.angle)};
    const DVec3 upper{0, -ahead.z, ahead.y};
    const double away = std::abs(across);
    const ArcPoint section = along_arc(blade_.fold, blade_.curl_across / blade_.width * away, away);
    const double side = across > 0 ? 1 : across < 0 ? -1 : 0;
    const DVec3 right{1, 0, 0};
    const DVec3 position =
        DVec3(0, blade_.petiole + midrib.forward, midrib.up) + side * section.forward * right + section.up * upper;
    // On the midrib the two halves' normals mean the upper direction.
    const DVec3 normal = side == 0 ? upper : math::cos(section.angle) * upper - side * math::sin(section.angle) * right;
    add_vertex(Vec3(position), Vec3(normal), {0.5 + across / blade_.width, along});
  }

  void join(Row lower, Row upper) {
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(blade_.across); ++k) {
      // Diagonals mirror at the midrib, so that a blade bends alike on both sides.
      const bool is_left = k < static_cast<std::uint32_t>(blade_.across) / 2;
      const std::uint32_t a = lower.at(k), b = lower.at(k + 1), c = upper.at(k + 1), d = upper.at(k);
      add_triangle(a, b, is_left ? c : d);
      add_triangle(is_left ? a : b, c, d);
    }
  }

  /// A three-sided tube from the origin to the blade's base, which runs out into the midrib.
  void add_petiole() {
    const double r = blade_.petiole_radius;
    for (const double y : {0.0, blade_.petiole}) {
      for (int k = 0; k < 3; ++k) {
        const Vec3 out = petiole_side(k);
        add_vertex(Vec3(0, static_cast<float>(y), 0) + static_cast<float>(r) * out, out,
                   {0.49 + 0.01 * k, 0.01 * y / blade_.petiole});
      }
    }
    const double share = std::min(kRunOut, kRunOutRadii * r / blade_.length);
    const ArcPoint end = along_arc(0, blade_.curl * share, blade_.length * share);
    const DVec3 at{0, blade_.petiole + end.forward, end.up};
    const auto tip = static_cast<std::uint32_t>(mesh_.vertex_count());
    for (int k = 0; k < 3; ++k) {
      // Between this side and the next.
      add_vertex(Vec3(at), -petiole_side(k + 2), {0.495 + 0.01 * k, share});
    }
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t next = (k + 1) % 3;
      add_triangle(k, next, 3 + next);
      add_triangle(k, 3 + next, 3 + k);
      add_triangle(3 + k, 3 + next, tip + k);
    }
  }

  /// Three directions about y, counter-clockwise seen from the tip, one of them down.
  static Vec3 petiole_side(int k) {
    const double angle = 2 * kPi * (k % 3) / 3;
    return {-static_cast<float>(math::sin(angle)), 0, -static_cast<float>(math::cos(angle))};
  }

  void add_vertex(Vec3 position, Vec3 normal, glm::dvec2 uv) {
    mesh_.positions.push_back(position);
    mesh_.normals.push_back(normal);
    mesh_.uvs.emplace_back(uv);
  }

  /// Leaves out what a row of one point makes empty.
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) mesh_.triangles.push_back({a, b, c});
  }

  const LeafBlade& blade_;
  Mesh mesh_;
};

}  // namespace

Mesh make_leaf_blade(const LeafBlade& blade) {
  check(blade);
  return BladeMesher(blade).run();
}

}  // namespace meristem
