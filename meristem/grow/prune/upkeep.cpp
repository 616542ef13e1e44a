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

OperationWork limit(const LimitOperation& what, const std::vector<Shoot>& shoots) {
  const auto max = static_cast<std::size_t>(what.metamers);
  OperationWork work;
  work.renews = true;
  for (const Shoot& shoot : shoots) {
    if (shoot.path.size() > max && (max > 0 || shoot.axis != 0)) work.gone.push_back(shoot.path[max]);
  }
  return work;
}

}  // namespace meristem
