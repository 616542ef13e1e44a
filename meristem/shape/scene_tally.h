// SPDX-License-Identifier: Apache-2.0
// What a scene's meshes would take, summed up before they are made.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/mesh.h"
#include "meristem/shape/stem_looks.h"
#include "meristem/shape/tube/tubes.h"

namespace meristem {

class SceneTally {
 public:
  /// A mesh that stands once.
  void add_mesh(const std::string& component, const Mesh& mesh);
  /// The tubes of one stem, `sizes` by mesh of its looks. Throws InputError where one has more vertices than a mesh
  /// may.
  void add_tubes(const StemLooks& looks, const std::vector<TubeSize>& sizes);
  /// A mesh in `count` frames.
  void add_organs(const std::string& component, const Mesh& mesh, std::uint64_t count);

  /// Throws InputError where all that was added passes a limit, at the component that takes most.
  void check(const Limits& limits) const;

 private:
  using Amounts = std::map<std::string, std::uint64_t, std::less<>>;  // by component

  static void check(const Amounts& amounts, std::string_view what, std::uint64_t limit, std::string_view limit_name);

  Amounts triangles_;
  Amounts bytes_;
};

}  // namespace meristem
