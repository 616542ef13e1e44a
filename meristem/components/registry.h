// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"

namespace meristem {

/// All component types of the program, in the order in which they are listed.
const Registry& builtin_components();

}  // namespace meristem
