// SPDX-License-Identifier: Apache-2.0
// What the page's board is told of a document besides its tree, as protocol.md writes it.
#pragma once

#include <string>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/graph/component.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/table/value.h"

namespace meristem::studio {

/// The links that stand in no text: from a component to what it places by itself, as a grammar does.
Value implied_links_value(const Graph& graph);

/// The comments on components, by their names; empty where the text is not JSON.
/// Throws Cancelled soon after `progress` was asked to stop; null: it cannot be stopped.
Value notes_value(const std::string& text, const Progress* progress = nullptr);

/// All components of a document but cameras.
std::vector<std::string> placeable_components(const Value& tree, const Registry& registry);

/// Those of the components that no link of the others leads to; where links go round in a circle, the first.
Value part_roots_value(const Value& tree, const std::vector<std::string>& components);

}  // namespace meristem::studio
