// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace meristem {

/// A list of names that finds a name in constant time.
class NameTable {
 public:
  NameTable() = default;
  /// Builds a table of `names`, in their order.
  explicit NameTable(std::span<const std::string> names) { add(names); }

  /// Appends a name. A name that exists already keeps its first position.
  void add(const std::string& name) {
    positions_.try_emplace(name, names_.size());
    names_.push_back(name);
  }
  void add(std::span<const std::string> names) {
    for (const std::string& name : names) add(name);
  }

  /// Returns all names, in the order in which they were added.
  const std::vector<std::string>& names() const { return names_; }
  std::size_t size() const { return names_.size(); }  ///< number of names

  /// Returns the first position of a name, or nothing if the name does not exist.
  std::optional<std::size_t> find(std::string_view name) const {
    const auto found = positions_.find(name);
    return found == positions_.end() ? std::nullopt : std::optional(found->second);
  }
  /// Returns true if the name exists.
  bool contains(std::string_view name) const { return positions_.contains(name); }

 private:
  /// Hashes texts of all types alike, so that a lookup copies no text.
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const { return std::hash<std::string_view>()(name); }
  };

  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t, Hash, std::equal_to<>> positions_;
};

}  // namespace meristem
