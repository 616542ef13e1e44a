// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/check_line.h"

namespace meristem {

void check_line(const std::vector<Vec3>& points, const DocumentPath& line, ParameterReader& reader) {
  if (points.size() < 2) {
    return reader.add_error(line, "the line has fewer than two points", "a list of at least two points [x, y, z]");
  }
  for (std::size_t k = 1; k < points.size(); ++k) {
    if (points[k] != points[k - 1]) continue;
    reader.add_error(DocumentPath(line, k), "the support has no length here: the point repeats the one before it",
                     "another point [x, y, z]");
  }
}

}  // namespace meristem
