// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/vec.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// Reports errors in the points of a pole or wire at the path `line`: fewer than two points, or a repeated point, where
/// the line has no direction.
void check_line(const std::vector<Vec3>& points, const DocumentPath& line, ParameterReader& reader);

}  // namespace meristem
