// SPDX-License-Identifier: Apache-2.0
// The table of functions and constants that every expression knows, with their signatures and numbers of arguments.
// Names are found by a linear search.
#include "meristem/base/expression/expression_functions.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "meristem/base/expression/expression.h"
#include "meristem/base/vec.h"

namespace meristem {

namespace {

using Op = ExpressionOp;

constexpr std::uint8_t kNoArgument = 1;
constexpr std::uint8_t kOne = 2;
constexpr std::uint8_t kTwo = 4;
constexpr std::uint8_t kThree = 8;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_letter_or_digit(char c) { return is_letter(c) || (c >= '0' && c <= '9'); }

template <typename Entry>
const Entry* find_by_name(std::span<const Entry> entries, std::string_view name) {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

}  // namespace

bool ExpressionFunction::takes(std::size_t arguments) const {
  if (arguments > largest_arity()) return takes_more;
  return (arities >> arguments & 1) != 0;
}

std::size_t ExpressionFunction::largest_arity() const { return static_cast<std::size_t>(std::bit_width(arities)) - 1; }

ExpressionOp ExpressionFunction::op_for(std::size_t arguments) const {
  if (op == Op::uniform && arguments == 2) return Op::uniform_between;
  if (op == Op::noise_1 && arguments == 2) return Op::noise_2;
  if (op == Op::noise_1 && arguments == 3) return Op::noise_3;
  return op;
}

std::span<const ExpressionFunction> expression_functions() {
  // In the order of the manual.
  static const std::vector<ExpressionFunction> kFunctions = {
      {"sin", "sin(angle)", kOne, false, Op::sine},
      {"cos", "cos(angle)", kOne, false, Op::cosine},
      {"tan", "tan(angle)", kOne, false, Op::tangent},
      {"asin", "asin(x)", kOne, false, Op::arc_sine},
      {"acos", "acos(x)", kOne, false, Op::arc_cosine},
      {"atan", "atan(x)", kOne, false, Op::arc_tangent},
      {"atan2", "atan2(y, x)", kTwo, false, Op::arc_tangent_2},
      {"sqrt", "sqrt(x)", kOne, false, Op::square_root},
      {"cbrt", "cbrt(x)", kOne, false, Op::cube_root},
      {"exp", "exp(x)", kOne, false, Op::exponential},
      {"log", "log(x)", kOne, false, Op::logarithm},
      {"log2", "log2(x)", kOne, false, Op::logarithm_2},
      {"log10", "log10(x)", kOne, false, Op::logarithm_10},
      {"pow", "pow(x, y)", kTwo, false, Op::power},
      {"abs", "abs(x)", kOne, false, Op::absolute},
      {"sign", "sign(x)", kOne, false, Op::sign},
      {"floor", "floor(x)", kOne, false, Op::floor},
      {"ceil", "ceil(x)", kOne, false, Op::ceiling},
      {"round", "round(x)", kOne, false, Op::round},
      {"trunc", "trunc(x)", kOne, false, Op::truncate},
      {"frac", "frac(x)", kOne, false, Op::fraction},
      {"mod", "mod(x, y)", kTwo, false, Op::modulo},
      {"min", "min(a, b, ...)", kTwo, true, Op::minimum},
      {"max", "max(a, b, ...)", kTwo, true, Op::maximum},
      {"clamp", "clamp(x, low, high)", kThree, false, Op::clamp},
      {"lerp", "lerp(a, b, t)", kThree, false, Op::interpolate},
      {"smoothstep", "smoothstep(a, b, x)", kThree, false, Op::smooth_step},
      {"step", "step(edge, x)", kTwo, false, Op::step},
      {"noise", "noise(x [, y [, z]])", kOne | kTwo | kThree, false, Op::noise_1},
      {"rand", "rand() or rand(low, high)", kNoArgument | kTwo, false, Op::uniform},
      {"gauss", "gauss(mean, deviation)", kTwo, false, Op::gauss},
      {"ran", "ran(x)", kOne, false, Op::uniform_below},
      {"nran", "nran(mean, deviation)", kTwo, false, Op::gauss},
  };
  return kFunctions;
}

std::span<const ExpressionConstant> expression_constants() {
  static const std::vector<ExpressionConstant> kConstants = {
      {"pi", kPi}, {"e", 2.71828182845904523536}, {"golden", kGoldenAngleDeg}};
  return kConstants;
}

const ExpressionFunction* find_expression_function(std::string_view name) {
  return find_by_name(expression_functions(), name);
}

const ExpressionConstant* find_expression_constant(std::string_view name) {
  return find_by_name(expression_constants(), name);
}

bool is_true(double condition) { return condition != 0 && std::isfinite(condition); }

bool is_identifier(std::string_view name) {
  return !name.empty() && is_letter(name.front()) && std::all_of(name.begin(), name.end(), is_letter_or_digit);
}

bool is_builtin_name(std::string_view name) {
  return find_expression_function(name) != nullptr || find_expression_constant(name) != nullptr;
}

std::span<const std::string> builtin_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const auto& function : expression_functions()) names.push_back(function.name);
    for (const auto& constant : expression_constants()) names.push_back(constant.name);
    return names;
  }();
  return kNames;
}

}  // namespace meristem
