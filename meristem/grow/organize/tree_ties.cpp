// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/organize/tree_ties.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "meristem/grow/prune/support_line.h"

namespace meristem {

namespace {

// A shoot that has strayed from its line aims at a point this number of metamers on: nearer, it swings about the line;
// farther, it stays beside it.
constexpr double kAhead = 2;

}  // namespace

TreeTies::TreeTies(const OrganizeParameters& parameters) : ahead_(static_cast<float>(kAhead * parameters.length)) {
  for (const Operation& operation : parameters.operations) {
    first_of_.push_back(0);
    if (const auto* support = std::get_if<Support>(&operation.what)) {
      lines_.push_back({support->line, support->weight});
      first_of_.back() = static_cast<std::uint32_t>(lines_.size());
    } else if (const auto* layers = std::get_if<Layers>(&operation.what)) {
      first_of_.back() = static_cast<std::uint32_t>(lines_.size()) + 1;
      for (std::vector<Vec3>& wire : arm_wires(*layers, parameters.length)) {
        lines_.push_back({std::move(wire), layers->weight});
      }
    } else if (std::holds_alternative<Bend>(operation.what)) {
      lines_.push_back({{}, 0});  // it holds, and leads nowhere
      first_of_.back() = static_cast<std::uint32_t>(lines_.size());
    }
  }
}

void TreeTies::add_arms(const std::vector<ArmBud>& arms, std::uint32_t first) {
  for (const ArmBud& arm : arms) arms_.emplace_back(arm.metamer, first + static_cast<std::uint32_t>(arm.wire));
  std::ranges::sort(arms_);
}

std::uint32_t TreeTies::of_bud(const Metamers& metamers, const Leads& leads, MetamerIndex from, bool is_lateral) const {
  const AxisIndex axis = metamers.axis[from];
  if (!is_lateral || leads.from[axis] == from) return metamers.axes[axis].tie;
  const auto found = std::ranges::lower_bound(arms_, std::pair<MetamerIndex, std::uint32_t>(from, 0));
  return found != arms_.end() && found->first == from ? found->second : 0;
}

Vec3 TreeTies::way(std::uint32_t tie, Vec3 tip) const { return way_along(lines_[tie - 1].points, tip, ahead_); }

}  // namespace meristem
