// SPDX-License-Identifier: Apache-2.0
// Fuzzes meshes: either indices in range, or an error of this file. The winding number of a closed mesh must not exceed
// its number of triangles, and must be 0 far away.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "meristem/base/diagnostic.h"
#include "meristem/scene/file/read_mesh.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meristem;
  SizeLimits limits;
  limits.triangles = 5000;
  limits.instances = 1000;
  try {
    const TriangleMesh mesh = parse_mesh({reinterpret_cast<const char*>(data), size}, "body", limits);
    require(mesh.triangles.size() <= limits.triangles);
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t vertex : triangle) require(vertex < mesh.positions.size());
    }
    if (!closedness_errors(mesh).empty() || !body_error(mesh).empty()) return 0;
    const ClosedMesh closed(mesh);
    const auto max = static_cast<int>(mesh.triangles.size());
    for (const DVec3 position : mesh.positions) require(std::abs(closed.winding_number(position)) <= max);
    require(!closed.contains(DVec3(1e300)) && !closed.contains(DVec3(-1e300)));
  } catch (const InputError& error) {
    require_errors_of(error, "body");
  }
  return 0;
}
