// SPDX-License-Identifier: Apache-2.0
// Paths in the tree of a text: "components.leaf.length", "links[2]". A name with dots or brackets is found unchanged,
// or can be written in quotes: profiles["22.5"]. "links[]" is the path after the last element.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/document/edit/located_tree.h"

namespace meristem {

struct PathStep {
  static constexpr std::size_t kBehindLast = static_cast<std::size_t>(-1);

  std::string name;
  std::size_t index = 0;  ///< index of an element
  bool is_index = false;
};

/// The existing and the missing steps of a path.
struct PathTarget {
  std::vector<LocatedValue> way;    ///< from the root to the last existing value
  std::vector<std::size_t> places;  ///< index of each value, except the root, in the value before it
  std::vector<PathStep> missing;    ///< steps that do not exist

  LocatedValue last() const { return way.back(); }
  /// Returns the container of the last value, which must not be the root.
  LocatedValue container() const { return way[way.size() - 2]; }
};

/// Follows a path from the root. Throws an InputError with the path if it is not well formed.
PathTarget follow_path(const LocatedTree& tree, std::string_view path);

/// Follows the path of an existing value other than the root. For any other path, throws an InputError that names the
/// nearest path.
PathTarget find_path(const LocatedTree& tree, std::string_view path);

/// Returns the value at these indices, each in the value before it.
LocatedValue value_at(const LocatedTree& tree, const std::vector<std::size_t>& places);

/// Throws the InputError for a path whose steps `target.missing` do not exist.
[[noreturn]] void throw_missing(const PathTarget& target, std::string_view path);

/// Returns the path of `name` below `path`, in the form that follow_path reads.
std::string path_below(std::string_view path, std::string_view name);

}  // namespace meristem
