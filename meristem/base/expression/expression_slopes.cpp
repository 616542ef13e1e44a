// SPDX-License-Identifier: Apache-2.0
// Derivatives of all operations. They are exact except for noise, which uses symmetric differences that are exact to
// about 1e-8. At kinks (abs, min, clamp, the branches of ?:) the derivative is that of the side on which the value was
// taken. At steps (floor, comparisons) the derivative is 0.
#include "meristem/base/expression/expression_slopes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "meristem/base/degrees.h"
#include "meristem/base/math.h"

namespace meristem {

namespace {

using Op = ExpressionOp;

constexpr double kRadian = kPi / 180;  // radians per degree
constexpr double kStep = 0x1p-17;      // step of the symmetric differences of noise to either side

using Operands = std::array<double, 3>;

/// Returns a derivative times a slope. Returns 0 if the derivative is 0, whatever the slope, because 0 times infinity
/// would be NaN.
double times(double derivative, double slope) { return derivative == 0 ? 0 : derivative * slope; }

Operands of_noise(Op op, const Operands& at) {
  const std::size_t count = operand_count(op);
  Operands derivatives{};
  for (std::size_t k = 0; k < count; ++k) {
    Operands above = at, below = at;
    above[k] += kStep;
    below[k] -= kStep;
    const double rise = fold(op, std::span(above).first(count)) - fold(op, std::span(below).first(count));
    derivatives[k] = rise / (2 * kStep);
  }
  return derivatives;
}

Operands of_drawing(const ExpressionInstruction& i, RandomKey key) {
  switch (i.op) {
    case Op::uniform_below:
      return {key.uniform(i.place, 0, 1)};
    case Op::uniform_between: {
      const double share = key.uniform(i.place, 0.0, 1.0);
      return {1 - share, share};
    }
    case Op::gauss:
      return {1, key.normal(i.place)};
    default:
      return {};
  }
}

double of_arc(double x) { return std::abs(x) <= 1 ? 1 / (kRadian * std::sqrt(1 - x * x)) : 0; }

Operands of_unary(Op op, double x, double result) {
  switch (op) {
    case Op::negate:
      return {-1};
    case Op::sine:
      return {math::cos_deg(x) * kRadian};
    case Op::cosine:
      return {-math::sin_deg(x) * kRadian};
    case Op::tangent:
      return {(1 + result * result) * kRadian};
    case Op::arc_sine:
      return {of_arc(x)};
    case Op::arc_cosine:
      return {-of_arc(x)};
    case Op::arc_tangent:
      return {1 / (kRadian * (1 + x * x))};
    case Op::square_root:
      return {0.5 / result};
    case Op::cube_root:
      return {1 / (3 * result * result)};
    case Op::exponential:
      return {result};
    case Op::logarithm:
      return {1 / x};
    case Op::logarithm_2:
      return {1.4426950408889634 / x};
    case Op::logarithm_10:
      return {0.43429448190325182 / x};
    case Op::absolute:
      return {x < 0 ? -1.0 : 1.0};
    case Op::fraction:
      return {1};
    default:  // steps
      return {};
  }
}

Operands of_power(double base, double exponent, double result, bool is_by_exponent) {
  double by_base = 0;
  if (exponent != 0) by_base = exponent * (base != 0 ? result / base : math::pow(base, exponent - 1));
  return {by_base, is_by_exponent && base > 0 ? result * math::log(base) : 0};
}

Operands of_arc_tangent_2(double y, double x) {
  const double square = (x * x + y * y) * kRadian;
  return square > 0 ? Operands{x / square, -y / square} : Operands{};
}

Operands of_binary(Op op, double x, double y, double result, bool is_by_second) {
  switch (op) {
    case Op::divide:
      return {1 / y, -result / y};
    case Op::modulo:
      return {1, -std::floor(x / y)};
    case Op::power:
      return of_power(x, y, result, is_by_second);
    case Op::arc_tangent_2:
      return of_arc_tangent_2(x, y);
    case Op::minimum:
      return y < x ? Operands{0, 1} : Operands{1, 0};
    case Op::maximum:
      return y > x ? Operands{0, 1} : Operands{1, 0};
    default:  // steps and comparisons
      return {};
  }
}

Operands of_smooth_step(double from, double to, double x) {
  if (from == to) return {};
  const double t = (x - from) / (to - from);
  if (!(t > 0 && t < 1)) return {};
  const double slope = 6 * t * (1 - t) / (to - from);
  return {slope * (t - 1), -slope * t, slope};
}

Operands of_ternary(Op op, const Operands& in) {
  switch (op) {
    case Op::select:
      return in[0] != 0 ? Operands{0, 1, 0} : Operands{0, 0, 1};
    case Op::clamp: {
      const double above = in[0] < in[1] ? in[1] : in[0];
      if (above > in[2]) return {0, 0, 1};
      return in[0] < in[1] ? Operands{0, 1, 0} : Operands{1, 0, 0};
    }
    case Op::interpolate:
      return {1 - in[2], in[2], in[1] - in[0]};
    default:
      return of_smooth_step(in[0], in[1], in[2]);
  }
}

bool is_noise(Op op) { return op == Op::noise_1 || op == Op::noise_2 || op == Op::noise_3; }

/// Returns the derivatives of an operation in its operands at `in`, where `result` is its value. The derivative in the
/// second operand is computed only on request.
Operands derivatives_of(const ExpressionInstruction& i, const Operands& in, double result, RandomKey key,
                        bool is_by_second) {
  if (is_random(i.op)) return of_drawing(i, key);
  if (is_noise(i.op)) return of_noise(i.op, in);
  switch (operand_count(i.op)) {
    case 0:
      return {};
    case 1:
      return of_unary(i.op, in[0], result);
    case 2:
      return of_binary(i.op, in[0], in[1], result, is_by_second);
    default:
      return of_ternary(i.op, in);
  }
}

/// Returns true for the most frequent operations, whose slopes are computed in loops over many lanes at once.
bool is_plain(Op op) { return op == Op::add || op == Op::subtract || op == Op::multiply; }

/// Computes the slopes of a plain operation on `a` and `b`. `by_a` and `by_b` are the slopes of the operands, null if
/// they are 0.
void follow_plain(Op op, const double* a, const double* b, const double* by_a, const double* by_b, double* out,
                  std::size_t lanes) {
  if (op == Op::multiply) {
    std::fill_n(out, lanes, 0.0);
    for (std::size_t k = 0; by_a != nullptr && k < lanes; ++k) out[k] += b[k] * by_a[k];
    for (std::size_t k = 0; by_b != nullptr && k < lanes; ++k) out[k] += a[k] * by_b[k];
    return;
  }
  const double sign = op == Op::add ? 1 : -1;
  for (std::size_t k = 0; k < lanes; ++k) out[k] = by_a != nullptr ? by_a[k] : 0;
  for (std::size_t k = 0; by_b != nullptr && k < lanes; ++k) out[k] += sign * by_b[k];
}

constexpr auto kOnes = [] {
  std::array<double, kExpressionLanes> ones{};
  ones.fill(1);
  return ones;
}();

}  // namespace

ExpressionSlopes::ExpressionSlopes(const ExpressionBytecode& code, std::span<const std::size_t> by)
    : variable_count_(code.variable_count),
      by_(by.begin(), by.end()),
      values_(code.scratch_count * by.size() * kExpressionLanes),
      moves_(code.scratch_count * by.size()) {}

double* ExpressionSlopes::own(std::uint32_t reg, std::size_t k) {
  return values_.data() + ((reg - variable_count_) * by_.size() + k) * kExpressionLanes;
}

const double* ExpressionSlopes::slope(std::uint32_t reg, std::size_t k) const {
  if (reg < variable_count_) return reg == by_[k] ? kOnes.data() : nullptr;
  const std::size_t place = (reg - variable_count_) * by_.size() + k;
  return moves_[place] != 0 ? values_.data() + place * kExpressionLanes : nullptr;
}

void ExpressionSlopes::follow(const ExpressionInstruction& i, std::span<const double* const> in, const double* out,
                              std::size_t lanes, const RandomKey* keys) {
  // Most instructions depend on few variables. Skip the other variables.
  bool any = false, is_by_second = false;
  for (std::size_t k = 0; k < by_.size(); ++k) {
    bool moves_by_k = false;
    for (std::size_t operand = 0; operand < in.size(); ++operand) {
      const bool depends = slope(i.in[operand], k) != nullptr;
      moves_by_k = moves_by_k || depends;
      is_by_second = is_by_second || (depends && operand == 1);
    }
    moves(i.out, k) = moves_by_k ? 1 : 0;
    any = any || moves_by_k;
  }
  if (!any) return;
  if (is_plain(i.op)) {
    for (std::size_t k = 0; k < by_.size(); ++k) {
      if (moves(i.out, k) == 0) continue;
      follow_plain(i.op, in[0], in[1], slope(i.in[0], k), slope(i.in[1], k), own(i.out, k), lanes);
    }
    return;
  }
  std::array<Operands, kExpressionLanes> derivatives;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    Operands at{};
    for (std::size_t operand = 0; operand < in.size(); ++operand) at[operand] = in[operand][lane];
    const RandomKey key = keys != nullptr ? keys[lane] : RandomKey();
    derivatives[lane] = derivatives_of(i, at, out[lane], key, is_by_second);
  }
  for (std::size_t k = 0; k < by_.size(); ++k) {
    if (moves(i.out, k) == 0) continue;
    double* const sum = own(i.out, k);
    std::fill_n(sum, lanes, 0.0);
    for (std::size_t operand = 0; operand < in.size(); ++operand) {
      const double* const slopes = slope(i.in[operand], k);
      if (slopes == nullptr) continue;
      for (std::size_t lane = 0; lane < lanes; ++lane) sum[lane] += times(derivatives[lane][operand], slopes[lane]);
    }
  }
}

}  // namespace meristem
