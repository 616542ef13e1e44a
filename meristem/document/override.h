// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "meristem/document/document.h"

namespace meristem {

/// What came of applying overrides to a document's tree.
struct AppliedOverrides {
  std::vector<Diagnostic> diagnostics;  ///< paths that lead nowhere
  std::vector<std::string> paths;       ///< in the document, as diagnostics name them

  /// Gives a diagnostic its file: the option's text where an override brought the value, else `file`.
  void place(Diagnostic& diagnostic, const std::string& file) const;

 private:
  friend AppliedOverrides apply_overrides(Value& root, const std::vector<Override>& overrides);
  std::vector<std::string> options_;  // as the user wrote them, without the value
};

/// Puts the values into the tree. A path without a dot or bracket is a variable; one that begins with a top-level key
/// is taken as it stands; others begin with a component's id. Members that are not there yet are added, elements of
/// lists must exist.
AppliedOverrides apply_overrides(Value& root, const std::vector<Override>& overrides);

}  // namespace meristem
