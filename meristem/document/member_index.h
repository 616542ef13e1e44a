// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <unordered_map>

#include "meristem/graph/table/value.h"

namespace meristem {

/// The members of an object, each found by its name in constant time. While the index is in use, the object must get no
/// members and lose none; the values of its members may change.
class MemberIndex {
 public:
  /// Null, or a value that is no object: there are no members.
  explicit MemberIndex(const Value* object) {
    if (object == nullptr || object->object() == nullptr) return;
    members_ = object->object()->data();
    positions_.reserve(object->object()->size());
    for (const Value::Member& member : *object->object()) positions_.try_emplace(member.first, positions_.size());
  }

  /// Returns the position of a member, or nothing if there is none of that name.
  std::optional<std::size_t> position(std::string_view name) const {
    const auto found = positions_.find(name);
    return found == positions_.end() ? std::nullopt : std::optional(found->second);
  }
  /// Returns the value of a member, or null if there is none of that name.
  const Value* find(std::string_view name) const {
    const auto found = position(name);
    return found ? &members_[*found].second : nullptr;
  }

 private:
  const Value::Member* members_ = nullptr;
  std::unordered_map<std::string_view, std::size_t> positions_;
};

}  // namespace meristem
