// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "meristem/document/document.h"

namespace meristem {

/// Puts the values into the tree and their paths into `source`; adds a fault for each path that leads nowhere. A path
/// without a dot or bracket is a variable; one that begins with a top-level key is taken as it stands; others begin
/// with a component's id. Members that are not there yet are added (the reader checks them), elements of lists must
/// exist.
void apply_overrides(Value& root, const std::vector<Override>& overrides, Source& source,
                     std::vector<Diagnostic>& diagnostics);

}  // namespace meristem
