// SPDX-License-Identifier: Apache-2.0
// A few colours in the place of many.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/vec.h"

namespace meristem {

struct Palette {
  std::vector<Vec3> colours;
  std::vector<std::uint8_t> of;  ///< index into `colours` of each of the colours given
};

/// At most `most` colours (1 to 256) that stand for `colours`; exactly those where they are no more.
Palette make_palette(std::span<const Vec3> colours, std::size_t most);

}  // namespace meristem
