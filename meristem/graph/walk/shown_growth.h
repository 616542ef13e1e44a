// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <unordered_set>

#include "meristem/graph/graph.h"
#include "meristem/graph/growth_traces.h"

namespace meristem {

/// Returns true if a component shows the growth of another component.
bool watches_growth(const Prototype& prototype);

/// How a view shows the growth of each component of a graph, and which parts of the growth it records.
class ShownGrowth {
 public:
  /// Both arguments must outlive this object.
  ShownGrowth(const Graph& graph, const GrowthView& view);

  /// Returns the growth step at which a component is shown. Returns nothing if the component is shown fully grown. A
  /// component that shows another one's growth is shown at that one's step.
  std::optional<int> step_of(const Prototype& prototype) const;
  /// Returns true if the animation of the document shows a component as it has grown up to the present time.
  bool unrolls(const Prototype& prototype) const;
  /// Returns true if trees in plan mode are shown after their planned operations.
  bool shows_outcome() const { return view_.outcome && !view_.step; }
  /// Returns the parts of a component's growth to record: the parts that the view requests, and the parts that other
  /// components show.
  TraceRequest request_for(const Prototype& prototype) const;

 private:
  const Graph& graph_;
  const GrowthView& view_;
  std::unordered_set<std::string_view> watched_;  // ids of components whose growth other components show
};

}  // namespace meristem
