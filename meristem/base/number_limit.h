// SPDX-License-Identifier: Apache-2.0
// Limits of numbers in files. All readers of files check their numbers with them, so that no file puts an infinity or a
// NaN into a plant.
#pragma once

#include <string>
#include <string_view>

#include "meristem/base/diagnostic.h"

namespace meristem {

/// The range of a number from a file.
struct NumberLimit {
  double min = 0;
  double max = 0;
  std::string_view noun;  ///< name of such a number in messages, with its article: "a coordinate"

  /// Returns true if the value is in the range. Returns false for NaN and infinities.
  bool holds(double value) const { return value >= min && value <= max; }
  /// Returns a text such as "a coordinate from -1e+12 to 1e+12".
  std::string expected() const;
};

/// Any number that fits into a 32-bit float, the type in which plants store it.
inline constexpr NumberLimit kFileNumber{-3.4e38, 3.4e38, "a number"};
/// A coordinate in the units of its file: map coordinates (up to 1e7 m) in hundredths of a millimetre.
inline constexpr NumberLimit kFileCoordinate{-1e12, 1e12, "a coordinate"};
/// A radius or diameter in the units of its file: kMaxRadius in micrometres.
inline constexpr NumberLimit kFileRadius{0, 1e9, "a radius or diameter"};

/// Largest coordinate of a plant or obstacle, metres from the origin. Floats still resolve a decimetre at this
/// distance.
inline constexpr double kMaxCoordinate = 1e6;
/// Largest radius of a stem, metres: 50 times the radius of the thickest known tree.
inline constexpr double kMaxRadius = 1e3;

/// Returns the error for a number outside its limit, without a place. `what` names the number: "the radius 1e+308".
Diagnostic number_error(std::string_view what, const NumberLimit& limit);

}  // namespace meristem
