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

/// Renames a component with all that refers to it: ends of links, and symbols of grammars that stand in the document
/// and place it (`placed_by` says whether the component of that id places it by its name). Throws an InputError where
/// there is no such component, where the name is taken or cannot be one, or would have another meaning in a grammar.
Patch rename_component(const LocatedTree& tree, const std::string& id, const std::string& name,
                       const Registry& registry, const std::function<bool(const std::string& placer)>& placed_by);

/// Renames a variable with all expressions that use it: those at `expression_paths`, and in grammars that stand in the
/// document. Throws in the same way.
Patch rename_variable(const LocatedTree& tree, const std::string& variable, const std::string& name,
                      const Registry& registry, const std::vector<std::string>& expression_paths);

}  // namespace meristem
