// SPDX-License-Identifier: Apache-2.0
// Fuzzes files of points: either finite points within the limit, or an error of this file.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "meristem/base/diagnostic.h"
#include "meristem/scene/file/read_points.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meristem;
  SizeLimits limits;
  limits.points = 5000;
  try {
    const PointCloud points = parse_points({reinterpret_cast<const char*>(data), size}, "scan", limits);
    require(!points.empty() && points.size() <= limits.points);
    for (const DVec3 point : points) {
      require(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z));
    }
  } catch (const InputError& error) {
    require_errors_of(error, "scan");
  }
  return 0;
}
