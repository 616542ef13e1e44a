// SPDX-License-Identifier: Apache-2.0
#include "tests/support/check_printable.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include <glm/vector_relational.hpp>

#include "tests/support/check_mesh.h"

namespace meristem {
namespace {

using Corners = std::array<DVec3, 3>;

double volume(const DVec3& a, const DVec3& b, const DVec3& c, const DVec3& d) {
  return glm::dot(glm::cross(b - a, c - a), d - a);
}

/// Returns true if the segment from `a` to `b` passes through the inside of the triangle.
bool crosses(const DVec3& a, const DVec3& b, const Corners& t) {
  if (volume(t[0], t[1], t[2], a) * volume(t[0], t[1], t[2], b) >= 0) return false;
  const std::array sides{volume(a, b, t[0], t[1]), volume(a, b, t[1], t[2]), volume(a, b, t[2], t[0])};
  return std::ranges::all_of(sides, [](double side) { return side > 0; }) ||
         std::ranges::all_of(sides, [](double side) { return side < 0; });
}

bool cross(const Corners& a, const Corners& b) {
  for (int k = 0; k < 3; ++k) {
    if (crosses(a[k], a[(k + 1) % 3], b) || crosses(b[k], b[(k + 1) % 3], a)) return true;
  }
  return false;
}

}  // namespace

testing::AssertionResult check_printable(const Mesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  std::vector<bool> is_used(mesh.vertex_count(), false);
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::pair side{triangle[k], triangle[(k + 1) % 3]};
      if (side.first >= mesh.vertex_count()) return testing::AssertionFailure() << "no vertex " << side.first;
      is_used[side.first] = true;
      if (!sides.insert(side).second) {
        return testing::AssertionFailure() << "two triangles run from " << side.first << " to " << side.second;
      }
    }
  }
  for (const auto& [from, to] : sides) {
    if (!sides.contains({to, from})) return testing::AssertionFailure() << "a hole beside " << from << " " << to;
  }
  const auto unused = std::find(is_used.begin(), is_used.end(), false);
  if (unused != is_used.end()) {
    return testing::AssertionFailure() << "vertex " << unused - is_used.begin() << " has no triangle";
  }
  const double inside = signed_volume(mesh);
  if (!(inside > 0)) return testing::AssertionFailure() << "the volume is " << inside;
  return testing::AssertionSuccess();
}

std::size_t count_crossings(const Mesh& mesh) {
  std::vector<Corners> corners;
  std::vector<std::pair<DVec3, DVec3>> boxes;
  for (const auto& triangle : mesh.triangles) {
    Corners& t = corners.emplace_back();
    for (int k = 0; k < 3; ++k) t[k] = DVec3(mesh.positions[triangle[k]]);
    boxes.emplace_back(glm::min(t[0], glm::min(t[1], t[2])), glm::max(t[0], glm::max(t[1], t[2])));
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      if (glm::any(glm::greaterThan(boxes[i].first, boxes[j].second)) ||
          glm::any(glm::greaterThan(boxes[j].first, boxes[i].second))) {
        continue;
      }
      const auto& a = mesh.triangles[i];
      const auto& b = mesh.triangles[j];
      const bool is_joined = std::ranges::any_of(a, [&](std::uint32_t v) { return std::ranges::count(b, v) > 0; });
      if (!is_joined && cross(corners[i], corners[j])) ++count;
    }
  }
  return count;
}

}  // namespace meristem
