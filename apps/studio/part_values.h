// SPDX-License-Identifier: Apache-2.0
// Facts about a document for the page's board, besides its tree, in the form of protocol.md.
#pragma once

#include <string>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/graph/component.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/table/value.h"

namespace meristem::studio {

/// Returns the links that are not in the text: from a component to the components that it places, for example with a
/// grammar.
Value implied_links_value(const Graph& graph);

/// Returns the comments on components, by component id. Returns no comments if the text is not JSON. Throws Cancelled
/// soon after `progress` was asked to stop. Null: it cannot be stopped.
Value notes_value(const std::string& text, const Progress* progress = nullptr);

/// Returns all components of a document except cameras.
std::vector<std::string> placeable_components(const Value& tree, const Registry& registry);

/// Returns the components that no other one links to. From a circle of links, returns the first component.
Value part_roots_value(const Value& tree, const std::vector<std::string>& components);

}  // namespace meristem::studio
