// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/walk/shown_growth.h"

namespace meristem {

bool watches_growth(const Prototype& prototype) {
  return !prototype.shown.empty() && prototype.type->watches_growth &&
         prototype.type->watches_growth(prototype.parameters.get());
}

ShownGrowth::ShownGrowth(const Graph& graph, const GrowthView& view) : graph_(graph), view_(view) {
  for (const Prototype& prototype : graph.components) {
    if (watches_growth(prototype)) watched_.insert(prototype.shown);
  }
}

std::optional<int> ShownGrowth::step_of(const Prototype& prototype) const {
  return is_looked_at(view_, prototype.id) || is_looked_at(view_, prototype.shown) ? view_.step : std::nullopt;
}

bool ShownGrowth::unrolls(const Prototype& prototype) const {
  return prototype.type->grows_in_time && graph_.animation && graph_.animation->steps_per_second && !step_of(prototype);
}

TraceRequest ShownGrowth::request_for(const Prototype& prototype) const {
  TraceRequest request = view_.request;
  if (request.has(TracePart::markers) || step_of(prototype)) request = request | TraceRequest{TracePart::steps};
  if (shows_outcome()) request = request | TraceRequest{TracePart::outcome};
  if (watched_.contains(prototype.id)) request = request | TraceRequest{TracePart::points};
  return request;
}

}  // namespace meristem
