// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/instance_variables.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "meristem/base/fingerprint.h"

namespace meristem {

namespace {

constexpr std::size_t kDrawnTogether = 4096;  // number of sites whose variables are drawn together

}  // namespace

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

SiteList InstanceVariables::draw(ComponentIndex component, SiteList sites) const {
  const std::span<const InstanceVariable* const> variables = variables_of(component);
  if (variables.empty()) return sites;
  SiteList result;
  for (std::size_t begin = 0; begin < sites.size(); begin += kDrawnTogether) {
    std::vector<Site> block = sites.copy(begin, std::min(begin + kDrawnTogether, sites.size()));
    for (const InstanceVariable* variable : variables) draw(*variable, block);
    for (const Site& site : block) result.add(site);
  }
  result.pack();
  return result;
}

void InstanceVariables::draw(const InstanceVariable& variable, std::span<Site> sites) const {
  const VaryingValues drawn(std::span(&variable.value, 1), sites, time_);
  for (std::size_t k = 0; k < sites.size(); ++k) {
    SiteValues values = sites[k].values != nullptr ? *sites[k].values : SiteValues();
    values.names = names_hash_;
    values.numbers.resize(graph_.site_names.size(), std::numeric_limits<double>::quiet_NaN());
    values.numbers[variable.slot] = drawn.value(0, k);
    sites[k].values = std::make_shared<const SiteValues>(std::move(values));
  }
}

}  // namespace meristem
