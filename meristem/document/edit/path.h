// SPDX-License-Identifier: Apache-2.0
// Paths in the tree of a text: "components.leaf.length", "links[2]". A name that has dots or brackets in it is found as
// it stands, and can be written in quotes: profiles["22.5"]. "links[]" is the path behind the last element.
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
  std::size_t index = 0;  ///< of an element
  bool is_index = false;
};

/// How far a path leads.
struct PathTarget {
  std::vector<LocatedValue> way;    ///< from the root to the last value that is there
  std::vector<std::size_t> places;  ///< of each but the root in the one before
  std::vector<PathStep> missing;    ///< steps that lead to nothing that is there

  LocatedValue last() const { return way.back(); }
  LocatedValue container() const { return way[way.size() - 2]; }  ///< of the last, which is not the root
};

/// Follows a path from the root; throws an InputError with the path where it is not well formed.
PathTarget follow_path(const LocatedTree& tree, std::string_view path);

/// Follows the path of something that is there, other than the root. Throws an InputError that names the nearest path
/// for all others.
PathTarget find_path(const LocatedTree& tree, std::string_view path);

/// What the paths lead to, each in the one before.
LocatedValue value_at(const LocatedTree& tree, const std::vector<std::size_t>& places);

/// Throws the InputError for a path that ends in `target.missing`.
[[noreturn]] void throw_missing(const PathTarget& target, std::string_view path);

/// A path of `name` below `path` that follow_path reads as such.
std::string path_below(std::string_view path, std::string_view name);

}  // namespace meristem
