// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "meristem/base/limits.h"
#include "meristem/grow/colonize/colonize.h"
#include "meristem/scene/light/shadow_grid.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// What all colonizing trees of one component have in common.
struct ColonizingSpecies {
  ColonizeParameters parameters;
  const Scene& scene;
  Limits limits;
  std::string component;
  const ShadowGrid* felt_shade = nullptr;

  /// The path of a parameter in the document.
  std::string path(const char* parameter) const;
  /// Throws an InputError at a parameter.
  [[noreturn]] void refuse(const char* parameter, std::string message, std::string expected) const;
  /// Throws one where there are more nodes than may be.
  void require_nodes(std::uint64_t nodes, const char* parameter) const;
};

/// A tree that has grown about its root, post-processed, with radii and axes, in world space.
Skeleton finished_tree(const ColonizingSpecies& species, Skeleton skeleton, Vec3 root, Progress& progress);

}  // namespace meristem
