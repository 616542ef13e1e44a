// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace meristem {

/// The two pixels along one direction of a picture around a position, and the weight of the second. Pictures repeat.
struct PixelNeighbours {
  int first;
  int second;
  float share;

  /// `turns` is the position in widths (or heights) of the picture. `count` is its number of pixels in this direction.
  PixelNeighbours(float turns, int count) {
    const float at = (turns - std::floor(turns)) * static_cast<float>(count) - 0.5F;
    const float below = std::floor(at);
    share = at - below;
    first = static_cast<int>(below);
    if (first < 0) first += count;
    first = std::min(first, count - 1);
    second = first + 1 == count ? 0 : first + 1;
  }
};

}  // namespace meristem
