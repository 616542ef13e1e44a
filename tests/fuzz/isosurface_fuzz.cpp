// SPDX-License-Identifier: Apache-2.0
// Fuzzes values on a small grid: the surface must be closed, manifold and consistently oriented, and without degenerate
// triangles. The first three bytes are the size, 1 to 8 along each axis. The rest are floats with arbitrary bits. An
// incomplete float is ignored, and missing values are 1.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "meristem/shape/implicit/isosurface.h"
#include "tests/fuzz/require.h"

namespace meristem {
namespace {

SampledField field_of(const std::uint8_t* data, std::size_t size) {
  SampledField field{.size = glm::ivec3(1)};
  for (int axis = 0; axis < 3 && size > 0; ++axis, ++data, --size) field.size[axis] = 1 + *data % 8;
  field.values.assign(static_cast<std::size_t>(field.size.x) * field.size.y * field.size.z, 1);
  const std::size_t given = std::min(field.values.size(), size / sizeof(float));
  if (given > 0) std::memcpy(field.values.data(), data, given * sizeof(float));
  return field;
}

void require_triangles(const Mesh& mesh) {
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) require(vertex < mesh.vertex_count());
    const DVec3 a(mesh.positions[triangle[0]]);
    const DVec3 b(mesh.positions[triangle[1]]);
    const DVec3 c(mesh.positions[triangle[2]]);
    const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    require(glm::length(glm::cross(b - a, c - a)) > 1e-8 * longest * longest);
  }
}

/// Checks that each edge has one triangle on either side.
void require_closed(const Mesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) sides.emplace_back(triangle[k], triangle[(k + 1) % 3]);
  }
  std::sort(sides.begin(), sides.end());
  require(std::adjacent_find(sides.begin(), sides.end()) == sides.end());
  for (const auto& [from, to] : sides) {
    require(std::binary_search(sides.begin(), sides.end(), std::pair(to, from)));
  }
}

}  // namespace
}  // namespace meristem

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meristem;
  const SampledField field = field_of(data, size);
  Progress progress;
  const Mesh mesh = extract_isosurface(field, 0, {}, "", progress);
  const bool is_any_inside = std::any_of(field.values.begin(), field.values.end(), [](float v) { return v < 0; });
  require(mesh.triangles.empty() != is_any_inside);
  require_triangles(mesh);
  require_closed(mesh);
  return 0;
}
