// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "meristem/base/progress.h"
#include "meristem/document/document.h"
#include "meristem/shape/moving/moving_scene.h"

namespace meristem {

inline constexpr std::size_t kUsualKeys = 16;   ///< of an animated file
inline constexpr std::size_t kMostKeys = 1000;  ///< largest number of times

/// How a document is grown as a scene that moves.
struct MovingOptions {
  std::size_t keys = kUsualKeys;  ///< times at which it is grown, 2 to kMostKeys; more: closer to it, and larger
  MovingLimits limits;            ///< limits of the moving scene
};

/// The document's animation as a scene that moves, with textures: the document at `keys` times, evenly from 0 to the
/// animation's length. What does not depend on the time is grown once. Throws InputError where the document has no
/// animation, where what moves takes too many bytes, and as grow_document does; Cancelled.
MovingScene grow_moving(const Document& document, Progress& progress, const MovingOptions& options = {});

}  // namespace meristem
