// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/shared_meshes.h"

namespace meristem {

std::shared_ptr<const Mesh> SharedMeshes::find(std::uint64_t key) {
  {
    const std::scoped_lock lock(mutex_);
    const auto found = meshes_.find(key);
    if (found != meshes_.end()) return found->second;
    if (earlier_ == nullptr) return nullptr;
  }
  // The earlier meshes are not changed any more, so no lock is needed.
  const auto found = earlier_->meshes_.find(key);
  return found == earlier_->meshes_.end() ? nullptr : keep(key, found->second);
}

std::shared_ptr<const Mesh> SharedMeshes::keep(std::uint64_t key, std::shared_ptr<const Mesh> mesh) {
  const std::scoped_lock lock(mutex_);
  const auto [kept, is_new] = meshes_.try_emplace(key, std::move(mesh));
  if (is_new) bytes_ += kept->second->bytes();
  return kept->second;
}

}  // namespace meristem
