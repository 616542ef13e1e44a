// SPDX-License-Identifier: Apache-2.0
// Builds a loft. Each section becomes a row of vertices, and each pair of neighbours a band of triangles that advances
// along both rows at once. Normals are means over the triangles at a vertex, weighted by angle. A sharp corner of a
// section therefore has two vertices, one for the arriving and one for the leaving side.
#include "meristem/shape/tube/loft.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "meristem/base/math.h"
#include "meristem/base/progress.h"
#include "meristem/shape/flat/flat_ring.h"
#include "meristem/shape/mesh/front_normals.h"

namespace meristem {

namespace {

constexpr double kSharpCosine = 0.766;  // cosine of 40°
constexpr double kSamePlace = 1e-6;     // share of a section's extent; nearer points of neighbouring sections are
                                        // joined
constexpr double kDegenerate = 1e-8;    // twice a triangle's area divided by its longest edge squared
constexpr double kFacing = 0.02;        // cosine between a normal and its triangle; below it, the triangle's normal is
                                        // used
constexpr double kSameLength = 1e-6;    // a diagonal is preferred if it is shorter by this share
constexpr std::uint32_t kOfCap = 0xffffffffU;

/// The vertices along a section, one column each. The columns of a ring begin and end at its first point.
struct Row {
  std::vector<Vec3> places;
  std::vector<double> u;
  std::vector<std::uint32_t> arriving, leaving;  ///< vertices, which differ only at corners
  bool is_point = false;
  bool is_smooth_ring = false;  ///< true if there is no corner at the first point

  std::size_t last() const { return places.size() - 1; }
};

class LoftMesher {
 public:
  LoftMesher(std::span<const LoftSection> sections, LoftCaps caps) : sections_(sections), caps_(caps) {}

  Loft run() {
    is_turned_ = faces_inward();
    for (std::size_t k = 0; k < sections_.size(); ++k) rows_.push_back(make_row(k));
    std::vector<double> along;
    for (std::size_t k = 0; k < sections_.size(); ++k) {
      loft_.first_triangle.push_back(triangle_count());
      const bool is_ring = sections_[k].is_closed && !sections_[k].is_point();
      const bool is_first = k == 0;
      const bool is_last = k + 1 == sections_.size();
      if (is_first && !is_last && is_ring && caps_.first) add_cap(rows_[k], false);
      along.push_back(is_first ? 0 : along.back() + add_band(rows_[k - 1], rows_[k], k));
      if (is_last && is_ring && caps_.last) add_cap(rows_[k], true);
    }
    loft_.first_triangle.push_back(triangle_count());
    for (std::size_t vertex = 0; vertex < row_of_.size(); ++vertex) {
      if (row_of_[vertex] == kOfCap || along.back() == 0) continue;
      mesh_.uvs[vertex].y = static_cast<float>(along[row_of_[vertex]] / along.back());
    }
    set_normals();
    drop_unused();
    Progress progress;
    turn_to_front(mesh_, progress);
    return std::move(loft_);
  }

 private:
  /// Decided by the sign of the volume between the rings, which is also correct for shapes that turn inside, like a
  /// cup.
  bool faces_inward() const {
    double volume = 0, extent = 0;
    bool has_ring = false;
    DVec3 area(0), centre(0);
    for (std::size_t k = 0; k < sections_.size(); ++k) {
      const std::vector<Vec3>& points = sections_[k].points;
      has_ring = has_ring || (sections_[k].is_closed && !sections_[k].is_point());
      const DVec3 last_area = std::exchange(area, area_vector(points));
      const DVec3 last_centre = std::exchange(centre, DVec3(0));
      for (const Vec3 point : points) centre += DVec3(point) / static_cast<double>(points.size());
      if (k > 0) volume += glm::dot(last_area + area, centre - last_centre);
      extent = std::max(extent, extent_of(points));
    }
    return has_ring && volume < -kSamePlace * extent * extent * extent;
  }

  Row make_row(std::size_t k) {
    const LoftSection& section = sections_[k];
    Row row;
    row.is_point = section.is_point();
    row.places = section.points;
    if (k > 0) join_same_places(rows_[k - 1], row);
    const bool is_ring = section.is_closed && !row.is_point;
    if (is_ring) row.places.push_back(row.places[0]);
    double length = 0;
    for (std::size_t c = 0; c <= row.last(); ++c) {
      if (c > 0) length += glm::distance(DVec3(row.places[c]), DVec3(row.places[c - 1]));
      row.u.push_back(length);
    }
    if (row.is_point) return row;  // its vertices are made together with their triangles
    row.is_smooth_ring = is_ring && !is_corner(section, 0);
    for (std::size_t c = 0; c <= row.last(); ++c) {
      row.u[c] = length > 0 ? row.u[c] / length : static_cast<double>(c) / static_cast<double>(row.last());
      const auto number = static_cast<std::uint32_t>(k);
      row.arriving.push_back(add_vertex(row.places[c], {row.u[c], 0}, number));
      const bool is_split = c > 0 && c < row.last() && is_corner(section, c);
      row.leaving.push_back(is_split ? add_vertex(row.places[c], {row.u[c], 0}, number) : row.arriving[c]);
    }
    return row;
  }

  /// Sections may touch, and rounding must not leave slivers between them.
  static void join_same_places(const Row& before, Row& row) {
    const double nearest = kSamePlace * extent_of(row.places);
    for (std::size_t c = 0; c < std::min(row.places.size(), before.places.size()); ++c) {
      if (glm::distance(DVec3(before.places[c]), DVec3(row.places[c])) < nearest) row.places[c] = before.places[c];
    }
  }

  /// Returns true if the section bends sharply at its point `k`. The ends of open rows do not count.
  static bool is_corner(const LoftSection& section, std::size_t k) {
    const std::vector<Vec3>& points = section.points;
    const std::size_t count = points.size();
    if (section.is_round || (!section.is_closed && (k == 0 || k + 1 == count))) return false;
    const DVec3 arriving = DVec3(points[k]) - DVec3(points[(k + count - 1) % count]);
    const DVec3 leaving = DVec3(points[(k + 1) % count]) - DVec3(points[k]);
    return glm::dot(arriving, leaving) < kSharpCosine * glm::length(arriving) * glm::length(leaving);
  }

  std::uint32_t add_vertex(Vec3 position, glm::dvec2 uv, std::uint32_t row) {
    mesh_.positions.push_back(position);
    mesh_.uvs.emplace_back(uv);
    row_of_.push_back(row);
    return static_cast<std::uint32_t>(mesh_.vertex_count() - 1);
  }

  /// Adds a triangle between vertices that run counter-clockwise while the section runs to the right and the surface
  /// goes up.
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (is_degenerate(mesh_.positions[a], mesh_.positions[b], mesh_.positions[c])) return;
    if (is_turned_) std::swap(b, c);
    mesh_.triangles.push_back({a, b, c});
  }

  static bool is_degenerate(DVec3 a, DVec3 b, DVec3 c) {
    const double longest = std::max({squared_length(b - a), squared_length(c - b), squared_length(a - c)});
    return !(glm::length(glm::cross(b - a, c - a)) > kDegenerate * longest);
  }

  /// Returns the mean distance across.
  double add_band(const Row& lower, const Row& upper, std::size_t k) {
    const auto number = static_cast<std::uint32_t>(k);
    if (lower.is_point && upper.is_point) return glm::distance(DVec3(lower.places[0]), DVec3(upper.places[0]));
    if (upper.is_point) return add_tip(lower, upper.places[0], number, true);
    if (lower.is_point) return add_tip(upper, lower.places[0], number - 1, false);
    return lower.last() == upper.last() ? add_quads(lower, upper) : add_walk(lower, upper);
  }

  double add_quads(const Row& lower, const Row& upper) {
    double across = 0;
    for (std::size_t c = 0; c <= lower.last(); ++c) {
      across += glm::distance(DVec3(lower.places[c]), DVec3(upper.places[c]));
      if (c == lower.last()) break;
      const std::array corners{lower.leaving[c], lower.arriving[c + 1], upper.arriving[c + 1], upper.leaving[c]};
      const int first = prefers_falling(lower, upper, c) ? 1 : 0;
      const auto corner = [&](int which) { return corners[static_cast<std::size_t>((first + which) % 4)]; };
      add_triangle(corner(0), corner(1), corner(2));
      add_triangle(corner(0), corner(2), corner(3));
    }
    return across / static_cast<double>(lower.places.size());
  }

  /// Returns true if the diagonal of a quad goes from its lower right to its upper left. This is so if it is shorter,
  /// or if the other diagonal leaves a triangle without area.
  static bool prefers_falling(const Row& lower, const Row& upper, std::size_t c) {
    const DVec3 a(lower.places[c]), b(lower.places[c + 1]), d(upper.places[c + 1]), e(upper.places[c]);
    const int lost_rising = (is_degenerate(a, b, d) ? 1 : 0) + (is_degenerate(a, d, e) ? 1 : 0);
    const int lost_falling = (is_degenerate(b, d, e) ? 1 : 0) + (is_degenerate(b, e, a) ? 1 : 0);
    if (lost_rising != lost_falling) return lost_falling < lost_rising;
    return glm::distance(b, e) < (1 - kSameLength) * glm::distance(a, d);
  }

  /// Advances along the row whose next edge has its middle first.
  double add_walk(const Row& lower, const Row& upper) {
    std::size_t i = 0, j = 0, ways = 1;
    double across = glm::distance(DVec3(lower.places[0]), DVec3(upper.places[0]));
    const auto middle = [](const Row& row, std::size_t c) {
      return c < row.last() ? 0.5 * (row.u[c] + row.u[c + 1]) : 2;
    };
    const auto vertex = [](const Row& row, std::size_t c, double at) {
      return row.u[c] < at ? row.leaving[c] : row.arriving[c];
    };
    while (i < lower.last() || j < upper.last()) {
      const double below = middle(lower, i), above = middle(upper, j);
      if (below < above + kSamePlace) {
        add_triangle(lower.leaving[i], lower.arriving[i + 1], vertex(upper, j, below));
        ++i;
      } else {
        add_triangle(vertex(lower, i, above), upper.arriving[j + 1], upper.leaving[j]);
        ++j;
      }
      across += glm::distance(DVec3(lower.places[i]), DVec3(upper.places[j]));
      ++ways;
    }
    return across / static_cast<double>(ways);
  }

  double add_tip(const Row& row, Vec3 tip, std::uint32_t number, bool is_up) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertex_count());
    double across = 0;
    for (std::size_t c = 0; c < row.last(); ++c) {
      across += glm::distance(DVec3(row.places[c]), DVec3(tip));
      const std::uint32_t apex = add_vertex(tip, {0.5 * (row.u[c] + row.u[c + 1]), 0}, number);
      const std::uint32_t a = row.leaving[c], b = row.arriving[c + 1];
      add_triangle(is_up ? a : b, is_up ? b : a, apex);
      sides_.push_back({a, b});
    }
    tips_.push_back({first, static_cast<std::uint32_t>(mesh_.vertex_count()), sides_.size() - row.last()});
    return across / static_cast<double>(row.last());
  }

  void add_cap(const Row& row, bool is_up) {
    // Both caps are seen from outside, so the ring at the base runs backward.
    std::vector<Vec3> ring(row.places.begin(), row.places.end() - 1);
    if (!is_up) std::ranges::reverse(ring);
    const DVec3 area = area_vector(ring);
    const double extent = extent_of(ring);
    if (!(glm::length(area) > kSamePlace * extent * extent)) return;
    const std::vector<glm::dvec2> flat = flattened(ring, area);
    const RingFace face = ring_face(flat);
    const auto first = static_cast<std::uint32_t>(mesh_.vertex_count());
    DVec3 middle(0);
    glm::dvec2 middle_uv(0);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      add_vertex(ring[k], flat[k], kOfCap);
      middle += DVec3(ring[k]) / static_cast<double>(ring.size());
      middle_uv += flat[k] / static_cast<double>(ring.size());
    }
    if (face.has_middle) add_vertex(Vec3(middle), middle_uv, kOfCap);
    for (const auto& [a, b, c] : face.triangles) add_triangle(first + a, first + b, first + c);
  }

  void set_normals() {
    std::vector<DVec3> sum(mesh_.vertex_count(), DVec3(0));
    for (const std::array<std::uint32_t, 3>& triangle : mesh_.triangles) {
      std::array<DVec3, 3> at;
      for (std::size_t k = 0; k < 3; ++k) at[k] = DVec3(mesh_.positions[triangle[k]]);
      const DVec3 normal = glm::normalize(glm::cross(at[1] - at[0], at[2] - at[0]));
      for (std::size_t k = 0; k < 3; ++k) {
        const DVec3 to_next = glm::normalize(at[(k + 1) % 3] - at[k]),
                    to_last = glm::normalize(at[(k + 2) % 3] - at[k]);
        sum[triangle[k]] += math::acos(std::clamp(glm::dot(to_next, to_last), -1.0, 1.0)) * normal;
      }
    }
    for (const Row& row : rows_) {
      if (!row.is_smooth_ring) continue;
      const DVec3 both = sum[row.leaving.front()] + sum[row.arriving.back()];
      sum[row.leaving.front()] = sum[row.arriving.back()] = both;
    }
    for (DVec3& normal : sum) normal = glm::length(normal) > 0 ? glm::normalize(normal) : DVec3(kUp);
    for (const Tip& tip : tips_) set_tip_normals(tip, sum);
    for (const DVec3 normal : sum) mesh_.normals.emplace_back(normal);
  }

  /// The vertices of one point, each for one side of the surface. The sides are in `sides_`.
  struct Tip {
    std::uint32_t begin, end;
    std::size_t first_side;
  };

  /// A blunt tip has one normal. On a pointed tip, each side keeps its own normal.
  void set_tip_normals(const Tip& tip, std::vector<DVec3>& normals) const {
    DVec3 mean(0);
    for (std::uint32_t vertex = tip.begin; vertex < tip.end; ++vertex) mean += normals[vertex];
    mean = glm::length(mean) > 0 ? glm::normalize(mean) : DVec3(kUp);
    double min = 1;
    for (std::uint32_t vertex = tip.begin; vertex < tip.end; ++vertex) {
      min = std::min(min, glm::dot(normals[vertex], mean));
    }
    for (std::uint32_t vertex = tip.begin; vertex < tip.end; ++vertex) {
      const auto [a, b] = sides_[tip.first_side + (vertex - tip.begin)];
      const DVec3 side = normals[a] + normals[b];
      if (min > kSharpCosine) {
        normals[vertex] = mean;
      } else if (glm::dot(side, normals[vertex]) > kFacing * glm::length(side)) {
        normals[vertex] = glm::normalize(side);
      }
    }
  }

  /// Where sections touch, vertices have no triangle.
  void drop_unused() {
    std::vector<std::uint32_t> number(mesh_.vertex_count(), kOfCap);
    for (const auto& triangle : mesh_.triangles) {
      for (const std::uint32_t vertex : triangle) number[vertex] = 0;
    }
    std::uint32_t kept = 0;
    for (std::size_t vertex = 0; vertex < number.size(); ++vertex) {
      if (number[vertex] == kOfCap) continue;
      mesh_.positions[kept] = mesh_.positions[vertex];
      mesh_.normals[kept] = mesh_.normals[vertex];
      mesh_.uvs[kept] = mesh_.uvs[vertex];
      number[vertex] = kept++;
    }
    mesh_.positions.resize(kept);
    mesh_.normals.resize(kept);
    mesh_.uvs.resize(kept);
    for (auto& triangle : mesh_.triangles) {
      for (std::uint32_t& vertex : triangle) vertex = number[vertex];
    }
  }

  std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(mesh_.triangle_count()); }

  std::span<const LoftSection> sections_;
  LoftCaps caps_;
  bool is_turned_ = false;
  std::vector<Row> rows_;
  std::vector<Tip> tips_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides_;  // vertices at the foot of each triangle of a tip
  std::vector<std::uint32_t> row_of_;                           // for each vertex
  Loft loft_;
  Mesh& mesh_ = loft_.mesh;
};

}  // namespace

Loft make_loft(std::span<const LoftSection> sections, LoftCaps caps) {
  for (const LoftSection& section : sections) {
    if (section.points.empty()) throw std::invalid_argument("a section of a loft needs points");
    for (const Vec3 point : section.points) {
      const bool is_finite = std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
      if (!is_finite) throw std::invalid_argument("the points of a loft's section must be finite");
    }
  }
  return LoftMesher(sections, caps).run();
}

}  // namespace meristem
