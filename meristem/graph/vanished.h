// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <glm/matrix.hpp>

#include "meristem/base/frame.h"

namespace meristem {

/// True where the frame's volume is too small to be inverted: what would stand there is left out.
inline bool has_vanished(const Frame& frame) { return std::abs(glm::determinant(frame.axes)) < 1e-36F; }

}  // namespace meristem
