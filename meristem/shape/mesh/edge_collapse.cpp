// SPDX-License-Identifier: Apache-2.0
// Simplifies a triangle mesh and approximately keeps its form. Each vertex stores, as a quadric, the planes of the
// triangles that it represents. The first edge to collapse is the one whose ends can become one vertex with the
// smallest sum of squared distances from their planes, weighted by area. A collapse that would break the surface, turn
// a triangle over or fold it onto its neighbour is skipped.
//
// Based on: M. Garland, P. Heckbert: Surface Simplification Using Quadric Error Metrics (1997); T. K. Dey, H.
// Edelsbrunner, S. Guha, D. V. Nekhayev: Topology Preserving Edge Contraction (1999), the link condition. Deviations:
// the new vertex then moves along the mean normal so that the volume stays. Without this, crowns of spheres reduced to
// 100 triangles lose a fifth of their volume. A weak spring keeps the position near the edge if the planes do not
// determine it, and among edges of cost 0 the short ones collapse first. The queue contains vertices instead of edges,
// each for its edges to higher vertices, in steps of cost. Costs are recomputed when a vertex reaches the front: sums
// of quadrics only grow, so an old cost is a lower bound.
//
// Why not meshoptimizer: its simplifier (0.18) has no link condition. A forked trunk of 38,820 triangles reduced to
// 5,000 had 54 edges with four triangles and 3.5 % less volume. At 500 triangles, the volume was 23 % less, because
// vertices do not move. A single call for 15 million triangles ran for 18 seconds and cannot be stopped.
#include "meristem/shape/mesh/edge_collapse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "meristem/shape/mesh/filled.h"

namespace meristem {

namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();
/// Stiffness of the spring toward the edge, as a share of the planes' weight.
constexpr double kSpring = 1e-5;
/// Stiffness of the spring that prevents spikes: apices of few triangles that stand out of round bodies. kTameCost
/// limits the increase of cost by this spring, which would be much larger at corners and ridges.
constexpr double kTameSpring = 0.05;
constexpr double kTameCost = 2;
/// Cost of an edge's squared length, as a share of the planes' weight.
constexpr double kShortEdges = 1e-5;
/// Maximum deviation of the surface, relative to the root mean square distance of a vertex from its planes. On spheres
/// this is 2.2 to 2.7.
constexpr double kWorstToMean = 3;
/// Sweeps continue down to this multiple of the wanted triangles, or to this number. A crown of 512,000 triangles is
/// reduced to 5,000 in 0.7 s with a root mean square distance of 0.95 mm, and without sweeps in 1.7 s with 0.92 mm.
constexpr std::size_t kSweepDownTo = 3;
constexpr std::size_t kSmallMesh = 32'768;
/// Maximum cost of an edge in a sweep, relative to the median before. At this cost, about a quarter of the triangles
/// remains.
constexpr float kSweepCost = 64;
/// Number of vertices in a part of a sweep: some 350 kB with their triangles.
constexpr std::uint32_t kSweepPart = 2048;
/// Maximum move of an apex to keep the volume, as a share of the edge's length.
constexpr double kVolumeShift = 0.5;
/// Minimum cosine of the angle that a collapse may turn a triangle: 75°.
constexpr double kTurn = 0.26;
/// Cosine of the angle between the normals of neighbours beyond which they count as folded: 143°.
constexpr double kFold = -0.8;
/// Minimum of twice the area divided by the squared longest side. Thinner triangles must not be made.
constexpr double kThin = 2e-3;
/// Below this value, a triangle's normal has no meaning.
constexpr double kNoNormal = 1e-5;
/// Maximum number of triangles around one vertex.
constexpr std::size_t kMaxAround = 40;

double longest_squared(DVec3 a, DVec3 b, DVec3 c) {
  return std::max({squared_length(b - a), squared_length(c - b), squared_length(a - c)});
}

}  // namespace

EdgeCollapse::EdgeCollapse(const Mesh& mesh, float error, const Progress& progress)
    : squared_error_(double{error} * error / (kWorstToMean * kWorstToMean)),
      corners_(mesh.triangles, mesh.vertex_count(), progress),
      queue_(mesh.vertex_count(), progress) {
  Box box;
  vertices_.reserve(mesh.vertex_count());
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (v % kItemsBetweenChecks == 0) progress.check();
    vertices_.push_back({.position = mesh.positions[v], .is_inner = corners_.is_inner(v)});
    box.add(mesh.positions[v]);
  }
  centre_ = DVec3(box.centre());
  add_quadrics(progress);
}

void EdgeCollapse::add_quadrics(const Progress& progress) {
  for (Corner c = 0; c < corners_.corner_count(); c += 3) {
    if (c % kItemsBetweenChecks < 3) progress.check();
    const std::array<std::uint32_t, 3> triangle{corners_.vertex(c), corners_.vertex(c + 1), corners_.vertex(c + 2)};
    const DVec3 a = position(triangle[0]);
    const DVec3 front = glm::cross(position(triangle[1]) - a, position(triangle[2]) - a);
    const double length = glm::length(front);
    if (!(length > 0)) continue;
    Quadric plane;
    plane.add_plane(front / length, a, length / 2);
    for (const std::uint32_t vertex : triangle) vertices_[vertex].quadric += plane;
  }
}

/// Returns a position as the mesh stores it. This call must not be inlined. GCC 12 omits the rounding to float for two
/// of the coordinates if it vectorises them together with the conversion back to double. Meshes would then depend on
/// the optimisation level.
[[gnu::noinline]] Vec3 EdgeCollapse::stored(DVec3 point) const { return Vec3(point + centre_); }

/// Visits the edges that may collapse and whose lower end is the vertex. Passes a corner at the vertex whose next
/// corner is at the other end.
template <class Visit>
void EdgeCollapse::for_each_edge(std::uint32_t vertex, Visit&& visit) const {
  if (!vertices_[vertex].is_inner) return;
  const Corner first = corners_.corner_of(vertex);
  Corner c = first;
  do {
    const std::uint32_t other = corners_.vertex(CornerTable::next(c));
    if (other > vertex && vertices_[other].is_inner) visit(other, c);
    c = corners_.turn(c);
  } while (c != first);
}

EdgeCollapse::Candidate EdgeCollapse::candidate(std::uint32_t low, std::uint32_t high, Corner corner) const {
  const Quadric& a = vertices_[low].quadric;
  const Quadric& b = vertices_[high].quadric;
  Quadric both = a;
  both += b;
  const double share = both.weight() > 0 ? b.weight() / both.weight() : 0.5;
  const DVec3 from = position(low);
  const DVec3 along = position(high) - from;
  DVec3 apex = both.min(from + share * along, kSpring);
  const DVec3 tame = both.min(from + share * along, kTameSpring);
  if (both.at(tame) < kTameCost * both.at(apex)) apex = tame;
  const double a_error = a.at(apex);
  const double b_error = b.at(apex);
  // Test each end separately: a large part next to a twig must not dominate the twig.
  const bool errs = a_error > squared_error_ * a.weight() || b_error > squared_error_ * b.weight();
  const double length_cost = kShortEdges * std::min(a.weight(), b.weight()) * squared_length(along);
  return {errs ? kNever : static_cast<float>(a_error + b_error + length_cost), corner, apex};
}

/// Returns the cheapest edge to a higher vertex that comes after `last`. Its cost is kNever if there is no such edge.
EdgeCollapse::Candidate EdgeCollapse::cheapest_after(const Candidate& last, std::uint32_t vertex) const {
  Candidate cheapest{kNever, 0, {}};
  for_each_edge(vertex, [&](std::uint32_t high, Corner c) {
    const Candidate edge = candidate(vertex, high, c);
    if (last.is_before(edge) && edge.is_before(cheapest)) cheapest = edge;
  });
  return cheapest;
}

void EdgeCollapse::run(std::size_t triangles, Progress& progress) {
  // If there is much to do, sweep over the mesh in parts that fit into a processor's cache, each up to a similar cost.
  // In the pure order of costs, most time is spent waiting for memory.
  const std::size_t enough = std::max(kSweepDownTo * triangles, kSmallMesh);
  std::size_t before = corners_.triangle_count() + 1;
  while (corners_.triangle_count() > enough && corners_.triangle_count() < before) {
    before = corners_.triangle_count();
    const float limit = kSweepCost * median_cost(progress);
    for (std::uint32_t v = 0; v < vertices_.size(); v += kSweepPart) {
      queue_.restart(limit);
      put_all(v, std::min(v + kSweepPart, static_cast<std::uint32_t>(vertices_.size())), progress);
      collapse_queued(enough, progress);
    }
  }
  queue_.restart(kNever);
  put_all(0, static_cast<std::uint32_t>(vertices_.size()), progress);
  collapse_queued(triangles, progress);
}

/// Returns the median cost of the vertices' cheapest edges, from a sample.
float EdgeCollapse::median_cost(const Progress& progress) const {
  std::vector<float> costs;
  const std::size_t stride = vertices_.size() / 4096 + 1;
  for (std::size_t v = 0; v < vertices_.size(); v += stride) {
    progress.check();
    const auto vertex = static_cast<std::uint32_t>(v);
    const float cost = corners_.corner_of(vertex) == CornerTable::kNone ? kNever : cheapest_after({}, vertex).cost;
    if (cost < kNever) costs.push_back(cost);
  }
  if (costs.empty()) return 0;
  std::nth_element(costs.begin(), costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2), costs.end());
  return costs[costs.size() / 2];
}

void EdgeCollapse::put_all(std::uint32_t begin, std::uint32_t end, const Progress& progress) {
  // Insert the last one first, so that lower ones are taken first.
  for (std::uint32_t v = end; v-- > begin;) {
    if (v % 1024 == 0) progress.check();
    if (corners_.corner_of(v) == CornerTable::kNone) continue;
    vertices_[v].is_blocked = false;
    const Candidate edge = cheapest_after({}, v);
    if (edge.cost < kNever) queue_.put(v, VertexQueue::step(edge.cost));
  }
}

void EdgeCollapse::collapse_queued(std::size_t triangles, Progress& progress) {
  std::size_t before = corners_.triangle_count();
  for (std::uint32_t round = 0; corners_.triangle_count() > triangles; ++round) {
    if (round % 1024 == 0) {
      progress.advance(before - corners_.triangle_count());
      before = corners_.triangle_count();
    }
    const std::uint32_t vertex = queue_.take();
    if (vertex == VertexQueue::kNone) return;
    if (corners_.corner_of(vertex) != CornerTable::kNone) consider(vertex);
  }
}

/// Collapses the cheapest edge of a vertex that may collapse, or moves the vertex to its present position in the queue.
void EdgeCollapse::consider(std::uint32_t vertex) {
  Candidate edge;
  while (true) {
    edge = cheapest_after(edge, vertex);
    if (!(edge.cost < kNever)) break;
    const std::uint32_t step = VertexQueue::step(edge.cost);
    if (step > queue_.current_step()) return queue_.put(vertex, step);
    if (!keeps_manifold(edge.corner)) continue;
    // The checks use the rounded position that will be stored.
    const DVec3 apex = rounded(with_volume(edge));
    if (keeps_form(apex) && keeps_folds(edge.corner, apex)) return collapse(edge.corner, apex);
  }
  vertices_[vertex].is_blocked = true;
}

/// Checks the link condition. Stores in `fan_` the remaining triangles around both ends, counter-clockwise.
bool EdgeCollapse::keeps_manifold(Corner corner) {
  const auto add = [&](Corner c) {
    fan_.push_back({c, corners_.vertex(CornerTable::next(c)), corners_.vertex(CornerTable::previous(c))});
  };
  fan_.clear();
  for (Corner c = corners_.turn(corner); corners_.turn(c) != corner; c = corners_.turn(c)) add(c);
  const std::size_t low_count = fan_.size();
  const Corner far = CornerTable::next(corner);
  for (Corner c = corners_.turn(corners_.turn(far)); c != far; c = corners_.turn(c)) add(c);
  // No triangle of a tetrahedron can be removed.
  if (fan_.size() > kMaxAround || (low_count == 1 && fan_.size() == 2)) return false;
  // The ends share the third corners of the edge's two triangles, and must share no other neighbour.
  for (std::size_t high = low_count + 1; high < fan_.size(); ++high) {
    for (std::size_t low = 0; low < low_count; ++low) {
      if (fan_[low].from == fan_[high].from || fan_[low].to == fan_[high].from) return false;
    }
  }
  return true;
}

/// Returns the apex, moved a limited distance so that the fan of the edge keeps the enclosed volume.
DVec3 EdgeCollapse::with_volume(const Candidate& edge) const {
  const std::uint32_t low = corners_.vertex(edge.corner);
  const DVec3 origin = position(low);
  const DVec3 high = position(corners_.vertex(CornerTable::next(edge.corner))) - origin;
  // Six times the volumes of tetrahedra with a corner at the low end. Triangles around this corner have no volume.
  DVec3 growth(0);
  double volume = 0;
  for (const FanTriangle& triangle : fan_) {
    const DVec3 across = glm::cross(position(triangle.from) - origin, position(triangle.to) - origin);
    growth += across;
    if (corners_.vertex(triangle.corner) != low) volume += glm::dot(high, across);
  }
  const double squared_growth = squared_length(growth);
  const double missing = volume - glm::dot(edge.apex - origin, growth);
  const double farthest = kVolumeShift * glm::length(high);
  if (!(std::abs(missing) < farthest * std::sqrt(squared_growth))) return edge.apex;
  return edge.apex + (missing / squared_growth) * growth;
}

/// Returns true if no triangle of the fan turns over or becomes thin when its corner moves to `apex`.
bool EdgeCollapse::keeps_form(DVec3 apex) {
  for (FanTriangle& triangle : fan_) {
    const DVec3 from = position(triangle.from);
    const DVec3 to = position(triangle.to);
    const DVec3 old_apex = position(corners_.vertex(triangle.corner));
    const DVec3 front = glm::cross(from - apex, to - apex);
    const DVec3 old_front = glm::cross(from - old_apex, to - old_apex);
    const double length = glm::length(front);
    const double old_length = glm::length(old_front);
    const double longest = longest_squared(apex, from, to);
    const double old_longest = longest_squared(old_apex, from, to);
    if (!(length > kNoNormal * longest)) return false;
    // A thin triangle may become less thin.
    if (length < kThin * longest && length * old_longest < old_length * longest) return false;
    const bool has_normal = old_length > kNoNormal * old_longest;
    if (has_normal && glm::dot(front, old_front) < kTurn * length * old_length) return false;
    triangle.normal = front / length;
  }
  return true;
}

/// Returns true if no two neighbours fold onto each other that did not before.
bool EdgeCollapse::keeps_folds(Corner corner, DVec3 apex) {
  const std::uint32_t low = corners_.vertex(corner);
  const std::uint32_t high = corners_.vertex(CornerTable::next(corner));
  const auto new_place = [&](std::uint32_t vertex) {
    return vertex == low || vertex == high ? apex : position(vertex);
  };
  double sharpest = 1;
  for (std::size_t k = 0; k < fan_.size(); ++k) {
    sharpest = std::min(sharpest, glm::dot(fan_[k].normal, fan_[(k + 1) % fan_.size()].normal));
    const Corner beyond = corners_.opposite(fan_[k].corner);
    if (beyond == CornerTable::kNone) continue;
    const DVec3 from = position(fan_[k].from);
    const DVec3 front = glm::cross(new_place(corners_.vertex(beyond)) - from, position(fan_[k].to) - from);
    const double length = glm::length(front);
    if (length > 0) sharpest = std::min(sharpest, glm::dot(fan_[k].normal, front) / length);
  }
  return sharpest > kFold || sharpest >= sharpest_fold(corner);
}

/// Returns the smallest cosine between the normals of neighbours if one of them has a corner at an end of the edge.
double EdgeCollapse::sharpest_fold(Corner corner) const {
  const auto front = [&](Corner c) {
    const DVec3 at = position(corners_.vertex(c));
    const DVec3 across = glm::cross(position(corners_.vertex(CornerTable::next(c))) - at,
                                    position(corners_.vertex(CornerTable::previous(c))) - at);
    const double length = glm::length(across);
    return length > 0 ? across / length : DVec3(0);
  };
  double sharpest = 1;
  for (const Corner first : {corner, CornerTable::next(corner)}) {
    Corner c = first;
    do {
      const DVec3 here = front(c);
      sharpest = std::min(sharpest, glm::dot(here, front(corners_.turn(c))));
      if (corners_.opposite(c) != CornerTable::kNone) {
        sharpest = std::min(sharpest, glm::dot(here, front(corners_.opposite(c))));
      }
      c = corners_.turn(c);
    } while (c != first);
  }
  return sharpest;
}

void EdgeCollapse::collapse(Corner corner, DVec3 apex) {
  const std::uint32_t low = corners_.vertex(corner);
  const std::uint32_t high = corners_.vertex(CornerTable::next(corner));
  corners_.collapse(corner);
  vertices_[low].position = stored(apex);
  vertices_[low].quadric += vertices_[high].quadric;
  // No edge around costs less than this one did. A vertex without a possible edge may have one now.
  queue_.put(low, queue_.current_step());
  for (const FanTriangle& triangle : fan_) {
    if (!vertices_[triangle.from].is_blocked) continue;
    vertices_[triangle.from].is_blocked = false;
    queue_.put(triangle.from, queue_.current_step());
  }
}

Mesh EdgeCollapse::mesh(const Progress& progress) const {
  Mesh mesh;
  mesh.triangles.reserve(corners_.triangle_count());
  std::vector<std::uint32_t> index = filled(vertices_.size(), std::uint32_t{0}, progress);
  // Number the vertices in their old order: mark the used ones with 1, then assign numbers.
  for (Corner c = 0; c < corners_.corner_count(); ++c) {
    if (c % kItemsBetweenChecks == 0) progress.check();
    if (corners_.vertex(c) != CornerTable::kNone) index[corners_.vertex(c)] = 1;
  }
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (v % kItemsBetweenChecks == 0) progress.check();
    if (index[v] == 0) continue;
    index[v] = static_cast<std::uint32_t>(mesh.vertex_count());
    mesh.positions.push_back(vertices_[v].position);
  }
  for (Corner c = 0; c < corners_.corner_count(); c += 3) {
    if (c % kItemsBetweenChecks < 3) progress.check();
    if (corners_.vertex(c) == CornerTable::kNone) continue;
    mesh.triangles.push_back({index[corners_.vertex(c)], index[corners_.vertex(c + 1)], index[corners_.vertex(c + 2)]});
  }
  return mesh;
}

}  // namespace meristem
