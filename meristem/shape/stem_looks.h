// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/plant/plant.h"

namespace meristem {

/// The axes of a stem by their looks: those of one component, material, tint, deformation and individual
/// share a mesh.
struct StemLooks {
  std::vector<const StemPart*> first_part;  ///< of each mesh
  std::vector<std::uint32_t> individual;    ///< of each mesh
  std::vector<std::uint32_t> mesh_of_part;  ///< where all axes are of one individual
  std::vector<std::uint32_t> mesh_of_axis;  ///< where individuals differ; else empty

  explicit StemLooks(const Stem& stem);
};

}  // namespace meristem
