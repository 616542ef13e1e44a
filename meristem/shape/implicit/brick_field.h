// SPDX-License-Identifier: Apache-2.0
// Samples a body where its surface may be: regions are halved, and left as soon as the body's function is surely of one
// sign there, with fewer of its solids from step to step.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/shape/implicit/brick_grid.h"
#include "meristem/shape/implicit/field_part.h"
#include "meristem/shape/implicit/implicit_body.h"

namespace meristem {

/// A body's values in bricks, with the part of its function that each brick was sampled by.
struct BodyBricks {
  struct Parts {
    std::vector<std::size_t> first;  ///< of each brick's steps, and the end
    std::vector<FieldStep> steps;
    std::span<const FieldStep> of(std::size_t brick) const {
      return std::span(steps).subspan(first[brick], first[brick + 1] - first[brick]);
    }
  };
  BrickGrid grid;
  std::vector<Parts> parts;  ///< as chunks
  double error = 0;          ///< metres that values near the surface may be off

  /// The middle of a brick, from which its positions count while sampled.
  DVec3 centre(glm::ivec3 brick) const {
    return grid.origin + grid.cell * (static_cast<double>(kBrickSide) * DVec3(brick) + 0.5 * (kBrickSide - 1));
  }
};

/// The values of `body` on a grid of cells with side `cell` metres about it.
/// Begins a stage of `progress`. Throws InputError at `path` where bricks would take more than `limits.mesh_bytes` or
/// cells are too many to count, and Cancelled. Deterministic on any number of threads.
BodyBricks sample_body(const ImplicitBody& body, double cell, const Limits& limits, const std::string& path,
                       Progress& progress);

}  // namespace meristem
