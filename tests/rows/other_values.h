// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "meristem/graph/table/parameter.h"

namespace meristem {

/// Values that a row may have in place of `present`, most likely ones first. `name` is its table's and its own, as in
/// "a leaf.polygon": some rows need values that no rule finds.
std::vector<Value> other_values(const std::string& name, const Parameter& row, const Value& present);

}  // namespace meristem
