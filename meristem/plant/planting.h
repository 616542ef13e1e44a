// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "meristem/base/frame.h"

namespace meristem {

class Deformation;
struct PlantVariant;

inline constexpr std::uint32_t kNoRow = 0xffffffffU;  ///< in place of the number of a table's row

/// The places of one variant.
struct Planting {
  struct Place {
    Frame frame;                 ///< from the variant's world to the world; may scale
    std::uint32_t instance = 0;  ///< number among the instances of the component that places the plant
    float birth = 0;             ///< growth step at which it appeared
    std::uint32_t row = kNoRow;  ///< of the table that has placed it, from 0
    std::uint64_t name = 0;      ///< of what stands there, at all times of its document; 0 where nobody has named it
  };
  std::string component;  ///< id of the component that places it
  std::shared_ptr<const PlantVariant> variant;
  std::vector<Place> places;
  /// Deformation of what stands on the places, which then differs from place to place; null: none.
  std::shared_ptr<const Deformation> deformation{};
};

}  // namespace meristem
