// SPDX-License-Identifier: Apache-2.0
// Parts of documents: components with the links among them and the variables that they name, taken out of one document
// as it is written and put into another.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meristem/document/edit/located_tree.h"
#include "meristem/document/edit/patch.h"

namespace meristem {

/// A document of its own with these components as they are written in `tree`, their notes included. Throws an
/// InputError for names that no component has.
std::string part_text(const LocatedTree& tree, const std::vector<std::string>& components);

/// Where the components and links of a part stand among those of a document; nothing: behind all others.
struct PartPlace {
  std::optional<std::size_t> component{};
  std::optional<std::size_t> link{};
};

/// Puts all components of `part`, whose names must be free, into the document with their notes, links and variables.
/// Where both have a variable, the document's holds.
Patch insert_plant_part(const LocatedTree& tree, const LocatedTree& part, const PartPlace& place);

}  // namespace meristem
