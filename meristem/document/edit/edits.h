// SPDX-License-Identifier: Apache-2.0
// Translates an edit of a document into a patch of its text.
#pragma once

#include <string>

#include "meristem/document/edit/session.h"

namespace meristem {

class LocatedTree;

/// The data, besides the text, that edits of names need.
struct EditContext {
  const std::string& file;
  const Registry& registry;
  const Document* document;  ///< last document without faults, or null
  ReadOptions reading;       ///< options for reading the text
};

/// Returns the patch of an edit. Throws an InputError if the edit is impossible.
Patch patch_of(const Edit& edit, const LocatedTree& tree, const EditContext& context);

}  // namespace meristem
