// SPDX-License-Identifier: Apache-2.0
// Skeletons for tests of body meshes.
#pragma once

#include <numeric>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// Returns a single axis through these positions.
inline Skeleton chain(const std::vector<Vec3>& places, float radius) {
  Skeleton skeleton;
  for (NodeIndex k = 0; k < places.size(); ++k) skeleton.add_node(k == 0 ? kNoNode : k - 1, places[k], 0);
  skeleton.radius.assign(places.size(), radius);
  return skeleton;
}

/// A trunk 1 m high that forks into two branches and continues a little above the fork.
inline Skeleton forked() {
  Skeleton skeleton = chain({{0, 0, 0}, {0, 1, 0}, {0, 1.2F, 0}}, 0.1F);
  skeleton.add_node(1, {0.25F, 1.25F, 0}, 0);
  skeleton.add_node(3, {0.6F, 1.5F, 0}, 0);
  skeleton.add_node(1, {-0.5F, 1.5F, 0.2F}, 0);
  skeleton.radius = {0.1F, 0.1F, 0.05F, 0.04F, 0.02F, 0.06F};
  skeleton.axis = {0, 0, 0, 1, 1, 2};
  skeleton.order = {0, 0, 0, 1, 1, 1};
  return skeleton;
}

/// Returns the number of connected components of a mesh, by shared vertices.
inline std::size_t component_count(const Mesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertex_count());
  std::iota(parent.begin(), parent.end(), 0);
  const auto first = [&](std::uint32_t vertex) {
    while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
    return vertex;
  };
  std::size_t count = mesh.vertex_count();
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 2; ++k) {
      const std::uint32_t a = first(triangle[k]);
      const std::uint32_t b = first(triangle[k + 1]);
      count -= a == b ? 0 : 1;
      parent[a] = b;
    }
  }
  return count;
}

}  // namespace meristem
