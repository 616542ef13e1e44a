// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

namespace meristem {

/// A number of parts that may have a fraction: of 3.4 there are four, of which the last has come to be by 0.4.
struct Count {
  double value = 0;  ///< may have a fraction

  Count() = default;
  /// A count of `number`, which may have a fraction.
  Count(double number) : value(number) {}  // NOLINT(google-explicit-constructor): counts are numbers

  /// How many there are, with the one that is coming to be.
  std::uint32_t parts() const { return static_cast<std::uint32_t>(std::ceil(value)); }
  /// How far the last one has come to be: above 0, at most 1.
  double last() const { return value > 0 ? value - (std::ceil(value) - 1) : 1; }

  bool operator==(const Count&) const = default;
};

}  // namespace meristem
