// SPDX-License-Identifier: Apache-2.0
// A few colours that replace many.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/vec.h"

namespace meristem {

struct Palette {
  std::vector<Vec3> colours;
  std::vector<std::uint8_t> of;  ///< for each given colour, an index into `colours`
};

/// Returns at most `max` colours (1 to 256) that approximate `colours`. The result is exact if there are no more than
/// `max` different colours.
Palette make_palette(std::span<const Vec3> colours, std::size_t max);

}  // namespace meristem
