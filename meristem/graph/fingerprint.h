// SPDX-License-Identifier: Apache-2.0
// Hashes by which results are found again: of all that they depend on.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "meristem/base/expression.h"
#include "meristem/graph/value.h"

namespace meristem {

/// Hash of a sequence of numbers, texts and values. Equal for equal sequences; sequences of other lengths differ.
class Fingerprint {
 public:
  template <class Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number> Fingerprint& add(Number number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof(number));
    return *this;
  }
  Fingerprint& add_text(std::string_view text);
  Fingerprint& add_value(const Value& value);

  std::uint64_t hash() const;

 private:
  std::string bytes_;
};

/// Of what a document says in one place: the value, the constants whose names occur in its texts, and what stands in
/// the `files` that were read with it; where there are such, all constants. Nothing where a file is none to be read
/// twice, such as a pipe.
std::optional<std::uint64_t> fingerprint_of(const Value& value, std::span<const ExpressionNames::Constant> constants,
                                            std::span<const std::string> files, std::uint64_t file_bytes);

}  // namespace meristem
