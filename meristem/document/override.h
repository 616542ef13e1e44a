// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "meristem/document/document.h"
#include "meristem/graph/component.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// Splits "links[1].density" into "links", "[1]", "density". Returns an empty list if the path is not well formed.
std::vector<std::string> path_elements(const std::string& path);
/// Returns the full path in this document of a well-formed path from `--set`.
std::string full_path(const Value& root, const std::string& path);
/// Returns the value at a full path. Adds it if it is a member that may be added. Otherwise reports a fault at `place`
/// and returns null.
Value* find_or_add(Value& root, const std::string& path, const std::string& place,
                   std::vector<Diagnostic>& diagnostics);

/// Like find_or_add(), for the rest of a path below `value`. `elements` are the remaining elements of the path.
Value* find_or_add_below(Value& value, std::span<const std::string> elements, const std::string& place,
                         std::vector<Diagnostic>& diagnostics);

/// Puts the values into the tree and their paths into `source`. Reports a fault for each path that leads nowhere. A
/// path without a dot or bracket is a variable. A path that begins with a top-level key is used unchanged. Any other
/// path begins with a component's id. Missing members are added (the reader checks them), but elements of lists must
/// exist. Null removes a member. Short forms along a path are written out with the tables of `registry`. Null: they are
/// left as they are.
void apply_overrides(Value& root, const std::vector<ValueOverride>& overrides, DocumentOrigin& source,
                     std::vector<Diagnostic>& diagnostics, const Registry* registry = nullptr);

/// Removes values from the tree that have no effect beside the values set at `overridden` paths of the same component,
/// link or top-level key. Returns true if anything was removed.
bool give_way(Value& root, const std::vector<ParameterReader::Meaningless>& meaningless,
              const std::vector<std::string>& overridden);

}  // namespace meristem
