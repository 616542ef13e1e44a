// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "meristem/graph/graph.h"
#include "meristem/graph/site_list.h"

namespace meristem {

/// Draws the variables of instances at one time of the document.
class InstanceVariables {
 public:
  /// `graph` must outlive this object. `time` is the document's, seconds.
  InstanceVariables(const Graph& graph, double time);

  /// Hash of the names of Graph::site_names.
  std::uint64_t names_hash() const { return names_hash_; }
  /// Returns a hash of the definitions of a component's variables.
  std::uint64_t hash(ComponentIndex component) const;
  /// Returns the sites with the variables that each instance of the component draws.
  SiteList draw(ComponentIndex component, SiteList sites) const;

 private:
  std::span<const InstanceVariable* const> variables_of(ComponentIndex component) const;
  void draw(const InstanceVariable& variable, std::span<Site> sites) const;

  const Graph& graph_;
  double time_;
  std::uint64_t names_hash_;
  std::unordered_map<ComponentIndex, std::vector<const InstanceVariable*>> by_owner_;
};

}  // namespace meristem
