// SPDX-License-Identifier: Apache-2.0
// 32-bit numbers in the form of messages.
#pragma once

#include "meristem/base/vec.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Returns the number with the fewest digits that reads back as the given 32-bit number.
double short_number(float number);

/// Returns [x, y, z], each as a short_number().
Value vector_value(Vec3 vector);

}  // namespace meristem
