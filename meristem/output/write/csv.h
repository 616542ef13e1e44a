// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "meristem/output/write/finite.h"

namespace meristem {

inline constexpr std::size_t kCsvNumberBytes = 24;  ///< that a number and the comma after it take at most

/// A text as one field of a table in CSV: in quotes where it holds what would end the field.
std::string csv_field(const std::string& text);

/// Appends a number with the digits that give the same one when read. Throws an InputError if it is not finite.
template <class Number>
void append_csv_number(Number value, std::string& out) {
  require_finite_value(value);
  std::array<char, kCsvNumberBytes> digits;
  const char* const end = fmt::format_to(digits.data(), FMT_COMPILE("{}"), value);
  out.append(digits.data(), static_cast<std::size_t>(end - digits.data()));
}

}  // namespace meristem
