// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>

#include "meristem/base/mesh.h"

namespace meristem {

/// Meshes that all instances of one component share, found by their keys. May be called from many threads.
class SharedMeshes {
 public:
  /// `earlier` are the meshes of an earlier expansion. They are taken over when they are requested.
  explicit SharedMeshes(std::shared_ptr<const SharedMeshes> earlier = nullptr) : earlier_(std::move(earlier)) {}
  /// Returns the mesh with this key, or null if there is none yet.
  std::shared_ptr<const Mesh> find(std::uint64_t key);
  /// Keeps `mesh` and returns it. If another thread has kept a mesh with this key before, returns that mesh.
  std::shared_ptr<const Mesh> keep(std::uint64_t key, std::shared_ptr<const Mesh> mesh);
  /// Releases the earlier meshes that nobody has requested.
  void forget_earlier() { earlier_ = nullptr; }
  std::uint64_t bytes() const { return bytes_; }

 private:
  mutable std::mutex mutex_;
  std::unordered_map<std::uint64_t, std::shared_ptr<const Mesh>> meshes_;
  std::shared_ptr<const SharedMeshes> earlier_;
  std::atomic<std::uint64_t> bytes_{0};
};

}  // namespace meristem
