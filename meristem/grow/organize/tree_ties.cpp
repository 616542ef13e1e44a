// SPDX-License-Identifier: Apache-2.0
// The lines of supports, wires and bends that shoots are tied to, and growth directions along them.
#include "meristem/grow/organize/tree_ties.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/grow/prune/support_line.h"

namespace meristem {

namespace {

// Look-ahead in metamers: a shoot beside its line aims at a point this far along the line. Smaller values make it swing
// around the line; larger values leave it beside the line.
constexpr double kAhead = 2;

/// Returns the line of a support of the scene, relative to a root.
std::vector<Vec3> line_of_scene(const TreeOperation& operation, const std::string& name, const Scene& scene,
                                Vec3 root) {
  const auto found = scene.supports.find(name);
  if (found == scene.supports.end()) {
    std::vector<std::string> names;
    for (const auto& [known, line] : scene.supports) names.push_back(known);
    throw InputError(Diagnostic{.message = fmt::format("the scene has no support '{}'", name),
                                .expected = "the name of one of scene.supports",
                                .nearest = nearest_name(name, names),
                                .path = operation.path + ".named"});
  }
  std::vector<Vec3> line = found->second;
  for (Vec3& point : line) point -= root;
  return line;
}

}  // namespace

TreeTies::TreeTies(const OrganizedSpecies& species, Vec3 root)
    : ahead_(static_cast<float>(kAhead * species.parameters.length)) {
  const OrganizeParameters& parameters = species.parameters;
  for (const TreeOperation& operation : parameters.operations) {
    first_of_.push_back(0);
    if (const auto* support = std::get_if<TrainingSupport>(&operation.what)) {
      lines_.push_back(
          {support->named.empty() ? support->line : line_of_scene(operation, support->named, species.scene, root),
           support->weight});
      first_of_.back() = static_cast<std::uint32_t>(lines_.size());
    } else if (const auto* layers = std::get_if<LayersOperation>(&operation.what)) {
      first_of_.back() = static_cast<std::uint32_t>(lines_.size()) + 1;
      for (std::vector<Vec3>& wire : arm_wires(*layers, parameters.length)) {
        lines_.push_back({std::move(wire), layers->weight});
      }
    } else if (std::holds_alternative<BendOperation>(operation.what) ||
               std::holds_alternative<TieOperation>(operation.what)) {
      lines_.push_back({{}, 0});  // holds a shoot without directing its growth
      first_of_.back() = static_cast<std::uint32_t>(lines_.size());
    }
  }
}

void TreeTies::add_arms(const std::vector<ArmBud>& arms, std::uint32_t first) {
  for (const ArmBud& arm : arms) arms_.emplace_back(arm.metamer, first + static_cast<std::uint32_t>(arm.wire));
  std::ranges::sort(arms_);
}

std::uint32_t TreeTies::of_bud(const Metamers& metamers, const TreeLeads& leads, MetamerIndex from,
                               bool is_lateral) const {
  const AxisIndex axis = metamers.axis[from];
  if (!is_lateral || leads.from[axis] == from) return metamers.axes[axis].tie;
  const auto found = std::ranges::lower_bound(arms_, std::pair<MetamerIndex, std::uint32_t>(from, 0));
  return found != arms_.end() && found->first == from ? found->second : 0;
}

Vec3 TreeTies::way(std::uint32_t tie, Vec3 tip) const { return way_along(lines_[tie - 1].points, tip, ahead_); }

}  // namespace meristem
