// SPDX-License-Identifier: Apache-2.0
// Adds up triangles and bytes by component, so that an exceeded limit names the component that uses most.
#include "meristem/shape/stem/scene_tally.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "meristem/base/frame.h"

namespace meristem {

void SceneTally::add_mesh(const std::string& component, const Mesh& mesh) {
  triangles_[component] += mesh.triangle_count();
  bytes_[component] += mesh.bytes();
}

void SceneTally::add_tubes(const StemLooks& looks, const std::vector<TubeSize>& sizes) {
  constexpr std::uint64_t kMaxVertices = std::numeric_limits<std::uint32_t>::max();
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const std::string& component = looks.first_part[k]->component;
    triangles_[component] += sizes[k].triangles;
    bytes_[component] += sizes[k].bytes();
    if (sizes[k].vertices > kMaxVertices) {
      throw_limit("vertices of one stem", static_cast<double>(sizes[k].vertices), kMaxVertices, "triangles",
                  "components." + component);
    }
  }
}

void SceneTally::add_organs(const std::string& component, const Mesh& mesh, std::uint64_t count) {
  triangles_[component] += mesh.triangle_count() * count;
  bytes_[component] += mesh.bytes() + count * sizeof(Frame);
}

void SceneTally::check(const SizeLimits& limits) const {
  check(triangles_, "triangles", limits.triangles, "triangles");
  check(bytes_, "bytes of geometry", limits.mesh_bytes, "mesh_bytes");
}

void SceneTally::check(const Amounts& amounts, std::string_view what, std::uint64_t limit,
                       std::string_view limit_name) {
  std::uint64_t total = 0;
  for (const auto& [component, amount] : amounts) total += amount;
  if (total <= limit) return;
  const auto max = std::max_element(amounts.begin(), amounts.end(),
                                    [](const auto& a, const auto& b) { return a.second < b.second; });
  throw_limit(what, static_cast<double>(total), limit, limit_name, "components." + max->first);
}

}  // namespace meristem
