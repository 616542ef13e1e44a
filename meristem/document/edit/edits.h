// SPDX-License-Identifier: Apache-2.0
// Translates an edit of a document into patches of its text.
#pragma once

#include <string>

#include "meristem/document/edit/session.h"

namespace meristem {

class TreeEdit;

/// The data, besides the text, that edits of names need.
struct EditContext {
  const std::string& file;
  const Registry& registry;
  const Document* document;  ///< last document without faults, or null
  ReadOptions reading;       ///< options for reading the text
};

/// Makes an edit. Throws an InputError if the edit is impossible.
void make_edit(const SessionEdit& edit, TreeEdit& document, const EditContext& context);

}  // namespace meristem
