// SPDX-License-Identifier: Apache-2.0
// Short forms of objects: a bare value in place of an object with one member, as in "points": 300 for {"count": 300}.
#pragma once

#include <string>
#include <vector>

#include "meristem/graph/component.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Writes out all short forms along a path, so that it leads to a member: "points": 300 becomes "points": {"count":
/// 300} for the path of "tree.points.count". `elements` is a full path, as path_elements() returns it. The meaning of
/// the document stays. Does nothing if the path leads to no parameter.
void write_out_short_forms(Value& root, const Registry& registry, const std::vector<std::string>& elements);

}  // namespace meristem
