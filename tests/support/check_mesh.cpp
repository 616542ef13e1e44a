// SPDX-License-Identifier: Apache-2.0
// Checks the promises of meshes one after another, and names the first triangle that breaks one.
#include "tests/support/check_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>

namespace meristem {
namespace {

using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

/// Twice the area over the squared longest edge; triangles below it are degenerate. Rounding of 32-bit positions leaves
/// about 1e-7.
constexpr double kDegenerate = 1e-8;

bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

DVec3 corner(const Mesh& mesh, std::size_t triangle, int which) {
  return DVec3(mesh.positions[mesh.triangles[triangle][which]]);
}

/// Returns the triangle's front normal with the length of twice its area.
DVec3 doubled_area(const Mesh& mesh, std::size_t triangle) {
  const DVec3 origin = corner(mesh, triangle, 0);
  return glm::cross(corner(mesh, triangle, 1) - origin, corner(mesh, triangle, 2) - origin);
}

std::string named(const Mesh& mesh, std::size_t triangle) {
  std::string text = fmt::format("triangle {}", triangle);
  for (const std::uint32_t vertex : mesh.triangles[triangle]) {
    text += fmt::format(" {}", vertex);
    if (vertex >= mesh.vertex_count()) continue;
    const Vec3 at = mesh.positions[vertex];
    text += fmt::format("({}, {}, {})", at.x, at.y, at.z);
  }
  return text;
}

AssertionResult check_arrays(const Mesh& mesh) {
  const std::size_t count = mesh.vertex_count();
  if (!mesh.normals.empty() && mesh.normals.size() != count) {
    return AssertionFailure() << mesh.normals.size() << " normals for " << count << " vertices";
  }
  if (!mesh.uvs.empty() && mesh.uvs.size() != count) {
    return AssertionFailure() << mesh.uvs.size() << " uvs for " << count << " vertices";
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_finite(mesh.positions[i])) return AssertionFailure() << "position " << i << " is not finite";
    if (!mesh.normals.empty() && std::abs(glm::length(DVec3(mesh.normals[i])) - 1) > 1e-4) {
      return AssertionFailure() << "normal " << i << " has length " << glm::length(DVec3(mesh.normals[i]));
    }
    if (!mesh.normals.empty() && !is_finite(mesh.normals[i])) {
      return AssertionFailure() << "normal " << i << " is not finite";
    }
    if (!mesh.uvs.empty() && !is_finite(Vec3(mesh.uvs[i], 0))) {
      return AssertionFailure() << "uv " << i << " is not finite";
    }
  }
  return AssertionSuccess();
}

AssertionResult check_triangle(const Mesh& mesh, std::size_t triangle) {
  for (const std::uint32_t vertex : mesh.triangles[triangle]) {
    if (vertex >= mesh.vertex_count()) return AssertionFailure() << named(mesh, triangle) << " has no such vertex";
  }
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    longest = std::max(longest, glm::distance(corner(mesh, triangle, k), corner(mesh, triangle, (k + 1) % 3)));
  }
  const DVec3 front = doubled_area(mesh, triangle);
  if (!(glm::length(front) > kDegenerate * longest * longest)) {
    return AssertionFailure() << named(mesh, triangle) << " is degenerate";
  }
  if (mesh.normals.empty()) return AssertionSuccess();
  for (const std::uint32_t vertex : mesh.triangles[triangle]) {
    if (!(glm::dot(front, DVec3(mesh.normals[vertex])) > 0)) {
      return AssertionFailure() << named(mesh, triangle) << " lies behind the normal of vertex " << vertex;
    }
  }
  return AssertionSuccess();
}

/// Returns, for every vertex, the first vertex at its position.
std::vector<std::uint32_t> weld(const Mesh& mesh) {
  std::map<std::tuple<float, float, float>, std::uint32_t> first;
  std::vector<std::uint32_t> welded(mesh.vertex_count());
  for (std::uint32_t i = 0; i < welded.size(); ++i) {
    const Vec3 at = mesh.positions[i];
    welded[i] = first.try_emplace({at.x, at.y, at.z}, i).first->second;
  }
  return welded;
}

/// One side of a triangle, between welded vertices.
struct Side {
  std::uint32_t from, to, triangle;
  std::pair<std::uint32_t, std::uint32_t> edge() const { return std::minmax({from, to}); }
};

/// Returns all sides, sorted so that the sides of one edge are adjacent.
std::vector<Side> sorted_sides(const Mesh& mesh) {
  const std::vector<std::uint32_t> welded = weld(mesh);
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangle_count());
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      sides.push_back({welded[mesh.triangles[t][k]], welded[mesh.triangles[t][(k + 1) % 3]], t});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tuple(a.edge(), a.triangle) < std::tuple(b.edge(), b.triangle);
  });
  return sides;
}

AssertionResult check_edges(const Mesh& mesh, bool closed) {
  const std::vector<Side> sides = sorted_sides(mesh);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].edge() == sides[i].edge()) ++end;
    const std::string name = named(mesh, sides[i].triangle);
    if (end - i > 2) return AssertionFailure() << name << " has an edge with " << end - i << " triangles";
    if (closed && end - i == 1) {
      return AssertionFailure() << name << " has an open edge from " << sides[i].from << " to " << sides[i].to;
    }
    if (end - i == 2 && sides[i].from == sides[i + 1].from) {
      return AssertionFailure() << name << " is turned against " << named(mesh, sides[i + 1].triangle);
    }
    i = end;
  }
  return AssertionSuccess();
}

}  // namespace

AssertionResult check_mesh(const Mesh& mesh, MeshPromises promises) {
  if (AssertionResult arrays = check_arrays(mesh); !arrays) return arrays;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (AssertionResult triangle = check_triangle(mesh, t); !triangle) return triangle;
  }
  if (AssertionResult edges = check_edges(mesh, promises.closed); !edges) return edges;
  if (promises.closed && promises.outward && !mesh.triangles.empty() && !(signed_volume(mesh) > 0)) {
    return AssertionFailure() << "the signed volume is " << signed_volume(mesh);
  }
  return AssertionSuccess();
}

double signed_volume(const Mesh& mesh) {
  double sixfold = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    sixfold += glm::dot(corner(mesh, t, 0), glm::cross(corner(mesh, t, 1), corner(mesh, t, 2)));
  }
  return sixfold / 6;
}

double surface_area(const Mesh& mesh) {
  double doubled = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) doubled += glm::length(doubled_area(mesh, t));
  return doubled / 2;
}

long euler_number(const Mesh& mesh) {
  const std::vector<std::uint32_t> welded = weld(mesh);
  long vertices = 0;
  for (std::uint32_t i = 0; i < welded.size(); ++i) vertices += welded[i] == i ? 1 : 0;
  const std::vector<Side> sides = sorted_sides(mesh);
  long edges = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    edges += i == 0 || sides[i].edge() != sides[i - 1].edge() ? 1 : 0;
  }
  return vertices - edges + static_cast<long>(mesh.triangle_count());
}

}  // namespace meristem
