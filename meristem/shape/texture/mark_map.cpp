// SPDX-License-Identifier: Apache-2.0
// Draws marks into a tile that repeats, and reads it with bilinear interpolation.
#include "meristem/shape/texture/mark_map.h"

#include <algorithm>
#include <cmath>

namespace meristem {

namespace {

constexpr float kMinReach = 0.9F;  // minimum half size of a mark, in pixels

int wrapped(int index, int period) { return ((index % period) + period) % period; }

}  // namespace

void MarkMap::add(Vec2 centre, Vec2 reach, FunctionRef<float(Vec2 position)> mark) {
  const auto size = static_cast<float>(pixels_);
  const Vec2 middle(centre.x * size - 0.5F, (1 - centre.y) * size - 0.5F);
  const Vec2 half = glm::min(glm::max(reach * size, Vec2(kMinReach)), Vec2(0.5F * size));
  for (int y = static_cast<int>(std::ceil(middle.y - half.y)); static_cast<float>(y) <= middle.y + half.y; ++y) {
    for (int x = static_cast<int>(std::ceil(middle.x - half.x)); static_cast<float>(x) <= middle.x + half.x; ++x) {
      const Vec2 position((static_cast<float>(x) - middle.x) / half.x, (middle.y - static_cast<float>(y)) / half.y);
      float& value = values_[static_cast<std::size_t>(wrapped(y, pixels_)) * static_cast<std::size_t>(pixels_) +
                             static_cast<std::size_t>(wrapped(x, pixels_))];
      value = std::max(value, mark(position));
    }
  }
}

float MarkMap::at(float u, float v) const {
  const auto size = static_cast<float>(pixels_);
  // One tile further on, so that truncation finds the whole part.
  const float x = (u + 1) * size - 0.5F;
  const float y = (2 - v) * size - 0.5F;
  const int left = static_cast<int>(x);
  const int upper = static_cast<int>(y);
  const auto value = [&](int column, int row) {
    return values_[static_cast<std::size_t>(row % pixels_) * static_cast<std::size_t>(pixels_) +
                   static_cast<std::size_t>(column % pixels_)];
  };
  const float across = x - static_cast<float>(left);
  const float down = y - static_cast<float>(upper);
  const float above = value(left, upper) + across * (value(left + 1, upper) - value(left, upper));
  const float below = value(left, upper + 1) + across * (value(left + 1, upper + 1) - value(left, upper + 1));
  return above + down * (below - above);
}

MarkMap scattered_marks(int pixels, int count, RandomKey key,
                        FunctionRef<void(MarkMap& map, Vec2 centre, RandomKey own, int number)> draw) {
  MarkMap map(pixels);
  for (int k = 0; k < count; ++k) {
    const RandomKey own = key.child(static_cast<std::uint64_t>(k));
    draw(map, Vec2(own.uniform(0), own.uniform(1)), own, k);
  }
  return map;
}

}  // namespace meristem
