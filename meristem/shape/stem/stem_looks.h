// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/plant/plant.h"

namespace meristem {

/// The axes of a stem grouped by looks. Axes with equal component, material, tint, deformation and individual share a
/// mesh.
struct StemLooks {
  std::vector<const StemPart*> first_part;  ///< for each mesh
  std::vector<std::uint32_t> individual;    ///< for each mesh
  std::vector<std::uint32_t> mesh_of_part;  ///< used if all axes belong to one individual
  std::vector<std::uint32_t> mesh_of_axis;  ///< used if individuals differ, otherwise empty

  explicit StemLooks(const Stem& stem);
};

}  // namespace meristem
