// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "meristem/document/document.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// Puts the values into the tree and their paths into `source`; adds a fault for each path that leads nowhere. A path
/// without a dot or bracket is a variable; one that begins with a top-level key is taken as it stands; others begin
/// with a component's id. Members that are not there yet are added (the reader checks them), elements of lists must
/// exist. Null takes a member away.
void apply_overrides(Value& root, const std::vector<Override>& overrides, Source& source,
                     std::vector<Diagnostic>& diagnostics);

/// Takes out of the tree what the document says and what means nothing beside what is set at `overridden` paths of the
/// same component, link or top-level key. Returns whether there was anything.
bool give_way(Value& root, const std::vector<ParameterReader::Meaningless>& meaningless,
              const std::vector<std::string>& overridden);

}  // namespace meristem
