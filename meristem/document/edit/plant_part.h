// SPDX-License-Identifier: Apache-2.0
// Parts of documents: components with the links among them and the variables that they use. They are copied from one
// document as they are written and inserted into another.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meristem/document/edit/located_tree.h"
#include "meristem/document/edit/tree_edit.h"

namespace meristem {

/// Returns a document with these components as they are written in `tree`, including their notes. Throws an InputError
/// for names that no component has. Throws Cancelled soon after `progress` was asked to stop. Null: it cannot be
/// stopped.
std::string part_text(const LocatedTree& tree, const std::vector<std::string>& components,
                      const Progress* progress = nullptr);

/// The positions of a part's components and links in a document; unset: after all others.
struct PartPlace {
  std::optional<std::size_t> component{};
  std::optional<std::size_t> link{};
};

/// Inserts all components of `part` into the document, with their notes, links and variables. The components' names
/// must be free. If both have a variable, the document's is kept.
void insert_plant_part(TreeEdit& document, const LocatedTree& part, const PartPlace& place);

}  // namespace meristem
