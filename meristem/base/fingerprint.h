// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "meristem/base/hash.h"

namespace meristem {

/// Hash of a sequence of numbers, texts and arrays. A cache finds a result by the fingerprint of everything that the
/// result depends on. Sequences of different lengths have different hashes.
class Fingerprint {
 public:
  /// Appends a number or a value of an enumeration, by the bytes of its type.
  template <class Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number> Fingerprint& add(Number number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof(number));
    return *this;
  }
  /// Appends a text with its length.
  Fingerprint& add_text(std::string_view text) {
    add(text.size());
    bytes_.append(text);
    return *this;
  }
  /// Appends an array. Its elements must have no gaps between their bytes.
  template <class Element>
  Fingerprint& add_array(const std::vector<Element>& elements) {
    const std::size_t bytes = elements.size() * sizeof(Element);
    return add(elements.size()).add(hash64(std::string_view(reinterpret_cast<const char*>(elements.data()), bytes)));
  }

  /// Returns the hash of everything that was added.
  std::uint64_t hash() const { return hash64(bytes_); }

 private:
  std::string bytes_;
};

}  // namespace meristem
