// SPDX-License-Identifier: Apache-2.0
// Noise over all pixels of a tile at once. The left and right edges join smoothly, and so do the lower and upper edges.
#pragma once

#include <vector>

#include "meristem/base/random.h"

namespace meristem {

/// A sum of octaves, each half as coarse as the octave before.
struct NoiseParameters {
  int across = 4;    ///< the first octave varies over 1 / `across` of the width; at least 1
  int along = 4;     ///< the first octave varies over 1 / `along` of the height; at least 1
  int octaves = 3;   ///< octaves that are too fine for the pixels are left out
  float gain = 0.5;  ///< height of an octave relative to the octave before; larger values are rougher
};

/// Returns values of about [-1, 1] with mean 0 at the middle of each pixel of a square with `pixels` per side, rows
/// from top to bottom.
std::vector<float> noise_field(RandomKey key, const NoiseParameters& form, int pixels);

}  // namespace meristem
