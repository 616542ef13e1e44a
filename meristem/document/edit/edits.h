// SPDX-License-Identifier: Apache-2.0
// From an edit of a document to the patch of its text.
#pragma once

#include <string>

#include "meristem/document/edit/session.h"

namespace meristem {

class LocatedTree;

/// What edits of names need to know besides the text.
struct EditContext {
  const std::string& file;
  const Registry& registry;
  const Document* document;  ///< the last without faults, or null
  ReadOptions reading;       ///< how the text is read
};

/// Throws an InputError where the edit cannot be made.
Patch patch_of(const Edit& edit, const LocatedTree& tree, const EditContext& context);

}  // namespace meristem
