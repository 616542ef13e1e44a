// SPDX-License-Identifier: Apache-2.0
// 32-bit numbers as messages write them.
#pragma once

#include "meristem/base/vec.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// The number with the fewest digits that is read back as the same 32-bit number.
double short_number(float number);

/// [x, y, z], each a short_number().
Value vector_value(Vec3 vector);

}  // namespace meristem
