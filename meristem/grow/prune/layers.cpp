// SPDX-License-Identifier: Apache-2.0
// The rule of the espalier. The leader is cut at the end of each layer. The two buds below the cut grow into strong
// arms, and the bud at the cut continues the leader.
//
// Based on: J. Stevens: Automatische generatie van gesnoeide boom modellen, Universiteit Hasselt 2023, section 4.3.1.
#include "meristem/grow/prune/layers.h"

#include "meristem/base/math.h"
#include "meristem/grow/prune/work.h"

namespace meristem {

namespace {

/// The layer of a metamer on the leader, and its number in the layer: 1 at the base.
struct PlaceInLayer {
  int layer = 0;
  int number = 1;
};

PlaceInLayer place_of(std::size_t on_leader, const LayersOperation& what) {
  const int at = static_cast<int>(on_leader);
  return {at / what.metamers, at % what.metamers + 1};
}

}  // namespace

OperationWork layer(const TreeState& tree, const LayersOperation& what) {
  const Metamers& metamers = tree.metamers;
  const std::vector<MetamerIndex> leader = lead_path(metamers, tree.leads, 0);
  OperationWork work;
  for (std::size_t k = 0; k < leader.size(); ++k) {
    const auto [at_layer, number] = place_of(k, what);
    const MetamerIndex metamer = leader[k];
    const bool is_top = at_layer + 1 == what.count && number == what.metamers;
    const Bud lateral = metamers.lateral[metamer];
    const Bud terminal = metamers.terminal[metamer];
    if (number == what.metamers) {
      if (terminal.is_open()) work.pinched.push_back(metamer);
      if (terminal.is_grown()) work.gone.push_back(terminal.metamer());
      if (is_top) work.headless.push_back(metamers.axis[metamer]);
    }
    if (number < what.metamers - 2 || is_top) {
      if (lateral.is_grown()) work.gone.push_back(lateral.metamer());
      if (is_top && lateral.is_open()) work.lifted.push_back(metamer);
    }
    // Shoots above this cut of the leader are removed with it.
    if (is_top || (number == what.metamers && terminal.is_grown())) break;
  }
  return work;
}

std::vector<ArmBud> find_arms(const Metamers& metamers, const TreeLeads& leads, const LayersOperation& what) {
  const std::vector<MetamerIndex> leader = lead_path(metamers, leads, 0);
  std::vector<ArmBud> arms;
  for (std::size_t k = 0; k < leader.size(); ++k) {
    const auto [at_layer, number] = place_of(k, what);
    if (at_layer >= what.count) break;
    const int from_top = what.metamers - number;
    if (from_top != 1 && from_top != 2) continue;
    arms.push_back({leader[k], 2 * static_cast<std::size_t>(at_layer) + (from_top == 2 ? 0 : 1)});
  }
  return arms;
}

std::vector<std::vector<Vec3>> arm_wires(const LayersOperation& what, double length) {
  std::vector<std::vector<Vec3>> wires;
  for (int at_layer = 0; at_layer < what.count; ++at_layer) {
    const double share = what.count > 1 ? static_cast<double>(at_layer) / (what.count - 1) : 0;
    const double angle = what.angle + share * (what.angle_last - what.angle);
    const auto level = static_cast<float>(math::cos(angle));
    const auto rise = static_cast<float>(math::sin(angle));
    // Half a metamer above the bud of the lower arm, so that both arms of a layer can follow the wire.
    const Vec3 middle(0, static_cast<float>((what.metamers * (at_layer + 1) - 1.5) * length), 0);
    for (const float side : {-1.0F, 1.0F}) {
      wires.push_back({middle, middle + static_cast<float>(length) * (side * level * what.right + rise * kUp)});
    }
  }
  return wires;
}

}  // namespace meristem
