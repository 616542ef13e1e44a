// SPDX-License-Identifier: Apache-2.0
// Computes the minimum counts of an expansion from the graph's structure alone: products of the counts of multipliers,
// links and fields, and of the depths of recursions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/graph.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// A count that exceeds a limit, and the component with the largest share.
struct CountShare {
  std::string_view what;  ///< "instances"
  double total = 0;
  bool is_whole = true;  ///< false: there are more than `total`
  std::string largest;   ///< id of the component
  double share = 0;      ///< the component's share of the total
  std::uint64_t limit = 0;
  std::string_view limit_name;  ///< "instances" for limits.instances
  std::string expected{};       ///< text instead of the limit; empty: the limit and its name
};

/// Returns the fault, for example "2.1e+08 instances, of which leaf 1.9e+08 (90 %), are too many".
Diagnostic share_diagnostic(const CountShare& share);

/// Throws one InputError with each limit that an expansion of the graph is certain to exceed. Counts instances, nodes,
/// the attraction points of plants that grow together, if `will_place` is true different plants of other documents, and
/// if `will_mesh` is true triangles. Each message names the total and the component with the largest share. Counts only
/// what is known before growth (ComponentType::minimum_counts and minimum_triangles), so a refused graph would fail in
/// any case. Takes less than a second.
void require_bounded_counts(const Graph& graph, const Scene& scene, bool will_place, bool will_mesh);

}  // namespace meristem
