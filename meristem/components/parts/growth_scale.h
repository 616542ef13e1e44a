// SPDX-License-Identifier: Apache-2.0
// Scale of growth models. Plants grow at the scale of their frame: all lengths are multiplied by it. Their size during
// growth among obstacles and neighbours is therefore their final size.
#pragma once

#include <memory>
#include <optional>

#include "meristem/base/frame.h"
#include "meristem/grow/stand.h"

namespace meristem {

/// Returns the scale of lengths in a frame: the length of its heading. Returns nothing if it is zero or not finite;
/// then nothing can grow there.
std::optional<double> growth_scale(const Frame& frame);

/// Returns a member of the stand that stays empty.
std::unique_ptr<Grower> make_nothing();

}  // namespace meristem
