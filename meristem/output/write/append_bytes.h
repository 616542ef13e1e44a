// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstring>
#include <string>

#include "meristem/output/write/finite.h"

namespace meristem {

static_assert(std::endian::native == std::endian::little, "records are written as they lie in memory");

/// Appends the bytes of a number or of an array of numbers, little-endian. Throws an InputError if a number is not
/// finite.
template <class Value>
void append_bytes(std::string& out, const Value& value) {
  require_finite_value(value);
  std::array<char, sizeof(Value)> bytes;
  std::memcpy(bytes.data(), &value, sizeof(Value));
  out.append(bytes.data(), bytes.size());
}

}  // namespace meristem
