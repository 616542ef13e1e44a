// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "meristem/scene/crown/crown.h"
#include "meristem/scene/directions.h"

namespace meristem {

class Deformation;

/// The surroundings that the components above an instance set. Each pointer is null if no component has set it.
struct Surroundings {
  std::shared_ptr<const Directions> directions{};    ///< of light and gravity; null: the scene's
  std::shared_ptr<const Deformation> deformation{};  ///< deformation of the instance's visible geometry; null: not
                                                     ///< deformed
  CrownPointer trim{};                               ///< body that trims stems, in world space; null: stems are not
                                                     ///< trimmed
  /// Hash of all the surroundings. Equal surroundings have equal hashes. 0 if their origin is unknown.
  std::uint64_t hash = 0;
};

}  // namespace meristem
