// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/walk/component_meshes.h"

#include <utility>

namespace meristem {

ComponentMeshes::ComponentMeshes(const WalkContext& context)
    : context_(context), meshes_(context.graph.components.size()), bytes_(context.graph.components.size()) {}

SharedMeshes& ComponentMeshes::of(ComponentIndex component) {
  std::shared_ptr<SharedMeshes>& meshes = meshes_[component];
  if (meshes != nullptr) return *meshes;
  const CacheKey key = context_.keys.of_meshes(component);
  std::shared_ptr<SharedMeshes> earlier = context_.results.find<SharedMeshes>(key);
  if (earlier != nullptr) earlier->forget_earlier();
  meshes = std::make_shared<SharedMeshes>(std::move(earlier));
  context_.results.store(key, meshes);
  return *meshes;
}

void ComponentMeshes::keep(ComponentIndex component, const BatchResult& result) {
  SharedMeshes& meshes = of(component);
  for (const Emitted& block : result.blocks) {
    for (const Emitted::EmittedPrototype& made : block.prototypes) meshes.keep(made.key, made.mesh);
  }
  measure(component);
}

}  // namespace meristem
