// SPDX-License-Identifier: Apache-2.0
// Notes: the comments of a document that speak of one member, as people write them. A note stands on lines of its own
// directly above the member, or behind it at the end of its last line. Comments with an empty line between them and the
// member, and comments within it, are no notes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "meristem/document/edit/located_tree.h"
#include "meristem/document/edit/patch.h"

namespace meristem {

/// The note on a part of a list or object, without the signs that make it a comment; empty where there is none.
std::string note_on(const LocatedTree& tree, LocatedValue container, std::size_t index);

/// A piece of a text.
struct TextRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The lines above a part of a list or object that are a note on it, from the first byte of the first line to that of
/// the part's own; nothing where no note stands there.
std::optional<TextRange> note_lines_above(const LocatedTree& tree, LocatedValue container, std::size_t index);

/// The notes on the members of an object at the top of the document, such as "components", by name. Takes time by the
/// size of the text. Throws Cancelled soon after `progress` was asked to stop; null: it cannot be stopped.
std::vector<std::pair<std::string, std::string>> notes_on_members(const LocatedTree& tree, std::string_view object,
                                                                  const Progress* progress = nullptr);

/// Has the note on the member at `path` say `note`: where one stands, or else above the member; an empty one goes.
/// Throws an InputError for paths that lead nowhere.
Patch set_note(const LocatedTree& tree, std::string_view path, std::string_view note);

}  // namespace meristem
