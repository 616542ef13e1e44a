// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/vec.h"

namespace meristem {

/// Points as a file has them; in double, because scans may carry the coordinates of a whole country.
using PointCloud = std::vector<DVec3>;

/// The points of a PLY file (properties x, y and z of its element `vertex`), or of a text with a point per line: its
/// first three numbers, between blanks, commas or semicolons. In a text, lines that begin with # or // are comments,
/// and the first other line may be a heading. Throws InputError with file and line or row.
PointCloud read_points(const std::string& path, const Limits& limits);
/// The points of a file's bytes, as `read_points` gives them; `file` is the file's name in messages.
PointCloud parse_points(std::string_view bytes, const std::string& file, const Limits& limits);

}  // namespace meristem
