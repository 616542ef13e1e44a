// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/mesh/chosen_objects.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"

namespace meristem {

namespace {

constexpr std::size_t kNamesInMessage = 12;

/// Returns the names of all objects, each once, in the order of the scene.
std::vector<std::string> object_names(const MeshScene& scene) {
  std::vector<std::string> names;
  for (const MeshInstances& instances : scene.meshes) {
    std::string name = object_name(instances);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  return names;
}

InputError unknown_object(const std::string& name, const std::vector<std::string>& known, const std::string& option) {
  const auto shown = known.begin() + static_cast<std::ptrdiff_t>(std::min(known.size(), kNamesInMessage));
  return InputError(Diagnostic{
      .message = fmt::format("{} names '{}', which is not among the plant's objects", option, name),
      .expected = fmt::format("{}{}", fmt::join(known.begin(), shown, ", "), shown == known.end() ? "" : ", ..."),
      .nearest = nearest_name(name, known)});
}

}  // namespace

MeshScene chosen_objects(const MeshScene& scene, std::span<const std::string> names, const std::string& option) {
  if (names.empty()) return scene;
  const std::vector<std::string> known = object_names(scene);
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) == known.end()) throw unknown_object(name, known, option);
  }
  MeshScene chosen{.materials = scene.materials, .meshes = {}, .individuals = scene.individuals};
  for (const MeshInstances& instances : scene.meshes) {
    if (std::find(names.begin(), names.end(), object_name(instances)) != names.end()) {
      chosen.meshes.push_back(instances);
    }
  }
  return chosen;
}

}  // namespace meristem
