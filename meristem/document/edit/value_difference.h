// SPDX-License-Identifier: Apache-2.0
// Differences between two values in the parts of their lists and objects.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "meristem/document/edit/located_tree.h"

namespace meristem {

/// Returns true if both are lists of equal length, or objects with equal names in equal order.
bool have_same_parts(const Value& one, const Value& other);

/// A part that only one of two values has.
struct PartDifference {
  LocatedValue container;             ///< in the old tree
  std::size_t index = 0;              ///< index of the removed or added part
  const std::string* name = nullptr;  ///< name of the added member
  const Value* added = nullptr;       ///< null if the part is removed
};

/// Returns the first step from an old value to a new one: one part to add or remove. Returns nothing if all lists and
/// objects have equal parts, or if they differ entirely: other kinds of value, or members in another order.
std::optional<PartDifference> first_part_difference(const LocatedTree& tree, LocatedValue old, const Value& value);

}  // namespace meristem
