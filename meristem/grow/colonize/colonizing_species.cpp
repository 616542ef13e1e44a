// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/colonizing_species.h"

#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/plant/finish.h"
#include "meristem/scene/obstacle/open_way.h"

namespace meristem {

std::string ColonizingSpecies::path(const char* parameter) const {
  return fmt::format("components.{}.{}", component, parameter);
}

void ColonizingSpecies::refuse(const char* parameter, std::string message, std::string expected) const {
  Diagnostic error;
  error.message = std::move(message);
  error.expected = std::move(expected);
  error.path = path(parameter);
  throw InputError(std::move(error));
}

void ColonizingSpecies::require_nodes(std::uint64_t nodes, const char* parameter) const {
  if (nodes <= limits.nodes) return;
  throw_limit("skeleton nodes", static_cast<double>(nodes), limits.nodes, "nodes", path(parameter));
}

Skeleton finished_tree(const ColonizingSpecies& species, Skeleton skeleton, Vec3 root, Progress& progress) {
  const auto is_free = [&](Vec3 from, Vec3 to) { return is_way_open(species.scene.obstacles, root, from, to); };
  const auto require_nodes = [&](std::uint64_t nodes) { species.require_nodes(nodes, "finish.subdivide"); };
  const FinishContext context{species.parameters.step, is_free, require_nodes, progress};
  skeleton = finish(std::move(skeleton), species.parameters.finish, context);
  assign_pipe_radii(skeleton, species.parameters.radii);
  assign_axes(skeleton);
  for (Vec3& position : skeleton.position) position += root;
  return skeleton;
}

}  // namespace meristem
