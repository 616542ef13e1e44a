// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/instance_variables.h"

#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "meristem/base/fingerprint.h"

namespace meristem {

InstanceVariables::InstanceVariables(const Graph& graph, double time) : graph_(graph), time_(time) {
  Fingerprint names;
  for (const std::string& name : graph.site_names) names.add_text(name);
  names_hash_ = names.hash();
  for (const InstanceVariable& variable : graph.instance_variables) by_owner_[variable.owner].push_back(&variable);
}

std::span<const InstanceVariable* const> InstanceVariables::variables_of(ComponentIndex component) const {
  const auto found = by_owner_.find(component);
  return found == by_owner_.end() ? std::span<const InstanceVariable* const>() : found->second;
}

std::uint64_t InstanceVariables::hash(ComponentIndex component) const {
  Fingerprint hash;
  for (const InstanceVariable* variable : variables_of(component)) {
    hash.add_text(variable->name).add(time_);
    hash.add(variable->fingerprint);
  }
  return hash.add(names_hash_).hash();
}

std::vector<Site> InstanceVariables::draw(ComponentIndex component, std::vector<Site> sites) const {
  if (sites.empty()) return sites;
  for (const InstanceVariable* variable : variables_of(component)) {
    const VaryingValues drawn(std::span(&variable->value, 1), sites, time_);
    for (std::size_t k = 0; k < sites.size(); ++k) {
      SiteValues values = sites[k].values != nullptr ? *sites[k].values : SiteValues();
      values.names = names_hash_;
      values.numbers.resize(graph_.site_names.size(), std::numeric_limits<double>::quiet_NaN());
      values.numbers[variable->slot] = drawn.value(0, k);
      sites[k].values = std::make_shared<const SiteValues>(std::move(values));
    }
  }
  return sites;
}

}  // namespace meristem
