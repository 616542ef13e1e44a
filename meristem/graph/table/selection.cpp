// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/selection.h"

#include <algorithm>

namespace meristem {

bool InstanceSelection::contains(const Site& site, double time) const {
  for (const auto& [low, high] : ranges) {
    if (low <= site.i && site.i <= high) return true;
  }
  if (conditions.empty()) return false;
  std::vector<double> variables(std::max(names, site_variables().size()));
  for (std::size_t k = 0; k < variables.size(); ++k) variables[k] = site_variable(k, site, site.i, time);
  return std::any_of(conditions.begin(), conditions.end(), [&](const SiteCondition& condition) {
    return is_true(condition.expression.evaluate(variables, site.key.child(condition.text)));
  });
}

}  // namespace meristem
