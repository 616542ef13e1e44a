// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/vec.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// Reports errors in the points of a pole or wire, whose list has the path `line`. Fewer than two points are an error
/// at `line`. Each point that repeats the point before it is an error at `line[k]`.
void check_line(const std::vector<Vec3>& points, const DocumentPath& line, ParameterReader& reader);

}  // namespace meristem
