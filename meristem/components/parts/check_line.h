// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/vec.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// Faults of the points of a pole or wire, which stand at the path `line`: fewer than two of them, or a point that
/// repeats the one before it, so that the line has no direction there.
void check_line(const std::vector<Vec3>& points, const DocumentPath& line, ParameterReader& reader);

}  // namespace meristem
