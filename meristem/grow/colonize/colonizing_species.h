// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "meristem/base/limits.h"
#include "meristem/grow/colonize/colonize.h"
#include "meristem/scene/light/shadow_grid.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// The common data of all colonizing trees of one component.
struct ColonizingSpecies {
  ColonizeParameters parameters;
  const Scene& scene;
  SizeLimits limits;
  std::string component;
  const ShadowGrid* felt_shade = nullptr;

  /// Returns the path of a parameter in the document.
  std::string path(const char* parameter) const;
  /// Throws an InputError at a parameter.
  [[noreturn]] void refuse(const char* parameter, std::string message, std::string expected) const;
  /// Throws an InputError if `nodes` exceeds the limit.
  void require_nodes(std::uint64_t nodes, const char* parameter) const;
};

/// Returns a grown tree after post-processing, with radii and axes, in world space. `skeleton` is relative to its root.
Skeleton finished_tree(const ColonizingSpecies& species, Skeleton skeleton, Vec3 root, Progress& progress);

}  // namespace meristem
