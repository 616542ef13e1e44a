// SPDX-License-Identifier: Apache-2.0
// Closed meshes of distance fields by a simple method, as inputs of tests and benchmarks of meshes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/base/mesh.h"
#include "meristem/base/random.h"

namespace meristem {

/// Returns the surface where `distance` (negative inside, slope at most 1) is 0. Divides each cube of a grid over
/// `box`, with `cells` along its longest side, into six tetrahedra. The mesh is closed and faces outward if the body is
/// inside the box. It has about 2.8 triangles per square of a cell's size.
inline Mesh field_mesh(FunctionRef<float(Vec3)> distance, const Box& box, int cells) {
  const Vec3 size = box.size();
  const float cell = std::max({size.x, size.y, size.z}) / static_cast<float>(cells);
  const glm::ivec3 count = glm::ivec3(glm::ceil(size / cell)) + 1;
  const auto index = [&](glm::ivec3 c) { return (static_cast<std::uint64_t>(c.z) * count.y + c.y) * count.x + c.x; };
  const auto place = [&](glm::ivec3 c) { return box.low + cell * Vec3(c); };
  const auto corner = [](glm::ivec3 c, int bits) { return c + glm::ivec3(bits & 1, (bits >> 1) & 1, bits >> 2); };

  // Skip blocks far from the surface: those whose centre is farther away than their corners.
  constexpr int kBlock = 8;
  constexpr float kFar = 1e9F;
  Mesh mesh;
  std::unordered_map<std::uint64_t, std::uint32_t> vertices;
  std::vector<float> values((kBlock + 1) * (kBlock + 1) * (kBlock + 1), kFar);
  const auto march = [&](glm::ivec3 first, glm::ivec3 cube) {
    std::array<float, 8> value{};
    for (int k = 0; k < 8; ++k) {
      const glm::ivec3 at = corner(cube, k) - first;
      value[k] = values[(at.z * (kBlock + 1) + at.y) * (kBlock + 1) + at.x];
    }
    const auto vertex = [&](int a, int b) {
      const int low = a & b;
      const int high = a | b;
      const auto [found, is_new] = vertices.try_emplace(index(corner(cube, low)) * 8 + (high ^ low),
                                                        static_cast<std::uint32_t>(mesh.vertex_count()));
      if (is_new) {
        const float share = std::clamp(value[low] / (value[low] - value[high]), 0.05F, 0.95F);
        mesh.positions.push_back(glm::mix(place(corner(cube, low)), place(corner(cube, high)), share));
      }
      return found->second;
    };
    // Tetrahedra are right-handed, and even permutations of their corners preserve this.
    for (const auto& [a, b, c, d] : {std::array{0, 1, 3, 7}, std::array{0, 3, 2, 7}, std::array{0, 2, 6, 7},
                                     std::array{0, 6, 4, 7}, std::array{0, 4, 5, 7}, std::array{0, 5, 1, 7}}) {
      const auto is_inside = [&](int k) { return value[k] < 0; };
      for (const auto& [p, q, r, s] :
           {std::array{a, b, c, d}, std::array{b, a, d, c}, std::array{c, d, a, b}, std::array{d, c, b, a}}) {
        if (is_inside(q) != is_inside(r) || is_inside(r) != is_inside(s) || is_inside(p) == is_inside(q)) continue;
        if (is_inside(p)) mesh.triangles.push_back({vertex(p, q), vertex(p, r), vertex(p, s)});
        if (!is_inside(p)) mesh.triangles.push_back({vertex(p, q), vertex(p, s), vertex(p, r)});
      }
      for (const auto& [p, q, r, s] : {std::array{a, b, c, d}, std::array{a, c, d, b}, std::array{a, d, b, c},
                                       std::array{c, d, a, b}, std::array{d, b, a, c}, std::array{b, c, a, d}}) {
        if (!is_inside(p) || !is_inside(q) || is_inside(r) || is_inside(s)) continue;
        mesh.triangles.push_back({vertex(p, r), vertex(p, s), vertex(q, s)});
        mesh.triangles.push_back({vertex(p, r), vertex(q, s), vertex(q, r)});
      }
    }
  };
  for (int z = 0; z + 1 < count.z; z += kBlock) {
    for (int y = 0; y + 1 < count.y; y += kBlock) {
      for (int x = 0; x + 1 < count.x; x += kBlock) {
        const glm::ivec3 first(x, y, z);
        if (std::abs(distance(place(first) + 0.5F * kBlock * cell)) > 0.9F * kBlock * cell) continue;
        for (std::size_t k = 0; k < values.size(); ++k) {
          const auto n = static_cast<int>(k);
          values[k] = distance(place(first + glm::ivec3(n % (kBlock + 1), n / (kBlock + 1) % (kBlock + 1),
                                                        n / ((kBlock + 1) * (kBlock + 1)))));
        }
        const glm::ivec3 end = glm::min(first + kBlock, count - 1);
        for (int k = 0; k < kBlock * kBlock * kBlock; ++k) {
          const glm::ivec3 cube = first + glm::ivec3(k % kBlock, k / kBlock % kBlock, k / (kBlock * kBlock));
          if (glm::all(glm::lessThan(cube, end))) march(first, cube);
        }
      }
    }
  }
  return mesh;
}

/// A capsule from `a` to `b`, or a sphere if both are equal.
struct Capsule {
  Vec3 a{0};
  Vec3 b{0};
  float radius = 0;

  float distance(Vec3 point) const {
    const Vec3 along = b - a;
    const float t = std::clamp(glm::dot(point - a, along) / std::max(glm::dot(along, along), 1e-20F), 0.0F, 1.0F);
    return glm::distance(point, a + t * along) - radius;
  }
};

/// Returns the closed union of capsules, blended by a polynomial minimum of width `blend`. It has separate parts where
/// capsules do not touch.
inline Mesh capsule_mesh(const std::vector<Capsule>& capsules, float blend, int cells) {
  Box box;
  for (const Capsule& capsule : capsules) {
    for (const Vec3 end : {capsule.a, capsule.b}) {
      box.add(end - capsule.radius - blend);
      box.add(end + capsule.radius + blend);
    }
  }
  const Vec3 margin = 2.0F / static_cast<float>(cells) * box.size() + 1e-4F;
  box.low -= margin;
  box.high += margin;
  return field_mesh(
      [&](Vec3 point) {
        float nearest = 1e9F;
        for (const Capsule& capsule : capsules) {
          const float distance = capsule.distance(point);
          const float near = blend > 0 ? std::max(blend - std::abs(nearest - distance), 0.0F) / blend : 0.0F;
          nearest = std::min(nearest, distance) - 0.25F * blend * near * near;
        }
        return nearest;
      },
      box, cells);
}

/// A trunk from the origin, about 2 m high, that forks into two `levels` times; thin at its ends.
inline std::vector<Capsule> forked_trunk(int levels) {
  const RandomKey key(1);
  std::vector<Capsule> capsules{{Vec3(0), Vec3(0, 0.7F, 0), 0.08F}};
  std::size_t begin = 0;
  for (int level = 0; level < levels; ++level) {
    const std::size_t end = capsules.size();
    for (; begin < end; ++begin) {
      const Capsule parent = capsules[begin];
      const Vec3 along = parent.b - parent.a;
      const Vec3 aside = 0.75F * glm::length(along) * key.direction(begin);
      for (const float side : {-1.0F, 1.0F}) {
        capsules.push_back({parent.b, parent.b + 0.75F * along + side * aside, 0.62F * parent.radius});
      }
    }
  }
  return capsules;
}

/// A crown of `count` spheres around the point 1 m above the origin.
inline std::vector<Capsule> sphere_crown(std::uint64_t count) {
  const RandomKey key(2);
  std::vector<Capsule> spheres;
  for (std::uint64_t k = 0; k < count; ++k) {
    const Vec3 at = Vec3(0, 1, 0) + 0.5F * key.child("place").direction(k);
    spheres.push_back({at, at, static_cast<float>(key.child("radius").uniform(k, 0.12, 0.3))});
  }
  return spheres;
}

}  // namespace meristem
