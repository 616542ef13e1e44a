// SPDX-License-Identifier: Apache-2.0
// Checks whether a mesh is closed: in a closed mesh, triangles pass every edge equally often in both directions. Edges
// are sorted, so equal edges are adjacent.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "meristem/base/reading_stop.h"
#include "meristem/scene/obstacle/closed_mesh.h"

namespace meristem {

namespace {

struct Edge {
  std::uint32_t low = 0;  // the smaller vertex index
  std::uint32_t high = 0;
  bool is_forward = false;  // from the smaller to the larger index
};

/// Returns, for each position, the index of the first equal position.
std::vector<std::uint32_t> welded(const std::vector<DVec3>& positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t k) { return std::array{positions[k].x, positions[k].y, positions[k].z}; };
  StopCounter stop;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    stop.step();
    return key(a) != key(b) ? key(a) < key(b) : a < b;
  });
  std::vector<std::uint32_t> first(positions.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    stop.step();
    first[order[k]] = k > 0 && key(order[k]) == key(order[k - 1]) ? first[order[k - 1]] : order[k];
  }
  return first;
}

std::vector<Edge> sorted_edges(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> first = welded(mesh.positions);
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  StopCounter stop;
  for (const auto& triangle : mesh.triangles) {
    stop.step();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = first[triangle[k]];
      const std::uint32_t to = first[triangle[(k + 1) % 3]];
      if (from != to) edges.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) {
    stop.step();
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  return edges;
}

struct Finding {
  std::size_t count = 0;
  Edge first;
  void add(const Edge& edge) {
    if (count++ == 0) first = edge;
  }
};

std::string text_of(DVec3 at) { return fmt::format("({:.7g}, {:.7g}, {:.7g})", at.x, at.y, at.z); }

void report(const Finding& finding, const char* what, const TriangleMesh& mesh, std::vector<std::string>& errors) {
  if (finding.count == 0) return;
  errors.push_back(
      fmt::format("{} {} {}; the first goes from {} to {}", finding.count, finding.count == 1 ? "edge is" : "edges are",
                  what, text_of(mesh.positions[finding.first.low]), text_of(mesh.positions[finding.first.high])));
}

/// Returns true if the surface encloses a point close to it. Tests points on both sides of some triangles.
bool encloses_something(const ClosedMesh& closed, const TriangleMesh& mesh, DVec3 size) {
  constexpr std::size_t kMaxTriangles = 1000;
  constexpr double kNear = 1e-4;  // share of the mesh's size
  const std::size_t step = mesh.triangles.size() / kMaxTriangles + 1;
  for (std::size_t k = 0; k < mesh.triangles.size(); k += step) {
    const auto [a, b, c] = mesh.triangles[k];
    const DVec3 corner = mesh.positions[a];
    const DVec3 across = glm::cross(mesh.positions[b] - corner, mesh.positions[c] - corner);
    const double area = glm::length(across);
    if (!(area > 0)) continue;
    const DVec3 middle = (corner + mesh.positions[b] + mesh.positions[c]) / 3.0;
    const DVec3 away = kNear * glm::length(size) / area * across;
    if (closed.contains(middle + away) || closed.contains(middle - away)) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> closedness_errors(const TriangleMesh& mesh) {
  Finding open;
  Finding turned;
  Finding crowded;
  const std::vector<Edge> edges = sorted_edges(mesh);
  StopCounter stop;
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    stop.step();
    std::size_t forward = 0;
    for (end = begin; end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high;
         ++end) {
      forward += edges[end].is_forward ? 1 : 0;
    }
    const std::size_t count = end - begin;
    if (2 * forward == count) continue;
    (count == 1 ? open : count == 2 ? turned : crowded).add(edges[begin]);
  }
  std::vector<std::string> errors;
  report(open, "open, with a triangle on one side only", mesh, errors);
  report(turned, "between triangles that are turned against each other", mesh, errors);
  report(crowded, "where more triangles meet one way than the other", mesh, errors);
  return errors;
}

std::string body_error(const TriangleMesh& mesh) {
  const ClosedMesh closed(mesh);
  Box box;
  for (const DVec3 position : mesh.positions) box.add(Vec3(position));
  const DVec3 size(box.size());
  if (closed.volume() > 1e-9 * size.x * size.y * size.z) return {};
  return encloses_something(closed, mesh, size) ? "crosses itself: as much of it is turned inside out as faces outward"
                                                : "encloses nothing";
}

}  // namespace meristem
