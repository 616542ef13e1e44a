// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/plant/plant.h"

namespace meristem {

/// The parts of a stem by their looks: those of one component, material and tint share meshes.
struct StemLooks {
  std::vector<const StemPart*> first_part;  ///< of each look
  std::vector<std::uint32_t> look_of_part;  ///< number of the look

  explicit StemLooks(const Stem& stem);
};

}  // namespace meristem
