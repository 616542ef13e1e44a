// SPDX-License-Identifier: Apache-2.0
// Adds up the size of a scene's meshes before they are made.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/mesh.h"
#include "meristem/shape/stem/stem_looks.h"
#include "meristem/shape/tube/tubes.h"

namespace meristem {

class SceneTally {
 public:
  /// Adds a mesh with a single instance.
  void add_mesh(const std::string& component, const Mesh& mesh);
  /// Adds the tubes of one stem. `sizes` has one entry per mesh of its looks. Throws InputError if a mesh would have
  /// too many vertices.
  void add_tubes(const StemLooks& looks, const std::vector<TubeSize>& sizes);
  /// Adds a mesh with `count` instances.
  void add_organs(const std::string& component, const Mesh& mesh, std::uint64_t count);

  /// Throws InputError at the largest component if the total exceeds a limit.
  void check(const SizeLimits& limits) const;

 private:
  using Amounts = std::map<std::string, std::uint64_t, std::less<>>;  // by component

  static void check(const Amounts& amounts, std::string_view what, std::uint64_t limit, std::string_view limit_name);

  Amounts triangles_;
  Amounts bytes_;
};

}  // namespace meristem
