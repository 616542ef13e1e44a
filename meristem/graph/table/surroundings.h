// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "meristem/scene/crown/crown.h"
#include "meristem/scene/directions.h"

namespace meristem {

class Deformation;

/// What the components above an instance say of the space that it stands in. Where they say nothing of something, its
/// pointer is null.
struct Surroundings {
  std::shared_ptr<const Directions> directions{};    ///< of light and gravity; null: the scene's
  std::shared_ptr<const Deformation> deformation{};  ///< of what is seen of the instance; null: none
  CrownPointer trim{};                               ///< body that stems are kept in, in world space; null: none
  /// Hash of all the surroundings: equal for equal ones, and 0 where it is not known what they were made of.
  std::uint64_t hash = 0;
};

}  // namespace meristem
