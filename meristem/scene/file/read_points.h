// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/vec.h"

namespace meristem {

/// Points of a file, in double precision, because scans may use coordinates of a national grid.
using PointCloud = std::vector<DVec3>;

/// Returns the points of a PLY file (properties x, y and z of its element `vertex`) or of a text. A text has one point
/// per line: its first three numbers, separated by blanks, commas or semicolons. Lines that begin with # or // are
/// comments, and the first other line may be a heading. Throws InputError with file and line or row. A file without
/// points and more points than `limits.points` are errors, and so are coordinates out of range (base/number_limit.h).
PointCloud read_points(const std::string& path, const SizeLimits& limits);
/// Like read_points(), for the bytes of a file. `file` is the file's name in messages.
PointCloud parse_points(std::string_view bytes, const std::string& file, const SizeLimits& limits);

}  // namespace meristem
