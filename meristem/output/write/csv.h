// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "meristem/output/write/finite.h"

namespace meristem {

inline constexpr std::size_t kCsvNumberBytes = 24;  ///< maximum size of a number and the comma after it, bytes

/// Returns a text as one field of a CSV table, in quotes if it contains characters that end a field.
std::string csv_field(const std::string& text);

/// Appends a number with enough digits to restore it exactly. Throws an InputError if it is not finite.
template <class Number>
void append_csv_number(Number value, std::string& out) {
  require_finite_value(value);
  std::array<char, kCsvNumberBytes> digits;
  const char* const end = fmt::format_to(digits.data(), FMT_COMPILE("{}"), value);
  out.append(digits.data(), static_cast<std::size_t>(end - digits.data()));
}

}  // namespace meristem
