// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/graph/batch.h"
#include "meristem/graph/mesh_bytes.h"
#include "meristem/graph/shared_meshes.h"
#include "meristem/graph/walk/walk_context.h"

namespace meristem {

/// The meshes that all batches of a component share, for all components, and their memory. Meshes of the previous run
/// of the cache are reused.
class ComponentMeshes {
 public:
  /// `context` must outlive this object.
  explicit ComponentMeshes(const WalkContext& context);

  /// Returns the meshes of a component.
  SharedMeshes& of(ComponentIndex component);
  /// Keeps the meshes of a batch's result that was found in the cache.
  void keep(ComponentIndex component, const BatchResult& result);
  /// Updates the memory after a batch of a component has made meshes.
  void measure(ComponentIndex component) { bytes_.set(component, of(component).bytes()); }
  const MeshBytes& bytes() const { return bytes_; }  ///< memory as last measured

 private:
  const WalkContext& context_;
  std::vector<std::shared_ptr<SharedMeshes>> meshes_;  // by component; null: not needed so far
  MeshBytes bytes_;
};

}  // namespace meristem
