// SPDX-License-Identifier: Apache-2.0
// Builds moving scenes. While plants are added, each part's keys are recorded by its name. After the last plant, the
// parts become moving meshes.
#include "meristem/shape/moving/moving_scene.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "meristem/shape/moving/moving_meshes.h"
#include "meristem/shape/moving/moving_parts.h"

namespace meristem {

struct MovingSceneMaker::State {
  State(const SizeLimits& limits, const MovingLimits& of_motion, std::size_t keys)
      : moving(of_motion), parts(limits, of_motion, keys) {}

  const MovingLimits moving;
  MovingParts parts;
};

MovingSceneMaker::MovingSceneMaker(const SizeLimits& limits, const MovingLimits& moving, std::size_t keys)
    : state_(std::make_unique<State>(limits, moving, keys)) {}

MovingSceneMaker::~MovingSceneMaker() = default;

void MovingSceneMaker::add(std::size_t key, double time, const Plant& plant, Progress& progress) {
  state_->parts.add(key, time, plant, progress);
}

MovingScene MovingSceneMaker::take(Progress& progress) {
  MovingParts& parts = state_->parts;
  MovingMeshes made(state_->moving, parts.key_count);
  progress.begin("following motion", 2);
  gather_tubes(parts, made, progress);
  progress.advance();
  gather_parts(parts, state_->moving.rigid_instances, made, progress);
  progress.advance();

  std::unordered_map<std::string, std::size_t> rank;
  for (const std::string& component : parts.components) rank.try_emplace(component, rank.size());
  std::erase_if(made.meshes, [](const MovingMesh& mesh) { return mesh.instances.triangle_count() == 0; });
  std::stable_sort(made.meshes.begin(), made.meshes.end(), [&](const MovingMesh& a, const MovingMesh& b) {
    return rank.at(a.instances.component) < rank.at(b.instances.component);
  });
  MovingScene scene;
  scene.times = parts.times;
  scene.scene.materials = parts.materials;
  scene.scene.individuals = parts.individuals;
  for (MovingMesh& mesh : made.meshes) {
    scene.scene.meshes.push_back(std::move(mesh.instances));
    scene.motions.push_back(std::move(mesh.motion));
  }
  return scene;
}

}  // namespace meristem
