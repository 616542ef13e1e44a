// SPDX-License-Identifier: Apache-2.0
// Inserts or removes one member of an object or one element of a list, in its text.
#pragma once

#include <cstddef>
#include <string>

#include "meristem/document/edit/located_tree.h"
#include "meristem/document/edit/patch.h"

namespace meristem {

/// A part as it was written, for inserting it elsewhere.
struct WrittenPart {
  std::string text;      ///< with its name
  std::string comments;  ///< comments that follow it in its line, in order; may be empty
  bool ends_in_line_comment = false;
};

struct RemovedPart {
  TextPatch patch;
  WrittenPart written;
};

RemovedPart remove_part(const LocatedTree& tree, LocatedValue container, std::size_t index);

/// A part to insert: a value, with a name if it is for an object, or a written part.
struct NewPart {
  const std::string* name = nullptr;
  const Value* value = nullptr;
  const WrittenPart* written = nullptr;
};

/// Inserts a part at `index`, which is at most the number of parts.
TextPatch insert_part(const LocatedTree& tree, LocatedValue container, std::size_t index, const NewPart& part);

}  // namespace meristem
