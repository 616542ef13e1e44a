// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

namespace meristem {

/// A number of parts, which may have a fraction. 3.4 means four parts, and the last one has grown by 0.4.
struct PartCount {
  double value = 0;  ///< may have a fraction

  PartCount() = default;
  /// A count of `number`, which may have a fraction.
  PartCount(double number) : value(number) {}  // NOLINT(google-explicit-constructor): counts are numbers

  /// Returns the number of parts, with the last one that is still growing.
  std::uint32_t parts() const { return static_cast<std::uint32_t>(std::ceil(value)); }
  /// Returns how far the last part has grown: above 0, at most 1.
  double last() const { return value > 0 ? value - (std::ceil(value) - 1) : 1; }

  bool operator==(const PartCount&) const = default;
};

}  // namespace meristem
