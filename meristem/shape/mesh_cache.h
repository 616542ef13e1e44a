// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "meristem/base/kept_results.h"

namespace meristem {

/// Keeps the meshes of one mesh scene for the next one of the same or a changed plant, where only the stems that have
/// changed are clothed anew. It holds no more than the last scene has used. The scene is the same as without it, to the
/// byte; one that throws or is cancelled leaves it in order. One call at a time may use it.
class MeshCache {
 public:
  MeshCache();
  ~MeshCache();
  MeshCache(MeshCache&&) noexcept;
  MeshCache& operator=(MeshCache&&) noexcept;

  /// Stems with tubes, of the last scene, as far as it came.
  const Reuse& stems() const;
  /// Blended bodies and crowns.
  const Reuse& bodies() const;
  /// Heap memory of what is kept.
  std::uint64_t bytes() const;
  /// Lets go of all of it.
  void clear();

  struct Kept;  ///< kept_meshes.h
  Kept& kept() { return *kept_; }

 private:
  std::unique_ptr<Kept> kept_;
};

}  // namespace meristem
