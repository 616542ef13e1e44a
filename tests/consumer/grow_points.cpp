// SPDX-License-Identifier: Apache-2.0
// Grows a tree beside a wall by space colonization, without a document. Writes its nodes as skeleton.csv and its
// surface as skeleton.glb.
#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "meristem/grow/colonize/colonize.h"
#include "meristem/grow/stand.h"
#include "meristem/output/gltf/gltf.h"
#include "meristem/output/skeleton/skeleton_csv.h"
#include "meristem/plant/plant.h"
#include "meristem/scene/crown/crown_points.h"
#include "meristem/scene/crown/solid_crowns.h"
#include "meristem/scene/scene.h"
#include "meristem/shape/assembly/make_mesh_scene.h"

int main() {
  meristem::Progress progress;
  const meristem::RandomKey key(7);

  // A wall to the east of the root, 2 m high.
  std::vector<meristem::Obstacle> walls(1);
  walls[0].mesh = meristem::box_mesh({0.4, 0, -3}, {0.6, 2, 3});
  meristem::Scene scene;
  scene.obstacles = meristem::Obstacles(std::move(walls));

  // Attraction points. The points of a scan are possible, too.
  const meristem::EllipsoidCrown crown({0, 1.8F, 0}, {1, 1.2F, 1});
  meristem::Seedling seedling;
  seedling.points = meristem::sample_crown(crown, 2000, key.child("points"), progress);

  // Grow. Further plants in the same stand would compete with this one.
  meristem::ColonizeParameters parameters;
  parameters.step = 0.04;
  parameters.influence = 0.5;
  parameters.kill = 0.1;
  parameters.finish.subdivide = 1;
  meristem::Stand stand;
  stand.add(meristem::make_colonizer(stand, {seedling}, parameters, key, scene, {}, "tree", progress));
  stand.grow(progress);

  meristem::Plant plant;
  meristem::Stem& stem = plant.stems.emplace_back();
  stem.parts[0].component = "tree";
  stem.skeleton = std::move(stand.take_skeletons(progress).front());

  // Parents stand before their children, so one loop walks from the root to all tips. Its result becomes a column of
  // the table.
  meristem::Skeleton& skeleton = stem.skeleton;
  std::vector<float> way(skeleton.node_count());
  for (meristem::NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.is_root(node)) continue;
    const meristem::NodeIndex parent = skeleton.parent[node];
    way[node] = way[parent] + glm::distance(skeleton.position[parent], skeleton.position[node]);
  }
  std::printf("%zu nodes, the farthest tip %.2f m from the root\n", skeleton.node_count(),
              *std::max_element(way.begin(), way.end()));
  skeleton.extra["way"] = std::move(way);
  meristem::write_skeleton_csv(plant, meristem::SizeLimits(), "skeleton.csv", progress);

  plant.materials.emplace_back().name = "bark";
  meristem::write_glb(meristem::make_mesh_scene(plant, meristem::SizeLimits(), progress), "skeleton.glb", {}, progress);
}
