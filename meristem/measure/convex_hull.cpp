// SPDX-License-Identifier: Apache-2.0
// In space, qhull makes the hull from triangles; its messages are dropped. A large cloud is first thinned: a point
// inside the hull of some of the points is not on the hull of all. In the plane, the points are sorted, and one pass
// along either side finds the hull.
//
// Based on: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, The Quickhull algorithm for convex hulls, 1996; A. M. Andrew,
// Another efficient algorithm for convex hulls in two dimensions, 1979.
#include "meristem/measure/convex_hull.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "meristem/base/parallel.h"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace meristem {
namespace {

constexpr std::size_t kPointsPerHullBlock = 8192;
constexpr double kFlat = 1e-5;  // share of the longest edge of the box around the points: thinner hulls count as flat

/// A qhull computation and its memory, without output.
class Qhull {
 public:
  Qhull() : silent_(fmemopen(nullptr, kMessageBytes, "w"), &std::fclose) {
    if (silent_ == nullptr) throw std::bad_alloc();
    qh_zero(&state_, silent_.get());
  }
  ~Qhull() {
    qh_freeqhull(&state_, !qh_ALL);
    int blocks = 0;
    int bytes = 0;
    qh_memfreeshort(&state_, &blocks, &bytes);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  /// Returns qhull's exit code. The coordinates must outlive this object.
  int run(std::vector<double>& coordinates, std::string options) {
    return qh_new_qhull(&state_, 3, static_cast<int>(coordinates.size() / 3), coordinates.data(), 0, options.data(),
                        nullptr, silent_.get());
  }

  /// Returns the corners of each facet as indices of points, counter-clockwise as seen from outside.
  std::vector<std::array<std::uint32_t, 3>> triangles() {
    std::vector<std::array<std::uint32_t, 3>> found;
    for (facetT* facet = state_.facet_list; facet != nullptr && facet->next != nullptr; facet = facet->next) {
      setT* corners = qh_facet3vertex(&state_, facet);  // clockwise from outside
      if (qh_setsize(&state_, corners) == 3)
        found.push_back({point_of(corners, 0), point_of(corners, 2), point_of(corners, 1)});
      qh_settempfree(&state_, &corners);
    }
    return found;
  }

 private:
  std::uint32_t point_of(setT* corners, int which) {
    return static_cast<std::uint32_t>(qh_pointid(&state_, SETelemt_(corners, which, vertexT)->point));
  }

  static constexpr std::size_t kMessageBytes = 1 << 16;  // longer messages are cut

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> silent_;
  qhT state_{};
};

/// Returns a mesh with only those points that triangles use, in the order of the points.
Mesh compact_mesh(std::span<const Vec3> points, std::vector<std::array<std::uint32_t, 3>> triangles) {
  std::vector<std::uint32_t> used;
  for (const auto& triangle : triangles) used.insert(used.end(), triangle.begin(), triangle.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  Mesh mesh;
  for (const std::uint32_t index : used) mesh.positions.push_back(points[index]);
  for (auto& triangle : triangles) {
    for (std::uint32_t& corner : triangle) {
      corner = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), corner) - used.begin());
    }
  }
  mesh.triangles = std::move(triangles);
  return mesh;
}

Mesh hull_by_qhull(std::span<const Vec3> points) {
  Box box;
  for (const Vec3 point : points) box.add(point);
  if (points.size() < 4) return {};
  // Coordinates count from the middle, so that a tree far from the origin loses no digits.
  const DVec3 middle(box.centre());
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Vec3 point : points) {
    for (int k = 0; k < 3; ++k) coordinates.push_back(double{point[k]} - middle[k]);
  }
  Mesh mesh;
  // Try triangulated facets first. Rounding can make them fail, so then try joggled points.
  for (const char* const options : {"qhull Qt", "qhull QJ"}) {
    Qhull qhull;
    const int code = qhull.run(coordinates, options);
    if (code == qh_ERRnone) {
      mesh = compact_mesh(points, qhull.triangles());
      break;
    }
    if (code == qh_ERRmem) throw std::bad_alloc();
    if (code == qh_ERRinput || code == qh_ERRsingular) break;
  }
  const Vec3 size = box.size();
  const double longest = std::max({size.x, size.y, size.z});
  if (volume_of(mesh) <= kFlat * longest * surface_area_of(mesh)) return {};
  return mesh;
}

/// Returns the points that lie on the hull of their block, in their order. Keeps all points of a flat block.
std::vector<Vec3> thinned(std::span<const Vec3> points, const Progress* progress) {
  std::vector<std::vector<Vec3>> blocks((points.size() + kPointsPerHullBlock - 1) / kPointsPerHullBlock);
  parallel_for(points.size(), kPointsPerHullBlock, [&](std::size_t begin, std::size_t end) {
    if (progress != nullptr) progress->check();
    const auto block = points.subspan(begin, end - begin);
    Mesh hull = hull_by_qhull(block);
    std::vector<Vec3>& kept = blocks[begin / kPointsPerHullBlock];
    if (hull.positions.empty()) {
      kept.assign(block.begin(), block.end());
    } else {
      kept = std::move(hull.positions);
    }
  });
  std::vector<Vec3> all;
  for (const auto& kept : blocks) all.insert(all.end(), kept.begin(), kept.end());
  return all;
}

double cross(Vec2 origin, Vec2 a, Vec2 b) {
  return (double{a.x} - origin.x) * (double{b.y} - origin.y) - (double{a.y} - origin.y) * (double{b.x} - origin.x);
}

}  // namespace

Mesh convex_hull(std::span<const Vec3> points, const Progress* progress) {
  std::vector<Vec3> fewer;
  // Repeat until thinning removes less than half of the points.
  while (points.size() > 2 * kPointsPerHullBlock) {
    std::vector<Vec3> next = thinned(points, progress);
    const bool is_worthwhile = next.size() <= points.size() / 2;
    fewer = std::move(next);
    points = fewer;
    if (!is_worthwhile) break;
  }
  return hull_by_qhull(points);
}

std::vector<Vec2> convex_outline(std::vector<Vec2> points) {
  const auto before = [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> outline;
  // Walk along the lower side to the right, then along the upper side back.
  const auto walk = [&](auto begin, auto end) {
    const std::size_t start = outline.size();
    for (auto point = begin; point != end; ++point) {
      while (outline.size() >= start + 2 && cross(outline[outline.size() - 2], outline.back(), *point) <= 0)
        outline.pop_back();
      outline.push_back(*point);
    }
    outline.pop_back();
  };
  walk(points.begin(), points.end());
  walk(points.rbegin(), points.rend());
  return outline;
}

double surface_area_of(const Mesh& mesh) {
  double twice = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const DVec3 corner(mesh.positions[a]);
    twice += glm::length(glm::cross(DVec3(mesh.positions[b]) - corner, DVec3(mesh.positions[c]) - corner));
  }
  return twice / 2;
}

double volume_of(const Mesh& mesh) {
  if (mesh.positions.empty()) return 0;
  const DVec3 origin(mesh.positions.front());
  double six_times = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    six_times += glm::dot(DVec3(mesh.positions[a]) - origin,
                          glm::cross(DVec3(mesh.positions[b]) - origin, DVec3(mesh.positions[c]) - origin));
  }
  return six_times / 6;
}

OutlineSize measure_outline(std::span<const Vec2> outline) {
  OutlineSize size;
  const std::size_t count = outline.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2 next = outline[(k + 1) % count];
    size.area += cross(outline[0], outline[k], next) / 2;
    size.perimeter += glm::distance(glm::dvec2(outline[k]), glm::dvec2(next));
  }
  if (count == 2) size.diameter = size.perimeter / 2;
  if (count < 3) return size;
  // The point farthest from an edge advances as the edge does. The ends of the edges and their farthest points contain
  // the farthest pair.
  const auto distance = [&](std::size_t a, std::size_t b) {
    return glm::distance(glm::dvec2(outline[a]), glm::dvec2(outline[b]));
  };
  std::size_t far = 1;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t next = (k + 1) % count;
    while (cross(outline[k], outline[next], outline[(far + 1) % count]) >
           cross(outline[k], outline[next], outline[far]))
      far = (far + 1) % count;
    size.diameter = std::max({size.diameter, distance(k, far), distance(next, far)});
  }
  return size;
}

}  // namespace meristem
