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

inline constexpr std::uint32_t kNoRow = 0xffffffffU;  ///< marks a missing row number of a table

/// The places of one variant.
struct Planting {
  /// One place at which the variant stands.
  struct Place {
    Frame frame;                 ///< from the variant's world to the world; may scale
    std::uint32_t instance = 0;  ///< number among the instances of the component that places the plant
    float birth = 0;             ///< growth step at which it appeared
    std::uint32_t row = kNoRow;  ///< row of the table that placed it, from 0
    /// unique name of the plant at this place, the same at all times of the document; 0: no name
    std::uint64_t name = 0;
  };
  std::string component;                        ///< id of the component that places it
  std::shared_ptr<const PlantVariant> variant;  ///< the plant that stands at the places
  std::vector<Place> places;                    ///< the places, in the order of instances
  /// Deformation of the plants at the places, which makes each place differ. Null: none.
  std::shared_ptr<const Deformation> deformation{};
};

}  // namespace meristem
