// SPDX-License-Identifier: Apache-2.0
// Small separate marks on a tile, such as lenticels: drawn one by one, which is quicker than asking at each pixel for
// the marks around it. What crosses an edge of the tile comes in at the other.
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

  /// Raises what lies within `reach` (half width and height, in widths of the tile) of `centre` to the value of `mark`
  /// at positions from -1 to 1 in both directions, where that is higher. Marks are at least about a pixel thick.
  void add(Vec2 centre, Vec2 reach, FunctionRef<float(Vec2 position)> mark);
  float at(std::size_t index) const { return values_[index]; }
  /// Between the pixels around; u and v lie in [-1, 2).
  float at(float u, float v) const;

 private:
  int pixels_;
  std::vector<float> values_;
};

/// `count` marks at random positions, each drawn by `draw` from a key of its own.
MarkMap scattered_marks(int pixels, int count, RandomKey key,
                        FunctionRef<void(MarkMap& map, Vec2 centre, RandomKey own, int number)> draw);

}  // namespace meristem
