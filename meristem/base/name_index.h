// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "meristem/base/hash.h"

namespace meristem {

/// Finds names of a list that is stored elsewhere. A name takes 16 bytes in one piece of memory, so that tables of a
/// million names stay in the processor's cache. `name_at(position)` returns a name of the list.
class NameIndex {
 public:
  /// Makes an index for up to `count` names, which must be less than 2^31.
  explicit NameIndex(std::size_t count = 0) {
    std::size_t slots = 4;
    while (slots < 2 * count) slots *= 2;
    slots_.resize(slots);
  }

  /// Enters the name at a position of the list. If an equal name was entered before, enters nothing and returns the
  /// position of that name.
  template <class NameAt>
  std::optional<std::size_t> enter(std::string_view name, std::size_t position, NameAt name_at) {
    Slot& slot = slots_[place_of(name, name_at)];
    if (slot.position != 0) return slot.position - 1;
    slot = {hash_of(name), static_cast<std::uint32_t>(position + 1)};
    return std::nullopt;
  }

  /// Returns the position of a name, or nothing if it was not entered.
  template <class NameAt>
  std::optional<std::size_t> find(std::string_view name, NameAt name_at) const {
    const Slot& slot = slots_[place_of(name, name_at)];
    return slot.position != 0 ? std::optional<std::size_t>(slot.position - 1) : std::nullopt;
  }

 private:
  struct Slot {
    std::uint32_t hash = 0;
    std::uint32_t position = 0;  // from 1; 0: the slot is empty
  };

  static std::uint32_t hash_of(std::string_view name) { return static_cast<std::uint32_t>(hash64(name)); }

  /// Returns the slot of the name, or the empty slot in which it would stand. At least half of all slots are empty.
  template <class NameAt>
  std::size_t place_of(std::string_view name, NameAt name_at) const {
    const std::uint32_t hash = hash_of(name);
    std::size_t at = hash & (slots_.size() - 1);
    while (slots_[at].position != 0 && (slots_[at].hash != hash || name_at(slots_[at].position - 1) != name)) {
      at = (at + 1) & (slots_.size() - 1);
    }
    return at;
  }

  std::vector<Slot> slots_;
};

}  // namespace meristem
