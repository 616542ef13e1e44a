// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"

namespace meristem {

/// Returns all built-in component types, in the order of lists.
const Registry& builtin_components();

}  // namespace meristem
