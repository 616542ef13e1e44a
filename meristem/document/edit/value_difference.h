// SPDX-License-Identifier: Apache-2.0
// How one value differs from another in the parts that lists and objects have.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "meristem/document/edit/located_tree.h"

namespace meristem {

/// Whether both are lists of one length, or objects with the same names in the same order.
bool have_same_parts(const Value& one, const Value& other);

/// A part that one has and the other has not.
struct PartDifference {
  LocatedValue container;             ///< in the old tree
  std::size_t index = 0;              ///< in it: of the part that goes, or that the added one will have
  const std::string* name = nullptr;  ///< of the added member
  const Value* added = nullptr;       ///< null where the part goes
};

/// The first step, a part more or less, on the way from an old value to a new one. Nothing where all lists and objects
/// have the same parts already, or are others altogether: other kinds of value, or members in another order.
std::optional<PartDifference> first_part_difference(const LocatedTree& tree, LocatedValue old, const Value& value);

}  // namespace meristem
