// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <stdexcept>
#include <string_view>

#include "meristem/graph/table/parameter.h"

namespace meristem {

/// Returns the table with a range for the values of a curve, so that editors keep points within it. The component's
/// check refuses values outside. Throws std::invalid_argument if the table has no such curve.
inline ParameterTable with_curve_range(ParameterTable table, std::string_view curve, double min,
                                       double max = std::numeric_limits<double>::infinity()) {
  for (Parameter& row : table.parameters) {
    if (row.name != curve || row.kind != ParameterKind::curve) continue;
    row.form.min = min;
    row.form.max = max;
    return table;
  }
  throw std::invalid_argument("the table has no such curve");
}

}  // namespace meristem
