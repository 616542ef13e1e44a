// SPDX-License-Identifier: Apache-2.0
// Small separate marks on a tile, such as lenticels. They are drawn one by one, which is faster than a search for
// nearby marks at each pixel. Marks that cross an edge of the tile continue at the opposite edge.
#pragma once

#include <cstddef>
#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/base/random.h"
#include "meristem/base/vec.h"

namespace meristem {

class MarkMap {
 public:
  explicit MarkMap(int pixels) : pixels_(pixels), values_(static_cast<std::size_t>(pixels) * pixels) {}

  /// Draws a mark: raises the pixels within `reach` (half width and height, in widths of the tile) of `centre` to the
  /// value of `mark` where this is higher. `mark` receives positions from -1 to 1 in both directions. Marks are at
  /// least about a pixel thick.
  void add(Vec2 centre, Vec2 reach, FunctionRef<float(Vec2 position)> mark);
  float at(std::size_t index) const { return values_[index]; }
  /// Returns the value, interpolated between the surrounding pixels. u and v must be in [-1, 2).
  float at(float u, float v) const;

 private:
  int pixels_;
  std::vector<float> values_;
};

/// Returns `count` marks at random positions. `draw` draws each mark with its own key.
MarkMap scattered_marks(int pixels, int count, RandomKey key,
                        FunctionRef<void(MarkMap& map, Vec2 centre, RandomKey own, int number)> draw);

}  // namespace meristem
