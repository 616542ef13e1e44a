// SPDX-License-Identifier: Apache-2.0
// The expression language of documents, grammars and the p-graph: arithmetic on numbers, compiled once to a bytecode
// that runs over 64 lanes at a time.
//
//   expression  = condition [ "?" expression ":" expression ]
//   operators, loosest first:  ||  &&  == !=  < <= > >=  + -  * / %  unary - ! +  ^ (to the right)
//   numbers 1, .5, 2e-3; names; calls f(a, b); parentheses. Truth is any number but 0; comparisons give 1 or 0 and
//   cannot be chained (a < b < c is a fault). x % y is mod(x, y), the remainder with the sign of y. As the answer of a
//   whole condition, what is no number is no truth: is_true().
//
// Functions, angles in degrees: sin cos tan asin acos atan atan2(y, x) sqrt cbrt exp log log2 log10 pow(x, y) abs sign
// floor ceil round trunc frac mod(x, y) min(...) max(...) clamp(x, low, high) lerp(a, b, t) smoothstep(a, b, x)
// step(edge, x) noise(x [, y [, z]]) rand() rand(low, high) gauss(mean, deviation), and their names in grammars
// ran(x), which is rand(0, x), and nran(mean, deviation). Constants: pi, e, golden (137.508°).
//
// Both branches of `?:` are evaluated. Random calls draw from the lane's key by their position in the
// expression: the k-th in the text, from 0 and left to right, draws the key's k-th number. The manual has it all:
// docs/manual/expressions.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/random.h"

namespace meristem {

/// The names an expression may use. Variables differ from lane to lane and are given when evaluating, in this order;
/// constants are folded in when compiling.
struct ExpressionNames {
  /// A name for a number that does not change.
  struct Constant {
    std::string name;  ///< an identifier
    double value = 0;  ///< replaces the name when an expression is compiled
  };
  std::vector<std::string> variables;  ///< names whose values are given when evaluating
  std::vector<Constant> constants;     ///< names with fixed values
};

struct ExpressionScope;  // expression_scope.h

/// A fault in an expression's text; `offset` is the byte at which it lies.
struct ExpressionFault {
  std::size_t offset = 0;  ///< byte of the text, from 0
  std::string message;     ///< what is wrong, without a full stop
  std::string expected;    ///< what was expected, or empty
  std::string nearest;     ///< the nearest valid name, or empty
};

/// Thrown for the first fault of an expression's text.
class ExpressionError : public std::runtime_error {
 public:
  /// Carries `fault`; what() is its message.
  explicit ExpressionError(ExpressionFault fault) : std::runtime_error(fault.message), fault_(std::move(fault)) {}
  /// The fault and its place.
  const ExpressionFault& fault() const { return fault_; }

 private:
  ExpressionFault fault_;
};

/// Whether a condition with this value holds: any number but 0. An infinity and a NaN are no answer, so they do not.
bool is_true(double condition);

/// True for a letter or '_' followed by letters, digits or '_'.
bool is_identifier(std::string_view name);
/// True for functions and constants that every expression knows; variables may not take these names.
bool is_builtin_name(std::string_view name);
/// All of them, in the order of the manual.
std::span<const std::string> builtin_names();

/// A compiled expression. Evaluation changes nothing, and any number of threads may use one expression.
class Expression {
 public:
  /// The expression "0".
  Expression();
  /// Compiles `text`. Throws ExpressionError for the first fault. Nesting is bounded (200 levels) and so is the length
  /// (`max_bytes`). A name that is no identifier or a built-in one is a std::invalid_argument.
  static Expression compile(std::string_view text, const ExpressionNames& names, std::size_t max_bytes = 16'384);
  /// Compiles `text` like compile(), with names that many expressions share.
  static Expression compile_in(std::string_view text, const ExpressionScope& scope, std::size_t max_bytes = 16'384);

  /// Values for `count` lanes into `out`. `variables[k]` points to `count` values of the k-th name (only those that
  /// `uses(k)` are read; others may be null). `keys` has a key per lane, or is empty if the expression draws nothing.
  /// Numbers follow IEEE 754: a division by zero gives an infinity, log(-1) a NaN; callers decide what that means.
  /// A lane's value depends neither on the other lanes nor on how they are split into calls. `out` may be one of the
  /// variables. Missing variables or keys are a std::invalid_argument.
  void evaluate(std::size_t count, std::span<const double* const> variables, std::span<const RandomKey> keys,
                double* out) const;
  /// The same values, and in slopes[k] their derivatives by the by[k]-th variable, `count` each. They are exact but for
  /// noise (symmetric differences, right to about 1e-8). At kinks they are those of one side, at steps 0.
  void evaluate_with_slopes(std::size_t count, std::span<const double* const> variables,
                            std::span<const RandomKey> keys, double* out, std::span<const std::size_t> by,
                            std::span<double* const> slopes) const;
  /// One lane.
  double evaluate(std::span<const double> variables = {}, RandomKey key = RandomKey()) const;

  bool uses(std::size_t variable) const;  ///< whether the k-th variable occurs
  bool is_random() const;                 ///< whether rand, gauss, ran or nran occurs
  bool is_constant() const;               ///< no variable, nothing random
  /// The text from which the expression was compiled.
  const std::string& text() const;
  /// Equal for expressions that do the same with the same variables, however they are written.
  std::uint64_t hash() const;

 private:
  struct Program;
  void require(std::size_t count, std::span<const double* const> variables, std::span<const RandomKey> keys) const;
  explicit Expression(std::shared_ptr<const Program> program);
  std::shared_ptr<const Program> program_;
};

}  // namespace meristem
