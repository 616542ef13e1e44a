// SPDX-License-Identifier: Apache-2.0
// Samples a body near its surface. Regions are halved again and again, and skipped as soon as the body's function
// surely has one sign in them. Each step considers fewer of its solids.
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

/// A body's values in bricks, with the clauses of its function that each brick was sampled by.
struct BodyBricks {
  struct Parts {
    std::vector<std::size_t> first;  ///< for each brick its first step, and last the number of steps
    std::vector<FieldStep> steps;
    std::span<const FieldStep> of(std::size_t brick) const {
      return std::span(steps).subspan(first[brick], first[brick + 1] - first[brick]);
    }
  };
  BrickGrid grid;
  std::vector<Parts> parts;  ///< grouped by chunks
  double error = 0;          ///< maximum error of values near the surface, metres

  /// Returns the middle of a brick, which is the origin of its positions during sampling.
  DVec3 centre(glm::ivec3 brick) const {
    return grid.origin + grid.cell * (static_cast<double>(kBrickSide) * DVec3(brick) + 0.5 * (kBrickSide - 1));
  }
};

/// Returns the values of `body` on a grid around it, with cells of `cell` metres. Begins a stage of `progress`. Throws
/// InputError at `path` if bricks would need more than `limits.mesh_bytes` or if there are too many cells to count, and
/// Cancelled. Deterministic on any number of threads.
BodyBricks sample_body(const ImplicitBody& body, double cell, const SizeLimits& limits, const std::string& path,
                       Progress& progress);

}  // namespace meristem
