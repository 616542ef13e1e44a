// SPDX-License-Identifier: Apache-2.0
// Edits of a JSON text as a person would make them: comments, layout, lines' ends and all that an edit does not name
// stay as they are. What is new is written like its neighbours: in their line where they share one, on a line of its
// own and indented like them where they have theirs, and numbers with the fewest digits that say them.
//
// A member or element that goes, or moves, takes along the comments between it and the comma or bracket behind it, and,
// where it has its lines to itself, those behind the comma in its last line. Comments on lines of their own stay.
//
// Paths are whole ones (path.h), from the root. All throw an InputError for paths that lead nowhere and for values that
// JSON cannot say, and give no splices where there is nothing to change.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "meristem/document/edit/located_tree.h"
#include "meristem/document/edit/patch.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Has the path say `value`; members on the way that are not there are added behind the others, elements of lists must
/// be there. Within lists and objects only what differs is written anew.
Patch set_value(const LocatedTree& tree, std::string_view path, const Value& value);

/// Puts an element before that of the path's index (or behind the last; a list that is not there is made), or adds a
/// member that is not there yet, behind all others or so that it is number `index` among them.
Patch insert_value(const LocatedTree& tree, std::string_view path, const Value& value,
                   std::optional<std::size_t> index = {});

/// Takes out a member or element.
Patch remove_value(const LocatedTree& tree, std::string_view path);

/// Gives a member another name, which must be free.
Patch rename_member(const LocatedTree& tree, std::string_view path, std::string_view name);

/// Moves a member or element within its object or list, so that it is number `index`.
Patch move_value(const LocatedTree& tree, std::string_view path, std::size_t index);

}  // namespace meristem
