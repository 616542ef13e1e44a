// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <unordered_map>

#include "meristem/graph/table/value.h"

namespace meristem {

/// Finds the members of an object by name in constant time. While the index is in use, no member may be added to or
/// removed from the object; values may change.
class MemberIndex {
 public:
  /// `object` may be null or no object: the index is then empty.
  explicit MemberIndex(const Value* object) {
    if (object == nullptr || object->object() == nullptr) return;
    members_ = object->object()->data();
    positions_.reserve(object->object()->size());
    for (const Value::Member& member : *object->object()) positions_.try_emplace(member.first, positions_.size());
  }

  /// Returns the position of a member, or nothing if no member has that name.
  std::optional<std::size_t> position(std::string_view name) const {
    const auto found = positions_.find(name);
    return found == positions_.end() ? std::nullopt : std::optional(found->second);
  }
  /// Returns the value of a member, or null if no member has that name.
  const Value* find(std::string_view name) const {
    const auto found = position(name);
    return found ? &members_[*found].second : nullptr;
  }

 private:
  const Value::Member* members_ = nullptr;
  std::unordered_map<std::string_view, std::size_t> positions_;
};

}  // namespace meristem
