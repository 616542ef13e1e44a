// SPDX-License-Identifier: Apache-2.0
// Which components a value of a document affects, for drawings of the p-graph.
#pragma once

#include <string_view>
#include <vector>

#include "meristem/document/document.h"

namespace meristem {

/// The effect of a value on the instances of a component.
enum class GraphEffect {
  none,       ///< their geometry and their places stay
  inherited,  ///< they may move, change in number, or grow otherwise, because they depend on a changed component
  own,        ///< the value is part of the component, or the component uses it by name
};

/// Returns the effect of the value at `path` on each component of the document's graph. The path is the name of a
/// variable ("age"), a component's parameter ("leaf.length", also with "components." before it), a component ("leaf")
/// or a key of a link ("links[1].density"). A change of a component affects its descendants, components that show it,
/// and plants that grow beside it. A change of looks affects the component alone, and a variable that the scene uses
/// affects all components but the camera. Throws InputError if the document has no such value.
std::vector<GraphEffect> affected_by(const Document& document, std::string_view path);

}  // namespace meristem
