// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <glm/matrix.hpp>

#include "meristem/base/frame.h"

namespace meristem {

/// Returns true if the frame's volume is too small to be inverted. Instances at such frames are left out.
inline bool has_vanished(const Frame& frame) { return std::abs(glm::determinant(frame.axes)) < 1e-36F; }

}  // namespace meristem
