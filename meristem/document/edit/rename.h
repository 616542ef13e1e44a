// SPDX-License-Identifier: Apache-2.0
// Other names for components and variables, wherever the document speaks of them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "meristem/document/edit/located_tree.h"
#include "meristem/document/edit/patch.h"
#include "meristem/graph/component.h"

namespace meristem {

/// Renames a component, the ends of links that name it, and symbols of grammars in the document that place it.
/// `placed_by` returns true if the component with that id places it by name. Throws an InputError if the component does
/// not exist, if the name is taken or invalid, or if it would have another meaning in a grammar.
TextPatch rename_component(const LocatedTree& tree, const std::string& id, const std::string& name,
                           const Registry& registry, const std::function<bool(const std::string& placer)>& placed_by);

/// Renames a variable in all expressions that use it: at `expression_paths`, and in grammars in the document. Throws
/// like rename_component().
TextPatch rename_variable(const LocatedTree& tree, const std::string& variable, const std::string& name,
                          const Registry& registry, const std::vector<std::string>& expression_paths);

}  // namespace meristem
