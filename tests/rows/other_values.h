// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "meristem/graph/table/parameter.h"

namespace meristem {

/// Returns values that may replace `present` for a parameter, the most suitable first. `name` is the name of table and
/// parameter, such as "a leaf.polygon": some parameters need special values.
std::vector<Value> other_values(const std::string& name, const Parameter& row, const Value& present);

}  // namespace meristem
