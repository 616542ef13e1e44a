// SPDX-License-Identifier: Apache-2.0
// Keys of the parts of a mesh scene, so that a viewer of successive scenes receives only the changes.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Hashes of the content of all parts: equal keys mean equal content.
struct SceneKeys {
  /// The keys at one index of MeshScene::meshes.
  struct Batch {
    std::string component;        ///< id of the component
    std::uint32_t number = 0;     ///< number among the component's batches
    std::uint64_t mesh = 0;       ///< key of the mesh that the batch's instances share
    std::uint64_t material = 0;   ///< key of the batch's material
    std::uint64_t instances = 0;  ///< key of the instances' frames and tints

    bool operator==(const Batch&) const = default;
  };
  std::vector<Batch> batches;            ///< in the order of MeshScene::meshes
  std::vector<std::uint64_t> materials;  ///< in the order of MeshScene::materials
};

/// Makes keys. Content that scenes share, because a later growth has kept it, is hashed once.
class SceneKeyMaker {
 public:
  /// Returns the keys of a scene.
  SceneKeys keys_of(const MeshScene& scene);

 private:
  struct Known {
    std::weak_ptr<const void> content;
    std::uint64_t key = 0;
  };
  template <class Content>
  std::uint64_t key_of(const std::shared_ptr<const Content>& content);

  std::unordered_map<const void*, Known> known_;
};

/// The difference between two scenes.
struct SceneDifference {
  /// Keys in ascending order.
  struct Keys {
    std::vector<std::uint64_t> added;    ///< keys that only the later scene has
    std::vector<std::uint64_t> removed;  ///< keys that only the earlier scene has
  };
  Keys meshes;     ///< keys of meshes
  Keys materials;  ///< keys of materials
  /// Indices of changed batches. Two batches correspond if they have equal component and number. A batch has changed if
  /// one of its keys differs.
  struct Batches {
    std::vector<std::size_t> added;    ///< by index in the later scene
    std::vector<std::size_t> changed;  ///< by index in the later scene
    std::vector<std::size_t> removed;  ///< by index in the earlier scene
  };
  Batches batches;  ///< batches

  /// Returns true if both scenes are equal.
  bool is_empty() const {
    return meshes.added.empty() && meshes.removed.empty() && materials.added.empty() && materials.removed.empty() &&
           batches.added.empty() && batches.changed.empty() && batches.removed.empty();
  }
};

/// Compares the keys of two scenes. The cost is linear, plus sorting the keys.
SceneDifference difference(const SceneKeys& before, const SceneKeys& after);

}  // namespace meristem
