// SPDX-License-Identifier: Apache-2.0
// Notes are comments of a document on one member. A note stands on its own lines directly above the member, or after it
// at the end of its last line. Comments with an empty line before the member, and comments within it, are not notes.
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

/// Returns the note on a part of a list or object, without comment signs. Returns an empty text if there is no note.
std::string note_on(const LocatedTree& tree, LocatedValue container, std::size_t index);

/// A piece of a text.
struct TextRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Returns the lines of a note above a part of a list or object, from the first byte of the first line to the beginning
/// of the part's own line. Returns nothing if there is no such note.
std::optional<TextRange> note_lines_above(const LocatedTree& tree, LocatedValue container, std::size_t index);

/// Returns the notes on the members of an object at the top level of the document, such as "components", by name. Takes
/// time in proportion to the size of the text. Throws Cancelled soon after `progress` was asked to stop. Null: it
/// cannot be stopped.
std::vector<std::pair<std::string, std::string>> notes_on_members(const LocatedTree& tree, std::string_view object,
                                                                  const Progress* progress = nullptr);

/// Sets the note on the member at `path`. Replaces an existing note in place; a new one stands above the member. An
/// empty note removes it. Throws an InputError for paths that lead nowhere.
TextPatch set_note(const LocatedTree& tree, std::string_view path, std::string_view note);

}  // namespace meristem
