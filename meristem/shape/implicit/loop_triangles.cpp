// SPDX-License-Identifier: Apache-2.0
// Triangulates loops of crossed edges. The best triangulation of a loop is found from the best triangulations of its
// parts. A tunnel has a ring of inner points, one for each point of its shorter loop, and triangles from the ring to
// both loops. Triangles directly from loop to loop were tried first, but they cross each other in most tunnels, because
// the short paths lie on faces.
//
// If the signs alone decide the surface, the best diagonals equal the choice of common implementations, so that areas
// agree to the last digit. These follow one rule (first between parallel edges, then the right-handed one), except in
// the patterns with six points, which are listed. In all other patterns, the shortest diagonals are best.
//
// Based on: G. Klincsek: Minimal triangulations of polygonal domains (Annals of Discrete Mathematics 9, 1980).
#include "meristem/shape/implicit/loop_triangles.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "meristem/shape/implicit/cell_geometry.h"

namespace meristem {
namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();
// Costs relative to squared lengths of diagonals.
constexpr double kInnerPoint = 20;  // of an inner point; high, so that discs have few of them
constexpr double kSpoke = 0.3;      // of an edge from an inner point
constexpr double kNeighbours = 1;   // of a ring point that needs its neighbours; at 3, half of the tunnels between
                                    // loops of four cross themselves

/// The three diagonals, a path of four points, of six points in a pattern and its complement.
struct SixPoints {
  std::uint8_t pattern;
  std::array<std::uint8_t, 4> path;
};
constexpr std::array<SixPoints, 16> kSixPoints{{
    {0b00010111, {9, 1, 2, 10}},
    {0b00101011, {4, 11, 8, 7}},
    {0b01001101, {0, 6, 5, 3}},
    {0b01110001, {9, 4, 7, 10}},
    {0b00011011, {2, 4, 11, 2}},
    {0b00101110, {0, 7, 10, 0}},
    {0b00110101, {0, 7, 10, 0}},
    {0b01000111, {1, 6, 9, 1}},
    {0b01011100, {3, 5, 8, 3}},
    {0b01110010, {0, 7, 10, 0}},
    {0b00011101, {0, 6, 11, 0}},
    {0b00100111, {2, 5, 10, 2}},
    {0b00111010, {1, 7, 8, 1}},
    {0b01001110, {0, 6, 11, 0}},
    {0b01010011, {2, 5, 10, 2}},
    {0b01110100, {1, 7, 8, 1}},
}};

bool is_listed(std::uint8_t pattern, std::uint8_t a, std::uint8_t b) {
  for (const SixPoints& six : kSixPoints) {
    if (six.pattern != pattern && (six.pattern ^ 0xff) != pattern) continue;
    for (int k = 0; k < 3; ++k) {
      if (std::minmax(six.path[k], six.path[k + 1]) == std::minmax(a, b)) return true;
    }
  }
  return false;
}

/// Returns the direction along the edge, from its inside end to its outside end.
DVec3 outward(std::uint8_t edge, std::uint8_t pattern) {
  const auto [low, high] = edge_corners(edge);
  const DVec3 along = corner_place(high) - corner_place(low);
  return (pattern >> low & 1) != 0 ? along : -along;
}

/// Returns the cost of the diagonal between the points of two edges.
double diagonal_cost(std::uint8_t a, std::uint8_t b, std::uint8_t pattern, bool by_length) {
  if (a == b || share_a_face(1U << a | 1U << b)) return kForbidden;
  if (is_listed(pattern, a, b)) return 0;
  const DVec3 way = edge_middle(b) - edge_middle(a);
  // Across a square of four parallel edges, both diagonals are equal except for their direction.
  const double slant = way.x * way.y - way.x * way.z - way.y * way.z;
  const double handedness = glm::dot(way, glm::cross(outward(a, pattern), outward(b, pattern)));
  const double ties = -0.1 * handedness + 0.001 * slant;
  return (by_length ? glm::dot(way, way) : a / 4 == b / 4 ? 1 : 2) + ties;
}

struct Dissection {
  double cost = kForbidden;
  CellPieces pieces;
};

/// Finds the cheapest division of a polygon into triangles and polygons around an inner point.
class PolygonParts {
 public:
  PolygonParts(std::span<const std::uint8_t> polygon, std::uint8_t pattern)
      : polygon_(polygon),
        pattern_(pattern),
        by_length_(find_ambiguous_faces(pattern) != 0),
        size_(polygon.size()),
        parts_(size_ * size_) {}

  Dissection best() {
    for (std::size_t length = 1; length < size_; ++length) {
      for (std::size_t first = 0; first + length < size_; ++first) find(first, first + length);
    }
    Dissection result;
    result.cost = part(0, size_ - 1).cost;
    if (result.cost < kForbidden) collect(result.pieces);
    return result;
  }

 private:
  /// The polygon from one point to a later one, closed by the side between them.
  struct Part {
    double cost = 0;               ///< cost of the diagonals and inner points inside
    double closed = 0;             ///< cost with the closing side, which is free if the polygon has this side
    std::size_t apex = 0;          ///< apex of the triangle at the closing side; 0 if there is an inner point instead
    double chain = 0;              ///< cost of a chain of sides from the first point to the last, each with its part
                                   ///< and a spoke
    std::size_t before_last = 0;   ///< point before the last in this chain
    std::size_t around_inner = 0;  ///< point before the last in this chain, if the closing side is not allowed
  };
  Part& part(std::size_t first, std::size_t last) { return parts_[first * size_ + last]; }

  double closed(std::size_t first, std::size_t last) { return part(first, last).closed; }

  void find(std::size_t first, std::size_t last) {
    Part best{.chain = kForbidden};
    if (last > first + 1) {
      best.cost = kForbidden;
      for (std::size_t k = first + 1; k < last; ++k) {
        const double triangle = closed(first, k) + closed(k, last);
        if (triangle < best.cost) best.cost = triangle, best.apex = k;
        const double chain = part(first, k).chain + closed(k, last) + kSpoke;
        if (chain < best.chain) best.chain = chain, best.before_last = best.around_inner = k;
      }
      if (best.chain + kInnerPoint < best.cost) best.cost = best.chain + kInnerPoint, best.apex = 0;
      best.closed = best.cost + diagonal_cost(polygon_[first], polygon_[last], pattern_, by_length_);
    }
    part(first, last) = best;
    const double side = closed(first, last) + kSpoke;
    if (side < best.chain) part(first, last).chain = side, part(first, last).before_last = first;
  }

  void collect(CellPieces& pieces) {
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, size_ - 1}};
    while (!open.empty()) {
      const auto [first, last] = open.back();
      open.pop_back();
      if (last < first + 2) continue;
      const std::size_t apex = part(first, last).apex;
      if (apex == 0) {
        surround_inner_point(first, last, pieces, open);
        continue;
      }
      pieces.triangles.push_back({polygon_[first], polygon_[apex], polygon_[last]});
      open.emplace_back(first, apex);
      open.emplace_back(apex, last);
    }
  }

  void surround_inner_point(std::size_t first, std::size_t last, CellPieces& pieces,
                            std::vector<std::pair<std::size_t, std::size_t>>& open) {
    const auto inner = static_cast<std::uint8_t>(kCellEdges + pieces.inner.size());
    pieces.triangles.push_back({polygon_[last], polygon_[first], inner});
    std::uint16_t edges = static_cast<std::uint16_t>(1 << polygon_[last]);
    std::size_t before = part(first, last).around_inner;
    for (std::size_t at = last; at != first; at = std::exchange(before, part(first, before).before_last)) {
      pieces.triangles.push_back({polygon_[before], polygon_[at], inner});
      edges |= static_cast<std::uint16_t>(1 << polygon_[before]);
      open.emplace_back(before, at);
    }
    pieces.inner.push_back(edges);
  }

  std::span<const std::uint8_t> polygon_;
  std::uint8_t pattern_;
  bool by_length_;
  std::size_t size_;
  std::vector<Part> parts_;
};

/// For each point of the shorter loop, the points of the longer loop that it faces: runs with common ends, from
/// starts[k] to starts[k + 1].
struct Facing {
  double cost = kForbidden;
  std::vector<std::size_t> starts;
};

/// Returns the edges whose mean is a ring point: the k-th point of one loop and a run of the other. If these lie on one
/// face, the neighbours are included.
std::uint16_t ring_edges(const CellLoop& inner, std::size_t k, const CellLoop& outer, std::size_t from,
                         std::size_t to) {
  auto edges = static_cast<std::uint16_t>(1 << inner[k]);
  for (std::size_t j = from; j <= to; ++j) edges |= static_cast<std::uint16_t>(1 << outer[j % outer.size()]);
  if (!share_a_face(edges)) return edges;
  const std::size_t size = inner.size();
  return static_cast<std::uint16_t>(edges | 1 << inner[(k + 1) % size] | 1 << inner[(k + size - 1) % size]);
}

double facing_cost(const CellLoop& inner, const CellLoop& outer, const std::vector<std::size_t>& starts) {
  double cost = 0;
  for (std::size_t k = 0; k < inner.size(); ++k) {
    const std::uint16_t edges = ring_edges(inner, k, outer, starts[k], starts[k + 1]);
    if (share_a_face(edges)) return kForbidden;
    if (std::popcount(edges) > static_cast<int>(starts[k + 1] - starts[k]) + 2) cost += kNeighbours;
    for (std::size_t j = starts[k]; j <= starts[k + 1]; ++j) {
      const DVec3 way = edge_middle(outer[j % outer.size()]) - edge_middle(inner[k]);
      cost += glm::dot(way, way);
    }
  }
  return cost;
}

/// Returns the runs with the shortest paths, each of two points or more. Both loops must run in the same direction.
Facing find_facing(const CellLoop& inner, const CellLoop& outer) {
  Facing best;
  for (std::size_t first = 0; first < outer.size(); ++first) {
    // Try all other starts in ascending order: all subsets of the positions between.
    const std::size_t between = outer.size() - 1;
    for (unsigned chosen = 0; chosen < 1U << between; ++chosen) {
      if (static_cast<std::size_t>(std::popcount(chosen)) + 1 != inner.size()) continue;
      std::vector<std::size_t> starts{first};
      for (std::size_t k = 0; k < between; ++k) {
        if ((chosen >> k & 1) != 0) starts.push_back(first + 1 + k);
      }
      starts.push_back(first + outer.size());
      const double cost = facing_cost(inner, outer, starts);
      if (cost < best.cost) best = {cost, std::move(starts)};
    }
  }
  return best;
}

}  // namespace

void append(CellPieces& pieces, const CellPieces& more) {
  const std::size_t shift = pieces.inner.size();
  for (CellTriangle triangle : more.triangles) {
    for (std::uint8_t& point : triangle) {
      if (point >= kCellEdges) point = static_cast<std::uint8_t>(point + shift);
    }
    pieces.triangles.push_back(triangle);
  }
  pieces.inner.insert(pieces.inner.end(), more.inner.begin(), more.inner.end());
}

CellPieces triangulate_loop(const CellLoop& loop, std::uint8_t pattern) {
  if (loop.size() == 3) return {.triangles = {{loop[0], loop[1], loop[2]}}, .inner = {}};
  return PolygonParts(loop, pattern).best().pieces;
}

CellPieces triangulate_tunnel(const CellLoop& a, const CellLoop& b) {
  const CellLoop& inner = a.size() <= b.size() ? a : b;
  CellLoop outer = a.size() <= b.size() ? b : a;
  std::reverse(outer.begin(), outer.end());
  const std::vector<std::size_t> starts = find_facing(inner, outer).starts;
  const auto outer_at = [&](std::size_t k) { return outer[k % outer.size()]; };

  CellPieces pieces;
  for (std::size_t k = 0; k < inner.size(); ++k) {
    const std::size_t next = (k + 1) % inner.size();
    const auto point = static_cast<std::uint8_t>(kCellEdges + k),
               next_point = static_cast<std::uint8_t>(kCellEdges + next);
    pieces.inner.push_back(ring_edges(inner, k, outer, starts[k], starts[k + 1]));
    pieces.triangles.push_back({inner[k], inner[next], point});
    pieces.triangles.push_back({inner[next], next_point, point});
    for (std::size_t j = starts[k]; j < starts[k + 1]; ++j) {
      pieces.triangles.push_back({outer_at(j + 1), outer_at(j), point});
    }
    pieces.triangles.push_back({point, next_point, outer_at(starts[k + 1])});
  }
  return pieces;
}

}  // namespace meristem
