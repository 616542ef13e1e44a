// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "meristem/base/progress.h"
#include "meristem/document/document.h"
#include "meristem/shape/moving/moving_scene.h"

namespace meristem {

inline constexpr std::size_t kUsualKeys = 16;  ///< default number of times in an animated file
inline constexpr std::size_t kMaxKeys = 1000;  ///< largest number of times

/// Options for growing a document as a moving scene.
struct MovingOptions {
  std::size_t keys = kUsualKeys;  ///< number of times at which it is grown, 2 to kMaxKeys; more give a closer and
                                  ///< larger scene
  MovingLimits limits;            ///< limits of the moving scene
};

/// Returns the document's animation as a moving scene with textures. The document is grown at `keys` evenly spaced
/// times from 0 to the animation's length. Parts that do not depend on time are grown once. Throws InputError if the
/// document has no animation, if the moving parts take too many bytes, and as grow_document does. Throws Cancelled.
MovingScene grow_moving(const Document& document, Progress& progress, const MovingOptions& options = {});

}  // namespace meristem
