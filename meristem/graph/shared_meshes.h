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

/// Meshes that all instances of one component share, by their keys. May be called from many threads.
class SharedMeshes {
 public:
  /// `earlier` are those of an earlier expansion, which are taken over as they are asked for.
  explicit SharedMeshes(std::shared_ptr<const SharedMeshes> earlier = nullptr) : earlier_(std::move(earlier)) {}
  /// Null where there is none yet.
  std::shared_ptr<const Mesh> find(std::uint64_t key);
  /// Keeps `mesh`, or gives the one that another thread was quicker with.
  std::shared_ptr<const Mesh> keep(std::uint64_t key, std::shared_ptr<const Mesh> mesh);
  /// Lets go of the earlier ones that nobody has asked for.
  void forget_earlier() { earlier_ = nullptr; }
  std::uint64_t bytes() const { return bytes_; }

 private:
  mutable std::mutex mutex_;
  std::unordered_map<std::uint64_t, std::shared_ptr<const Mesh>> meshes_;
  std::shared_ptr<const SharedMeshes> earlier_;
  std::atomic<std::uint64_t> bytes_{0};
};

}  // namespace meristem
