// SPDX-License-Identifier: Apache-2.0
// In: a small mesh with uvs. Out: a mesh with fewer triangles between vertices of the first. Half-edges collapse,
// beginning with the one that moves the surface and its border least, and then whole pieces are removed. No vertex
// moves, so uvs and normals need no interpolation. For an equal count, the result is coarser than the result of
// simplify().
//
// Based on: M. Garland, P. Heckbert: Surface Simplification Using Quadric Error Metrics (1997), sections 4 and 6.
#include "meristem/shape/mesh/coarsen.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "meristem/base/fingerprint.h"
#include "meristem/base/random.h"
#include "meristem/base/vec.h"
#include "meristem/shape/mesh/even_order.h"
#include "meristem/shape/mesh/quadric.h"
#include "meristem/shape/mesh/shading.h"

namespace meristem {
namespace {

constexpr std::size_t kMaxTriangles = 2000;
constexpr std::size_t kManyPieces = 4;
constexpr double kSmallPiece = 0.2;  // share of the mean visible area of pieces; smaller pieces, such as a leaf's
                                     // stalk, are removed first
constexpr double kMaxWidening = 4;
constexpr double kMinCosine = 0.2;     // minimum cosine of the angle that a triangle may turn
constexpr double kFlatNormal = 0.999;  // cosine between the normals of a triangle and of its vertices
constexpr double kFlat = 0.5;          // visible share of the area of a flat (non-tube) piece, seen from one side

constexpr std::size_t kFewestClustered = 24;  // minimum number of triangles of a quick mesh that the cells of a grid
                                              // make
constexpr int kMaxGrids = 8;                  // maximum number of grids that are tried for a quick mesh
constexpr float kNextGrid = 1.35F;            // factor on the cells of the grid before

using Triangle = std::array<std::uint32_t, 3>;

/// Returns twice the area, along the normal.
DVec3 triangle_area_vector(const Mesh& mesh, const Triangle& triangle) {
  const DVec3 a(mesh.positions[triangle[0]]);
  return glm::cross(DVec3(mesh.positions[triangle[1]]) - a, DVec3(mesh.positions[triangle[2]]) - a);
}

bool has(const Triangle& triangle, std::uint32_t vertex) {
  return triangle[0] == vertex || triangle[1] == vertex || triangle[2] == vertex;
}

struct PositionHash {
  std::size_t operator()(const Vec3& p) const {
    return Fingerprint().add(p.x + 0.0F).add(p.y + 0.0F).add(p.z + 0.0F).hash();  // -0 is 0
  }
};

/// Returns the first vertex at the position of each vertex. Vertices of a seam share a point.
std::vector<std::uint32_t> points_of(const Mesh& mesh) {
  std::unordered_map<Vec3, std::uint32_t, PositionHash> first;
  first.reserve(mesh.vertex_count());
  std::vector<std::uint32_t> point(mesh.vertex_count());
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
    point[v] = first.try_emplace(mesh.positions[v], v).first->second;
  return point;
}

/// Collapses half-edges of a mesh. A seam collapses only along itself: if several vertices share a point, each of them
/// must have a target vertex on its own side.
class HalfEdgeCollapse {
 public:
  explicit HalfEdgeCollapse(Mesh& mesh)
      : mesh_(mesh), point_of_(points_of(mesh)), around_(mesh.vertex_count()), quadrics_(mesh.vertex_count()) {
    for (const Triangle& triangle : mesh.triangles) corners_.push_back(points(triangle));
    for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
      for (const std::uint32_t point : corners_[t]) around_[point].push_back(t);
    }
    add_planes();
    left_ = mesh.triangle_count();
    gone_.resize(left_, false);
    best_.resize(mesh.vertex_count());
    for (std::uint32_t point = 0; point < mesh.vertex_count(); ++point) update(point);
  }

  void run(std::size_t triangles) {
    while (left_ > triangles && !queue_.empty()) {
      const std::uint32_t from = queue_.begin()->second;
      collapse(from, best_[from].to);
    }
    std::size_t kept = 0;
    for (std::size_t t = 0; t < gone_.size(); ++t) {
      if (!gone_[t]) mesh_.triangles[kept++] = mesh_.triangles[t];
    }
    mesh_.triangles.resize(kept);
  }

 private:
  Triangle points(const Triangle& triangle) const {
    return {point_of_[triangle[0]], point_of_[triangle[1]], point_of_[triangle[2]]};
  }

  void add_planes() {
    for (const Triangle& triangle : corners_) {
      const DVec3 doubled = triangle_area_vector(mesh_, triangle);
      const double length = glm::length(doubled);
      if (!(length > 0)) continue;
      const DVec3 normal = (1 / length) * doubled;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = triangle[k];
        const std::uint32_t to = triangle[(k + 1) % 3];
        const DVec3 position(mesh_.positions[from]);
        quadrics_[from].add_plane(normal, position, length);
        if (triangles_at(from, to) != 1) continue;
        // A plane through the border, at right angles to the triangle, keeps the border in place.
        const DVec3 along = DVec3(mesh_.positions[to]) - position;
        const double square = glm::dot(along, along);
        const DVec3 outward = glm::cross(along, normal) * (1 / std::sqrt(square));
        quadrics_[from].add_plane(outward, position, square);
        quadrics_[to].add_plane(outward, position, square);
      }
    }
  }

  std::size_t triangles_at(std::uint32_t a, std::uint32_t b) const {
    return static_cast<std::size_t>(
        std::count_if(around_[a].begin(), around_[a].end(), [&](std::uint32_t t) { return has(corners_[t], b); }));
  }

  std::vector<std::uint32_t> neighbours(std::uint32_t point) const {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t t : around_[point]) {
      for (const std::uint32_t other : corners_[t]) {
        if (other != point) found.push_back(other);
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// The possible collapse of a point.
  struct Collapse {
    double cost = std::numeric_limits<double>::infinity();
    std::uint32_t to = 0;
  };

  /// Returns the cheapest collapse of the point. The cost is infinite if it has none. Ties go to the lowest target.
  Collapse cheapest(std::uint32_t from) const {
    Collapse best;
    if (around_[from].empty()) return best;
    const std::vector<std::uint32_t> near = neighbours(from);
    const bool is_border =
        std::any_of(near.begin(), near.end(), [&](std::uint32_t other) { return triangles_at(from, other) == 1; });
    for (const std::uint32_t to : near) {
      Quadric sum = quadrics_[from];
      sum += quadrics_[to];
      const double cost = sum.at(DVec3(mesh_.positions[to]));
      if (cost < best.cost && may_collapse(from, to, near, is_border)) best = {cost, to};
    }
    return best;
  }

  /// Recomputes the cheapest collapse of the point.
  void update(std::uint32_t point) {
    if (std::isfinite(best_[point].cost)) queue_.erase({best_[point].cost, point});
    best_[point] = cheapest(point);
    if (std::isfinite(best_[point].cost)) queue_.emplace(best_[point].cost, point);
  }

  /// Returns, for each vertex of `from`, the vertex of `to` that replaces it: its neighbour in a removed triangle.
  std::map<std::uint32_t, std::uint32_t> replacements(std::uint32_t from, std::uint32_t to) const {
    std::map<std::uint32_t, std::uint32_t> beside;
    for (const std::uint32_t t : around_[from]) {
      if (!has(corners_[t], to)) continue;
      const Triangle& triangle = mesh_.triangles[t];
      beside.try_emplace(vertex_at(triangle, from), vertex_at(triangle, to));
    }
    return beside;
  }

  std::uint32_t vertex_at(const Triangle& triangle, std::uint32_t point) const {
    return *std::find_if(triangle.begin(), triangle.end(),
                         [&](std::uint32_t vertex) { return point_of_[vertex] == point; });
  }

  /// Returns true if the surface stays a surface, no triangle turns over, and a part of the piece remains.
  bool may_collapse(std::uint32_t from, std::uint32_t to, const std::vector<std::uint32_t>& near,
                    bool is_border) const {
    const std::size_t shared = triangles_at(from, to);
    if (is_border && shared != 1) return false;
    if (around_[from].size() == shared && around_[to].size() == shared) return false;
    std::vector<std::uint32_t> common;
    const std::vector<std::uint32_t> others = neighbours(to);
    std::set_intersection(near.begin(), near.end(), others.begin(), others.end(), std::back_inserter(common));
    if (common.size() != shared) return false;
    const std::map<std::uint32_t, std::uint32_t> beside = replacements(from, to);
    for (const std::uint32_t t : around_[from]) {
      if (has(corners_[t], to)) continue;
      Triangle triangle = mesh_.triangles[t];
      const auto takes = beside.find(vertex_at(triangle, from));
      if (takes == beside.end()) return false;
      const DVec3 before = triangle_area_vector(mesh_, triangle);
      std::replace(triangle.begin(), triangle.end(), takes->first, takes->second);
      const DVec3 after = triangle_area_vector(mesh_, triangle);
      if (!(glm::dot(before, after) > kMinCosine * glm::length(before) * glm::length(after))) return false;
      if (!faces_its_normals(triangle, after)) return false;
    }
    return true;
  }

  /// Many small turns can add up to a large one. The normals belong to the first surface.
  bool faces_its_normals(const Triangle& triangle, DVec3 area) const {
    if (mesh_.normals.empty()) return true;
    return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t vertex) {
      return glm::dot(DVec3(mesh_.normals[vertex]), area) > kMinCosine * glm::length(area);
    });
  }

  void collapse(std::uint32_t from, std::uint32_t to) {
    std::vector<std::uint32_t> changed = neighbours(from);
    const std::map<std::uint32_t, std::uint32_t> beside = replacements(from, to);
    for (const std::uint32_t t : around_[from]) {
      Triangle& triangle = mesh_.triangles[t];
      if (has(corners_[t], to)) {
        gone_[t] = true;
        --left_;
        for (const std::uint32_t point : corners_[t]) {
          if (point != from) std::erase(around_[point], t);
        }
      } else {
        const std::uint32_t vertex = vertex_at(triangle, from);
        std::replace(triangle.begin(), triangle.end(), vertex, beside.at(vertex));
        corners_[t] = points(triangle);
        around_[to].push_back(t);
      }
    }
    around_[from].clear();
    quadrics_[to] += quadrics_[from];
    // A collapse depends on the triangles around both of its ends.
    const std::size_t ring = changed.size();
    for (std::size_t k = 0; k < ring; ++k) {
      const std::vector<std::uint32_t> near = neighbours(changed[k]);
      changed.insert(changed.end(), near.begin(), near.end());
    }
    changed.push_back(from);
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const std::uint32_t point : changed) update(point);
  }

  Mesh& mesh_;
  std::vector<std::uint32_t> point_of_;             // for each vertex
  std::vector<Triangle> corners_;                   // the points of each triangle
  std::vector<std::vector<std::uint32_t>> around_;  // triangles of each point
  std::vector<Quadric> quadrics_;
  std::vector<Collapse> best_;                        // for each point
  std::set<std::pair<double, std::uint32_t>> queue_;  // points that can collapse, by cost
  std::vector<bool> gone_;                            // for each triangle
  std::size_t left_ = 0;
};

/// Triangles that are connected by their vertices, or by edges at equal positions.
struct Piece {
  std::vector<Triangle> triangles;
  double area = 0;
  DVec3 one_sided{0};  // sum of area vectors

  bool is_flat() const { return glm::length(one_sided) > kFlat * area; }
  /// Returns its mean visible area relative to the area of flat pieces. A tube counts half, since it shows a quarter of
  /// its area on average and a leaf half.
  double shown() const { return is_flat() ? area : 0.5 * area; }
};

std::vector<Piece> pieces_of(const Mesh& mesh) {
  std::vector<std::uint32_t> root(mesh.vertex_count());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](std::uint32_t vertex) {
    while (root[vertex] != vertex) vertex = root[vertex] = root[root[vertex]];
    return vertex;
  };
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t first = find(a);
    const std::uint32_t other = find(b);
    root[std::max(first, other)] = std::min(first, other);
  };
  const std::vector<std::uint32_t> point = points_of(mesh);
  std::unordered_map<std::uint64_t, std::uint32_t> beside;  // indexed by edge
  beside.reserve(2 * mesh.triangle_count());
  for (const Triangle& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      join(triangle[0], triangle[k]);
      const auto [low, high] = std::minmax(point[triangle[k]], point[triangle[(k + 1) % 3]]);
      join(beside.try_emplace(std::uint64_t{low} << 32U | high, triangle[0]).first->second, triangle[0]);
    }
  }
  std::map<std::uint32_t, Piece> pieces;
  for (const Triangle& triangle : mesh.triangles) {
    Piece& piece = pieces[find(triangle[0])];
    const DVec3 area = 0.5 * triangle_area_vector(mesh, triangle);
    piece.triangles.push_back(triangle);
    piece.area += glm::length(area);
    piece.one_sided += area;
  }
  std::vector<Piece> list;
  for (auto& [vertex, piece] : pieces) list.push_back(std::move(piece));
  return list;
}

double area_of(const std::vector<Piece>& pieces) {
  double area = 0;
  for (const Piece& piece : pieces) area += piece.area;
  return area;
}

/// Removes pieces that are small relative to the others.
std::vector<Piece> without_small(std::vector<Piece> pieces) {
  double shown = 0;
  for (const Piece& piece : pieces) shown += piece.shown();
  const double min = kSmallPiece * shown / static_cast<double>(pieces.size());
  std::erase_if(pieces, [min](const Piece& piece) { return piece.shown() < min; });
  return pieces;
}

/// Returns an even choice of pieces with at most `triangles` triangles. At least one piece stays.
std::vector<Piece> chosen(std::vector<Piece> pieces, std::size_t triangles) {
  std::size_t count = 0;
  std::vector<std::uint32_t> kept;
  for (const std::uint32_t k : even_order(pieces.size(), RandomKey().child("pieces"))) {
    count += pieces[k].triangles.size();
    if (count > triangles && !kept.empty()) break;
    kept.push_back(k);
  }
  std::sort(kept.begin(), kept.end());
  std::vector<Piece> left;
  for (const std::uint32_t k : kept) left.push_back(std::move(pieces[k]));
  return left;
}

void take_triangles(Mesh& mesh, const std::vector<Piece>& pieces) {
  mesh.triangles.clear();
  for (const Piece& piece : pieces) {
    mesh.triangles.insert(mesh.triangles.end(), piece.triangles.begin(), piece.triangles.end());
  }
}

/// Stretches a flat piece at right angles to the line between its farthest vertices.
void widen(Mesh& mesh, const Piece& piece, double factor) {
  if (!piece.is_flat()) return;
  std::vector<std::uint32_t> vertices;
  for (const Triangle& triangle : piece.triangles) vertices.insert(vertices.end(), triangle.begin(), triangle.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  Vec3 base(0);
  Vec3 along(0);
  for (const std::uint32_t a : vertices) {
    for (const std::uint32_t b : vertices) {
      const Vec3 line = mesh.positions[b] - mesh.positions[a];
      if (glm::dot(line, line) > glm::dot(along, along)) std::tie(base, along) = std::pair(mesh.positions[a], line);
    }
  }
  for (const std::uint32_t vertex : vertices) {
    const Vec3 offset = mesh.positions[vertex] - base;
    const Vec3 foot = base + glm::dot(offset, along) / glm::dot(along, along) * along;
    mesh.positions[vertex] = foot + static_cast<float>(factor) * (mesh.positions[vertex] - foot);
  }
}

/// Returns true if all vertices have the normals of their triangles and some belong to a single triangle: the low-poly
/// look.
bool is_flat(const Mesh& mesh) {
  if (mesh.normals.empty()) return false;
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& triangle) {
    const DVec3 area = triangle_area_vector(mesh, triangle);
    return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t vertex) {
      return glm::dot(area, DVec3(mesh.normals[vertex])) > kFlatNormal * glm::length(area);
    });
  });
}

/// Returns a flat-shaded mesh whose triangles share their vertices where uvs agree.
Mesh joined(const Mesh& mesh) {
  Mesh whole;
  std::map<std::tuple<float, float, float, float, float>, std::uint32_t> known;
  for (const Triangle& triangle : mesh.triangles) {
    Triangle& shared = whole.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = mesh.positions[triangle[k]];
      const Vec2 uv = mesh.uvs.empty() ? Vec2(0) : mesh.uvs[triangle[k]];
      const auto next = static_cast<std::uint32_t>(whole.vertex_count());
      const auto [vertex, is_new] = known.try_emplace({p.x, p.y, p.z, uv.x, uv.y}, next);
      shared[k] = vertex->second;
      if (!is_new) continue;
      whole.positions.push_back(p);
      if (!mesh.uvs.empty()) whole.uvs.push_back(uv);
    }
  }
  return whole;
}

/// Returns the mesh without unused vertices.
Mesh without_loose_vertices(const Mesh& mesh) {
  constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
  Mesh left;
  std::vector<std::uint32_t> number(mesh.vertex_count(), kNone);
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) number[vertex] = 0;
  }
  for (std::uint32_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    if (number[vertex] == kNone) continue;
    number[vertex] = static_cast<std::uint32_t>(left.vertex_count());
    left.positions.push_back(mesh.positions[vertex]);
    if (!mesh.normals.empty()) left.normals.push_back(mesh.normals[vertex]);
    if (!mesh.uvs.empty()) left.uvs.push_back(mesh.uvs[vertex]);
  }
  for (const Triangle& t : mesh.triangles) left.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return left;
}

/// Cells of a grid over a mesh's box: as cubic as possible, at least two along its two longest sides.
struct ClusterGrid {
  Vec3 low{0};
  std::array<float, 3> per_metre{};
  std::array<std::uint32_t, 3> count{};

  ClusterGrid(const Box& box, float cell) : low(box.low) {
    const Vec3 size = box.size();
    const int thinnest = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      const float cells = std::min(size[k] / cell, 1000.0F);
      count[axis] = std::max(k == thinnest ? 1U : 2U, static_cast<std::uint32_t>(cells));
      per_metre[axis] = size[k] > 0 ? static_cast<float>(count[axis]) / size[k] : 0;
    }
  }

  std::uint64_t cell(Vec3 position) const {
    std::uint64_t number = 0;
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      const auto place = static_cast<std::uint32_t>((position[k] - low[k]) * per_metre[axis]);
      number = number * 1024 + std::min(place, count[axis] - 1);
    }
    return number;
  }
};

/// Returns the triangles between the vertices of the cells. In each cell, all vertices become the one farthest from the
/// middle.
std::vector<Triangle> joined_in_cells(const Mesh& mesh, const Box& box, const ClusterGrid& grid) {
  const Vec3 middle = box.centre();
  const auto distance = [&](std::uint32_t v) { return glm::distance(mesh.positions[v], middle); };
  // Vertices of removed pieces lie outside of the box.
  std::vector<bool> is_used(mesh.vertex_count());
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) is_used[vertex] = true;
  }
  std::vector<std::uint64_t> cells(mesh.vertex_count());
  std::unordered_map<std::uint64_t, std::uint32_t> vertex_of;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (!is_used[v]) continue;
    cells[v] = grid.cell(mesh.positions[v]);
    const auto [known, is_new] = vertex_of.try_emplace(cells[v], v);
    if (!is_new && distance(v) > distance(known->second)) known->second = v;
  }
  std::set<Triangle> known;
  std::vector<Triangle> triangles;
  for (const Triangle& triangle : mesh.triangles) {
    Triangle moved{vertex_of[cells[triangle[0]]], vertex_of[cells[triangle[1]]], vertex_of[cells[triangle[2]]]};
    if (moved[0] == moved[1] || moved[1] == moved[2] || moved[2] == moved[0]) continue;
    std::rotate(moved.begin(), std::min_element(moved.begin(), moved.end()), moved.end());
    if (known.insert(moved).second) triangles.push_back(moved);
  }
  return triangles;
}

/// Clusters vertices in few large cells, then in more, until the next grid would give more triangles than wanted. Does
/// nothing if even the coarsest grid gives too many.
void cluster(Mesh& mesh, std::size_t triangles) {
  Box box;
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) box.add(mesh.positions[vertex]);
  }
  const Vec3 size = box.size();
  const float sides = size.x * size.y + size.y * size.z + size.z * size.x;
  if (!(sides > 0)) return;
  float cell = std::sqrt(2 * sides / static_cast<float>(triangles));
  std::vector<Triangle> made;
  for (int k = 0; k < kMaxGrids; ++k) {
    made = joined_in_cells(mesh, box, ClusterGrid(box, cell));
    if (made.size() <= triangles) break;
    cell *= kNextGrid;
  }
  if (!made.empty()) mesh.triangles = std::move(made);
}

}  // namespace

Mesh quickly_coarsened(const Mesh& mesh, std::size_t triangles) {
  triangles = std::max<std::size_t>(triangles, 2);
  if (mesh.triangle_count() <= triangles) return mesh;
  if (is_flat(mesh)) {
    const Mesh whole = joined(mesh);
    Progress progress;
    if (whole.vertex_count() < mesh.vertex_count()) return flat_shaded(quickly_coarsened(whole, triangles), progress);
  }
  Mesh coarse = mesh;
  coarse.tangents.clear();
  std::vector<Piece> pieces = pieces_of(mesh);
  const double area = area_of(pieces);
  pieces = without_small(std::move(pieces));
  if (pieces.size() >= kManyPieces) {
    pieces = chosen(std::move(pieces), triangles);
    take_triangles(coarse, pieces);
    const double factor = std::clamp(area / std::max(area_of(pieces), 1e-30), 1.0, kMaxWidening);
    for (const Piece& piece : pieces) widen(coarse, piece, factor);
  } else {
    take_triangles(coarse, pieces);
    // A grid of such large cells does not preserve the outline.
    cluster(coarse, std::max(triangles, kFewestClustered));
    if (triangles < kFewestClustered) HalfEdgeCollapse(coarse).run(triangles);
  }
  return without_loose_vertices(coarse);
}

Mesh coarsened(const Mesh& mesh, std::size_t triangles) {
  if (mesh.triangle_count() <= std::max<std::size_t>(triangles, 2) || mesh.triangle_count() > kMaxTriangles)
    return mesh;
  if (is_flat(mesh)) {
    // Separate vertices per corner leave nothing to collapse, so join them first.
    const Mesh whole = joined(mesh);
    Progress progress;
    if (whole.vertex_count() < mesh.vertex_count()) return flat_shaded(coarsened(whole, triangles), progress);
  }
  std::vector<Piece> pieces = pieces_of(mesh);
  const double area = area_of(pieces);
  pieces = without_small(std::move(pieces));
  const bool are_many = pieces.size() >= kManyPieces;
  if (!are_many) triangles = std::max(triangles, 2 * pieces.size());

  Mesh coarse = mesh;
  coarse.tangents.clear();
  take_triangles(coarse, pieces);
  HalfEdgeCollapse(coarse).run(triangles);
  if (are_many) {
    pieces = pieces_of(coarse);
    if (coarse.triangle_count() > triangles) pieces = chosen(std::move(pieces), triangles);
    take_triangles(coarse, pieces);
    const double left = area_of(pieces);
    const double factor = left > 0 ? std::clamp(area / left, 1.0, kMaxWidening) : 1;
    for (const Piece& piece : pieces) widen(coarse, piece, factor);
  }
  return without_loose_vertices(coarse);
}

}  // namespace meristem
