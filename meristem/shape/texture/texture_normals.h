// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/image.h"

namespace meristem {

/// The relation between heights and the surface.
struct ReliefParameters {
  double relief = 1;   ///< factor on the heights
  double aspect = 1;   ///< width divided by height of the picture
  bool wraps = false;  ///< true if pixels at opposite edges are neighbours
};

/// Returns the normals of a square field of heights, which are in heights of the picture, rows from top to bottom. x is
/// along u (right), y along v (up), z outward, each from [-1, 1] as a byte.
Image normals_of_heights(const std::vector<float>& heights, int pixels, const ReliefParameters& form);

}  // namespace meristem
