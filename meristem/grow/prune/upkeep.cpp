// SPDX-License-Identifier: Apache-2.0
// Rules that maintain a trained tree year after year: spurs that stay short, and arms that keep their length.
//
// Based on: J. Stevens: Automatische generatie van gesnoeide boom modellen, Universiteit Hasselt 2023, section 4.3.3.
// Deviation: a lateral bud whose shoot was cut back may grow again, as from the ring of buds at the base of a shoot.
// Otherwise all spurs would die within a few years.
#include "meristem/grow/prune/work.h"

namespace meristem {

OperationWork spur(const TreeState& tree, const SpurOperation& what, const std::vector<Shoot>& shoots) {
  const auto max = static_cast<std::size_t>(what.metamers);
  OperationWork work;
  work.renews = true;
  for (const Shoot& shoot : shoots) {
    for (std::size_t k = 0; k < shoot.path.size(); ++k) {
      if (k == max) {
        work.gone.push_back(shoot.path[k]);
        break;
      }
      // Remove branches, and remainders of axes that the lead has left. Keep the lead's own next metamer.
      const MetamerIndex metamer = shoot.path[k];
      for (const Bud bud : {tree.metamers.terminal[metamer], tree.metamers.lateral[metamer]}) {
        const bool leads_on = k + 1 < shoot.path.size() && bud.is_grown() && bud.metamer() == shoot.path[k + 1];
        if (bud.is_grown() && !leads_on) work.gone.push_back(bud.metamer());
      }
    }
  }
  return work;
}

namespace {

/// Finds the lateral bud or shoot that will continue a shoot whose first `kept` metamers stay. Returns the number of
/// metamers up to it, or 0 if there is none.
std::size_t find_heir(const TreeState& tree, const std::vector<MetamerIndex>& path, std::size_t kept) {
  const AxisIndex axis = tree.metamers.axis[path[kept - 1]];
  for (; kept > 0 && tree.metamers.axis[path[kept - 1]] == axis; --kept) {
    const Bud bud = tree.metamers.lateral[path[kept - 1]];
    if (bud.is_open() || bud.is_grown()) return kept;
  }
  return 0;
}

/// Cuts one shoot back to `max` metamers. The lateral shoot at the cut takes the lead, so it is shortened as well.
void cut_to_length(const TreeState& tree, const std::vector<MetamerIndex>& path, std::size_t max, OperationWork& work) {
  const bool is_lateral = tree.metamers.begins_shoot(path[max]);
  const std::size_t heir = max == 0 || is_lateral ? 0 : find_heir(tree, path, max);
  if (heir == 0) return work.gone.push_back(path[max]);
  // Beyond the heir no bud lives: cut there, so that no stub stays.
  work.gone.push_back(path[heir]);
  const Bud bud = tree.metamers.lateral[path[heir - 1]];
  if (!bud.is_grown()) return;
  const std::vector<MetamerIndex> beyond = lead_path(tree.metamers, tree.leads, tree.metamers.axis[bud.metamer()]);
  if (beyond.size() > max - heir) work.gone.push_back(beyond[max - heir]);
}

}  // namespace

OperationWork limit(const TreeState& tree, const LimitOperation& what, const std::vector<Shoot>& shoots) {
  const auto max = static_cast<std::size_t>(what.metamers);
  OperationWork work;
  work.renews = true;
  for (const Shoot& shoot : shoots) {
    if (shoot.path.size() > max && (max > 0 || shoot.axis != 0)) cut_to_length(tree, shoot.path, max, work);
  }
  return work;
}

}  // namespace meristem
