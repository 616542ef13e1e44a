// SPDX-License-Identifier: Apache-2.0
// Plants that grow by a model grow to the scale of the frame that they stand in, as stems along curves do: all their
// lengths are larger, so that they grow among obstacles and neighbours what they come to be.
#pragma once

#include <memory>
#include <optional>

#include "meristem/base/frame.h"
#include "meristem/grow/stand.h"

namespace meristem {

/// Scale of lengths in a frame: the length of its heading. None where it has shrunk to nothing or is not
/// finite, so that nothing can grow there.
std::optional<double> growth_scale(const Frame& frame);

/// A member of the stand that stays empty.
std::unique_ptr<Grower> make_nothing();

}  // namespace meristem
