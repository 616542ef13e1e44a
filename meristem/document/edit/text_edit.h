// SPDX-License-Identifier: Apache-2.0
// Edits of a JSON text in the way a person makes them. Comments, layout, line ends and everything that an edit does not
// name stay as they are. New parts are written like their neighbours: in one line with them, or on lines of their own
// with equal indentation. Numbers get the fewest digits that represent them.
//
// If a member or element is removed or moved, the comments between it and the next comma or bracket go with it. If it
// has lines of its own, so do the comments after the comma in its last line. Comments on lines of their own stay.
//
// Paths are whole paths (path.h), from the root. All functions throw an InputError for paths that lead nowhere and for
// values that JSON cannot represent. They return no splices if nothing changes.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "meristem/document/edit/located_tree.h"
#include "meristem/document/edit/patch.h"
#include "meristem/document/edit/tree_edit.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Sets the value at a path. Missing members on the way are added after the others; elements of lists must exist.
/// Within lists and objects only differences are rewritten.
TextPatch set_value(const LocatedTree& tree, std::string_view path, const Value& value);
/// Adds the patches to an edit.
void set_value(TreeEdit& edit, std::string_view path, const Value& value);

/// Inserts an element before the path's index, or after the last one; a missing list is added. Or adds a missing
/// member, after all others or at `index`.
TextPatch insert_value(const LocatedTree& tree, std::string_view path, const Value& value,
                       std::optional<std::size_t> index = {});

/// Removes a member or element.
TextPatch remove_value(const LocatedTree& tree, std::string_view path);

/// Renames a member. The new name must be free.
TextPatch rename_member(const LocatedTree& tree, std::string_view path, std::string_view name);

/// Moves a member or element within its object or list to `index`.
TextPatch move_value(const LocatedTree& tree, std::string_view path, std::size_t index);
/// Adds the patches to an edit.
void move_value(TreeEdit& edit, std::string_view path, std::size_t index);

}  // namespace meristem
