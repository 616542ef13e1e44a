// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/node_light.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "meristem/base/parallel.h"
#include "meristem/scene/light/shadow_grid.h"

namespace meristem {

namespace {

constexpr double kVoxelsAcross = 24;  // voxels along the longest side of the skeleton's bounds
constexpr std::size_t kLitNodesAtOnce = 512;

/// Returns the light of the scene that reaches a position past its obstacles.
double light_reaching(const Scene& scene, Vec3 position) {
  if (scene.light.is_none()) return 1;
  double arrives = 0;
  scene.light.for_each_ray(position, [&](const LightRay& ray) {
    if (!scene.obstacles.block(position, ray.toward, ray.distance)) arrives += ray.strength;
  });
  return arrives;
}

/// Returns stems as pieces that are no longer than a voxel. A piece as long as a voxel casts one shade.
std::vector<ShadeSource> shaders_of(const Skeleton& skeleton, double voxel) {
  std::vector<ShadeSource> shaders;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.is_root(node)) continue;
    const Vec3 from = skeleton.position[skeleton.parent[node]];
    const Vec3 to = skeleton.position[node];
    const double length = glm::distance(from, to);
    const auto pieces = static_cast<int>(std::max(1.0, std::ceil(length / voxel)));
    for (int k = 1; k <= pieces; ++k) {
      const Vec3 end = glm::mix(from, to, static_cast<float>(k) / static_cast<float>(pieces));
      shaders.push_back({end, length / voxel / pieces});
    }
  }
  return shaders;
}

}  // namespace

std::vector<float> light_at_nodes(const Skeleton& skeleton, const Scene& scene) {
  Box box;
  for (const Vec3 position : skeleton.position) box.add(position);
  const Vec3 size = box.size();
  const double longest = std::max({size.x, size.y, size.z});
  std::vector<float> light(skeleton.node_count(), 1);
  std::optional<ShadowGrid> grid;
  if (longest > 0) {
    grid.emplace(ShadowParameters{.voxel = longest / kVoxelsAcross, .toward_light = scene.light.mean_direction()});
    grid->cast(shaders_of(skeleton, longest / kVoxelsAcross), Progress());
  }
  parallel_for(light.size(), kLitNodesAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node) {
      const Vec3 position = skeleton.position[node];
      const double full = light_reaching(scene, position);
      double shade = 0;
      if (grid) {
        // A node is not shaded by the piece that ends in it.
        const bool is_root = skeleton.is_root(static_cast<NodeIndex>(node));
        const double length = is_root ? 0 : glm::distance(position, skeleton.position[skeleton.parent[node]]);
        const double voxel = grid->form().voxel;
        shade = grid->shade(position) - grid->form().amount * std::min(1.0, length / voxel);
      }
      light[node] = static_cast<float>(std::clamp(full - shade, 0.0, full));
    }
  });
  return light;
}

}  // namespace meristem
