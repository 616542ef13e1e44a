// SPDX-License-Identifier: Apache-2.0
// Elementary functions with exactly rounded operations only. Each function reduces its argument to a short interval by
// exact or compensated steps, sums a Taylor polynomial there, and undoes the reduction. Rounding errors are carried
// along if they would cost more than half a unit. Exponents are read and set in the bits. There are no tables except
// nine arc tangents, and no fused multiply-add.
//
// Based on: W. J. Cody, W. Waite: Software Manual for the Elementary Functions (1980), the reductions; T. J. Dekker: A
// floating-point technique for extending the available precision (1971), pairs of doubles.
#include "meristem/base/math.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace meristem::math {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Constants in parts. The first parts have trailing zeros, so that their products with whole numbers are exact.
constexpr double kHalfPiPart1 = 0x1.921fb544p+0;
constexpr double kHalfPiPart2 = 0x1.0b4611a6p-34;
constexpr double kHalfPiPart3 = 0x1.3198a2e037073p-69;
constexpr double kTwoPi = 0x1.921fb54442d18p+2;
constexpr double kPiHigh = 0x1.921fb54442d18p+1;
constexpr double kPiLow = 0x1.1a62633145c07p-53;
constexpr double kLn2Part1 = 0x1.62e42feep-1;
constexpr double kLn2Part2 = 0x1.a39ef35793c76p-33;

constexpr double kSqrtHalf = 0.70710678118654752440;

/// The unevaluated sum of two doubles, about 106 bits. |low| is at most half a unit of high.
struct Pair {
  double high = 0;
  double low = 0;
};

Pair sum(double a, double b) {
  const double high = a + b;
  const double b_kept = high - a;
  return {high, (a - (high - b_kept)) + (b - b_kept)};
}

Pair product(double a, double b) {
  // Halves of 26 bits multiply exactly. A fused multiply-add would do this in one step, but not on every machine.
  constexpr double kSplitter = 0x1p27 + 1;
  const double a_scaled = kSplitter * a;
  const double b_scaled = kSplitter * b;
  const double a_high = a_scaled - (a_scaled - a);
  const double b_high = b_scaled - (b_scaled - b);
  const double a_low = a - a_high;
  const double b_low = b - b_high;
  const double high = a * b;
  return {high, ((a_high * b_high - high) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

Pair operator+(Pair a, Pair b) {
  const Pair high = sum(a.high, b.high);
  return sum(high.high, high.low + (a.low + b.low));
}

Pair operator*(Pair a, Pair b) {
  const Pair high = product(a.high, b.high);
  return sum(high.high, high.low + (a.high * b.low + a.low * b.high));
}

Pair operator/(Pair a, Pair b) {
  const double quotient = a.high / b.high;
  const Pair back = product(quotient, b.high);
  const double rest = ((a.high - back.high) - back.low) + (a.low - quotient * b.low);
  return sum(quotient, rest / b.high);
}

/// Returns c[0] + c[1] x + c[2] x² + ...
template <std::size_t count>
double polynomial(double x, const double (&coefficients)[count]) {
  double value = coefficients[count - 1];
  for (std::size_t k = count - 1; k-- > 0;) value = value * x + coefficients[k];
  return value;
}

/// Returns x times 2 to the power `exponent`, for x in 2^-33 to 2^33.
double scaled(double x, int exponent) {
  if (exponent < -980 || exponent > 980) return std::ldexp(x, exponent);
  return x * std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

struct Scientific {
  double mantissa;  // in [sqrt(1/2), sqrt(2))
  int exponent;
};

/// Splits a positive finite number into mantissa and exponent, exactly.
Scientific scientific(double x) {
  int exponent = 0;
  if (x < std::numeric_limits<double>::min()) {
    x *= 0x1p54;
    exponent = -54;
  }
  const auto bits = std::bit_cast<std::uint64_t>(x);
  exponent += static_cast<int>(bits >> 52) - 1022;
  double mantissa = std::bit_cast<double>((bits & 0x000f'ffff'ffff'ffffU) | 0x3fe0'0000'0000'0000U);
  if (mantissa < kSqrtHalf) {
    mantissa *= 2;
    --exponent;
  }
  return {mantissa, exponent};
}

struct Angle {
  Pair rest;     // in about [-pi/4, pi/4]
  int quadrant;  // 0 to 3
};

/// Splits an angle into quarter turns and a rest. The rest carries its own rounding error.
Angle reduced(double radians) {
  // Beyond 2^20 quarter turns, the products below would not be exact.
  if (!(std::abs(radians) < 1.6e6)) radians = std::fmod(radians, kTwoPi);
  if (!std::isfinite(radians)) return {{kNan, 0}, 0};
  const double turns = std::floor(radians * (2 / kPiHigh) + 0.5);
  const Pair rest = sum(radians - turns * kHalfPiPart1, -turns * kHalfPiPart2);
  return {sum(rest.high, rest.low - turns * kHalfPiPart3), static_cast<int>(turns) & 3};
}

constexpr double kSinTail[] = {1.0 / 120,        -1.0 / 5040,          1.0 / 362880,         -1.0 / 39916800,
                               1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
constexpr double kCosTail[] = {1.0 / 24,        -1.0 / 720,         1.0 / 40320,         -1.0 / 3628800,
                               1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};

double sin_of_rest(Pair x) {
  const double square = x.high * x.high;
  const double cube = square * x.high;
  const double tail = polynomial(square, kSinTail);
  return x.high - ((square * (0.5 * x.low - cube * tail) - x.low) + cube * (1.0 / 6));
}

double cos_of_rest(Pair x) {
  const double square = x.high * x.high;
  const double half_square = 0.5 * square;
  const double leading = 1 - half_square;
  const double lost = (1 - leading) - half_square;
  return leading + (lost + (square * square * polynomial(square, kCosTail) - x.high * x.low));
}

double sin_of_angle(Angle angle) {
  const double value = angle.quadrant % 2 == 0 ? sin_of_rest(angle.rest) : cos_of_rest(angle.rest);
  return angle.quadrant < 2 ? value : -value;
}

/// Returns exp(x.high + x.low) for |x| < 1000.
double exp_of_pair(Pair x) {
  constexpr double kTail[] = {1.0 / 2,       1.0 / 6,        1.0 / 24,        1.0 / 120,
                              1.0 / 720,     1.0 / 5040,     1.0 / 40320,     1.0 / 362880,
                              1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
  const double doublings = std::floor(x.high * (1 / (kLn2Part1 + kLn2Part2)) + 0.5);
  const Pair rest = sum(x.high - doublings * kLn2Part1, x.low - doublings * kLn2Part2);
  const double tail = rest.high * rest.high * polynomial(rest.high, kTail);
  return scaled(1 + (rest.high + (tail + rest.low)), static_cast<int>(doublings));
}

// log(m) = 2 s + 2/3 s³ + 2/5 s^5 + ... with s = (m-1)/(m+1).
constexpr double kLogTail[] = {2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11, 2.0 / 13,
                               2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21, 2.0 / 23};

/// Returns the natural logarithm of a positive finite number to about 63 bits, as pow needs it.
Pair log_as_pair(double x) {
  constexpr Pair kTwoThirds{0x1.5555555555555p-1, 0x1.5555555555555p-55};
  const auto [mantissa, exponent] = scientific(x);
  const double above_one = mantissa - 1;
  const Pair s = Pair{above_one, 0} / sum(2, above_one);
  const Pair square = s * s;
  const Pair tail = s * (square * (kTwoThirds + Pair{square.high * polynomial(square.high, kLogTail), 0}));
  const Pair of_mantissa = Pair{2 * s.high, 2 * s.low} + tail;
  return sum(exponent * kLn2Part1, exponent * kLn2Part2) + of_mantissa;
}

/// Returns x to a whole power from -64 to 64. The result is exact if it fits into a double: x² is x*x.
double whole_power(double x, int power) {
  const auto [mantissa, exponent] = scientific(x);
  Pair result{1, 0};
  Pair square{mantissa, 0};
  for (int rest = std::abs(power); rest > 0; rest /= 2) {
    if (rest % 2 == 1) result = result * square;
    square = square * square;
  }
  if (power < 0) result = Pair{1, 0} / result;
  return scaled(result.high, exponent * power);
}

/// Returns x to the power y for positive finite x and finite y.
double power_of_positive(double x, double y) {
  if (y == 0.5) return std::sqrt(x);
  if (std::abs(y) <= 64 && std::floor(y) == y) return whole_power(x, static_cast<int>(y));
  const Pair logarithm = log_as_pair(x);
  const double estimate = y * logarithm.high;
  if (estimate > 720) return kInfinity;
  if (estimate < -760) return 0;
  const Pair exact = product(y, logarithm.high);
  return exp_of_pair(sum(exact.high, exact.low + y * logarithm.low));
}

/// Returns atan of a number in [0, 1], from the nearest of atan(0), atan(1/8), ... atan(1).
double atan_of_fraction(double x) {
  constexpr Pair kAtanOfEighths[] = {{0, 0},
                                     {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                     {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                     {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                     {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                     {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                     {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                     {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                     {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};
  constexpr double kTail[] = {-1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11, 1.0 / 13};
  const auto eighths = static_cast<std::size_t>(8 * x + 0.5);
  const double near = static_cast<double>(eighths) / 8;
  const double rest = (x - near) / (1 + x * near);
  const double square = rest * rest;
  const Pair base = kAtanOfEighths[eighths];
  return base.high + (rest + (rest * square * polynomial(square, kTail) + base.low));
}

}  // namespace

double sin(double radians) {
  if (std::abs(radians) < 0x1p-27) return radians;
  return sin_of_angle(reduced(radians));
}

double cos(double radians) {
  Angle angle = reduced(radians);
  angle.quadrant = (angle.quadrant + 1) & 3;
  return sin_of_angle(angle);
}

double tan(double radians) {
  if (std::abs(radians) < 0x1p-27) return radians;
  const Angle angle = reduced(radians);
  const double sine = sin_of_rest(angle.rest);
  const double cosine = cos_of_rest(angle.rest);
  return angle.quadrant % 2 == 0 ? sine / cosine : -cosine / sine;
}

double asin(double sine) {
  if (std::abs(sine) >= 1) return std::copysign(kPiHigh / 2, sine);
  return atan2(sine, std::sqrt((1 - sine) * (1 + sine)));
}

double acos(double cosine) {
  if (cosine >= 1) return 0;
  if (cosine <= -1) return kPiHigh;
  return atan2(std::sqrt((1 - cosine) * (1 + cosine)), cosine);
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNan;
  if (y == 0) return x < 0 ? kPiHigh : y;
  const double width = std::abs(x);
  const double height = std::abs(y);
  const bool is_steep = height > width;
  const double fraction = width == height ? 1 : is_steep ? width / height : height / width;
  double angle = atan_of_fraction(fraction);
  if (is_steep) angle = kPiHigh / 2 - (angle - kPiLow / 2);
  if (x < 0) angle = kPiHigh - (angle - kPiLow);
  return y < 0 ? -angle : angle;
}

double exp(double x) {
  if (std::isnan(x)) return x;
  if (x > 720) return kInfinity;
  if (x < -760) return 0;
  return exp_of_pair({x, 0});
}

double log(double x) {
  if (x == 0) return -kInfinity;
  if (!(x > 0)) return kNan;
  if (x == kInfinity) return x;
  const auto [mantissa, exponent] = scientific(x);
  const double above_one = mantissa - 1;
  const double s = above_one / (2 + above_one);
  const double square = s * s;
  const double tail = square * (2.0 / 3 + square * polynomial(square, kLogTail));
  // log(1+f) = f - (f²/2 - s (f²/2 + tail)). The large terms f and f²/2 are nearly exact, and the rounded term is
  // small.
  const double half_square = 0.5 * above_one * above_one;
  const double correction = s * (half_square + tail) + exponent * kLn2Part2;
  return exponent * kLn2Part1 - ((half_square - correction) - above_one);
}

double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (std::isnan(x) || std::isnan(y)) return kNan;
  const bool is_whole = std::floor(y) == y;
  const bool is_odd = is_whole && std::isfinite(y) && std::fmod(y, 2) != 0;
  const double sign = std::signbit(x) && is_odd ? -1 : 1;
  const double size = std::abs(x);
  if (std::isinf(y)) return size == 1 ? 1 : (size > 1) == (y > 0) ? kInfinity : 0;
  if (size == 0) return y > 0 ? sign * 0 : sign * kInfinity;
  if (size == kInfinity) return y > 0 ? sign * kInfinity : sign * 0;
  if (x < 0 && !is_whole) return kNan;
  return sign * power_of_positive(size, y);
}

}  // namespace meristem::math
