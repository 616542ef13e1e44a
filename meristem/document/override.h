// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "meristem/document/document.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// "links[1].density" -> "links", "[1]", "density"; empty where the path is not well formed.
std::vector<std::string> path_elements(const std::string& path);
/// The full path of what a well-formed path as `--set` takes it means in this document.
std::string full_path(const Value& root, const std::string& path);
/// The value at a full path, made where it is a member that may be added; null with a fault at `place` otherwise.
Value* find_or_add(Value& root, const std::string& path, const std::string& place,
                   std::vector<Diagnostic>& diagnostics);

/// The same for the rest of a path, below a value that it leads to: `elements` are those from there on.
Value* find_or_add_below(Value& value, std::span<const std::string> elements, const std::string& place,
                         std::vector<Diagnostic>& diagnostics);

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
