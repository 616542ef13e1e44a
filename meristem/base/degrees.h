// SPDX-License-Identifier: Apache-2.0
// Sine, cosine and tangent of angles in degrees, without a conversion to radians first. A whole number of half turns is
// subtracted exactly, so sin_deg(180 k) is 0, cos_deg(90 + 180 k) is 0, and sin_deg(30) is 0.5 to the last bit. All
// operations are rounded exactly by IEEE 754, so every machine gets equal bits. The functions for loops have no
// branches or calls, so that compilers can run several lanes at once.
//
// Errors stay below 3 units in the last place. Coefficients: minimax on [0, 90°] by Remez' exchange, relative error
// 2.8e-19. The test compares them with higher precision.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace meristem::math {

/// Largest angle for which `near_sin_deg` and `near_cos_deg` are exact enough. Larger angles first go through
/// `std::fmod(x, 360)`, which is exact.
constexpr double kNearDegrees = 0x1p40;

namespace degrees_detail {

/// Adding this number leaves the nearest whole number in the low bits of a double.
constexpr double kRounder = 0x1.8p52;

/// Returns the sine of an angle in [-90, 90] degrees.
inline double quarter_sin_deg(double x) {
  // pi/180 in two parts. The first part has so few bits that products with everyday angles are exact.
  const double high = x * 0x1.1df46a2p-6;
  const double low = x * 0x1.4a74e4570763p-36;
  const double s = high + low;
  const double z = s * s;
  double p = 0x1.8829a3e767ccap-49;
  p = p * z - 0x1.ae431da16cc58p-41;
  p = p * z + 0x1.6123cb29249c6p-33;
  p = p * z - 0x1.ae6454cb57c54p-26;
  p = p * z + 0x1.71de3a5287c82p-19;
  p = p * z - 0x1.a01a01a0148bcp-13;
  p = p * z + 0x1.11111111110c1p-7;
  p = p * z - 0x1.5555555555555p-3;
  return high + (low + s * z * p);
}

}  // namespace degrees_detail

/// Returns the sine of an angle in degrees. Its absolute value must be at most kNearDegrees.
inline double near_sin_deg(double x) {
  // Subtract half turns. An odd number of half turns changes the sign.
  const double shifted = x * (1.0 / 180) + degrees_detail::kRounder;
  const double sine = degrees_detail::quarter_sin_deg(x - 180 * (shifted - degrees_detail::kRounder));
  const std::uint64_t sign = std::bit_cast<std::uint64_t>(shifted) << 63;
  // Adding zero makes a negative zero positive.
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(sine) ^ sign) + 0.0;
}

/// Returns the cosine of an angle in degrees. Its absolute value must be at most kNearDegrees.
inline double near_cos_deg(double x) {
  const double turns = (x * (1.0 / 360) + degrees_detail::kRounder) - degrees_detail::kRounder;
  return degrees_detail::quarter_sin_deg(90 - std::abs(x - 360 * turns));
}

/// Removes whole turns if an angle is too large for the functions above. Returns NaN for an infinity.
inline double near_degrees(double x) { return std::abs(x) <= kNearDegrees ? x : std::fmod(x, 360.0); }

/// Returns the sine of an angle in degrees, or NaN for an infinity.
inline double sin_deg(double degrees) { return near_sin_deg(near_degrees(degrees)); }
/// Returns the cosine of an angle in degrees, or NaN for an infinity.
inline double cos_deg(double degrees) { return near_cos_deg(near_degrees(degrees)); }
/// Returns the tangent of an angle in degrees, or NaN for an infinity. At odd multiples of 90, returns an infinity with
/// the sign of the sine.
inline double tan_deg(double degrees) { return sin_deg(degrees) / cos_deg(degrees); }

}  // namespace meristem::math
