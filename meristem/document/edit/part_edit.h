// SPDX-License-Identifier: Apache-2.0
// One member of an object or element of a list more or less, in its text.
#pragma once

#include <cstddef>
#include <string>

#include "meristem/document/edit/located_tree.h"
#include "meristem/document/edit/patch.h"

namespace meristem {

/// A part as it stood, to put it in elsewhere.
struct WrittenPart {
  std::string text;      ///< with its name
  std::string comments;  ///< that follow it in its line, in order; empty where there are none
  bool ends_in_line_comment = false;
};

struct RemovedPart {
  Patch patch;
  WrittenPart written;
};

RemovedPart remove_part(const LocatedTree& tree, LocatedValue container, std::size_t index);

/// What is put in: a value, with a name into an object; or something written.
struct NewPart {
  const std::string* name = nullptr;
  const Value* value = nullptr;
  const WrittenPart* written = nullptr;
};

/// So that it is number `index`, at most the count of parts.
Patch insert_part(const LocatedTree& tree, LocatedValue container, std::size_t index, const NewPart& part);

}  // namespace meristem
