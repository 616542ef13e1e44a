// SPDX-License-Identifier: Apache-2.0
// The expression language of documents, grammars and the p-graph: arithmetic on numbers, compiled once to a bytecode
// that runs over 64 lanes at a time.
//
//   expression  = condition [ "?" expression ":" expression ]
//   operators, loosest first:  ||  &&  == !=  < <= > >=  + -  * / %  unary - ! +  ^ (to the right)
//   numbers 1, .5, 2e-3; names; calls f(a, b); parentheses. Any number but 0 is true. Comparisons give 1 or 0 and
//   cannot be chained (a < b < c is an error). x % y is mod(x, y), the remainder with the sign of y. A whole condition
//   whose value is not a number counts as false: is_true().
//
// Functions, angles in degrees: sin cos tan asin acos atan atan2(y, x) sqrt cbrt exp log log2 log10 pow(x, y) abs sign
// floor ceil round trunc frac mod(x, y) min(...) max(...) clamp(x, low, high) lerp(a, b, t) smoothstep(a, b, x)
// step(edge, x) noise(x [, y [, z]]) rand() rand(low, high) gauss(mean, deviation). Grammars also use the names ran(x),
// which is rand(0, x), and nran(mean, deviation). Constants: pi, e, golden (137.508°).
//
// Both branches of `?:` are evaluated. Random calls draw from the lane's key by their position in the expression: the
// k-th call in the text, from 0 and left to right, draws the k-th number of the key. The manual describes everything:
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

/// The names that an expression may use. Variables differ from lane to lane, and their values are passed at evaluation,
/// in this order. Constants are folded in at compilation.
struct ExpressionNames {
  /// A name for a fixed number.
  struct Constant {
    std::string name;  ///< an identifier
    double value = 0;  ///< number that replaces the name when an expression is compiled
  };
  std::vector<std::string> variables;  ///< names whose values are passed at evaluation
  std::vector<Constant> constants;     ///< names with fixed values
};

struct ExpressionScope;  // expression_scope.h

/// An error in an expression's text.
struct SyntaxError {
  std::size_t offset = 0;  ///< byte of the text at which the error lies, from 0
  std::string message;     ///< the problem, without a full stop
  std::string expected;    ///< what was expected, or empty
  std::string nearest;     ///< the nearest valid name, or empty
};

/// Thrown for the first error in an expression's text.
class ExpressionError : public std::runtime_error {
 public:
  /// Carries `error`; what() is its message.
  explicit ExpressionError(SyntaxError error) : std::runtime_error(error.message), error_(std::move(error)) {}
  /// Returns the error and its place.
  const SyntaxError& details() const { return error_; }

 private:
  SyntaxError error_;
};

/// Returns true if a condition with this value holds: any number but 0. Infinities and NaN do not hold.
bool is_true(double condition);

/// True for a letter or '_' followed by letters, digits or '_'.
bool is_identifier(std::string_view name);
/// Returns true for functions and constants that every expression knows. Variables must not have these names.
bool is_builtin_name(std::string_view name);
/// Returns all built-in names, in the order of the manual.
std::span<const std::string> builtin_names();

/// A compiled expression. Evaluation changes nothing, and any number of threads may use one expression.
class Expression {
 public:
  /// The expression "0".
  Expression();
  /// Compiles `text`. Throws ExpressionError for the first error. The nesting (200 levels) and the length (`max_bytes`)
  /// are limited. Throws std::invalid_argument if a name is not an identifier or is built in.
  static Expression compile(std::string_view text, const ExpressionNames& names, std::size_t max_bytes = 16'384);
  /// Compiles `text` like compile(), with names that many expressions share.
  static Expression compile_in(std::string_view text, const ExpressionScope& scope, std::size_t max_bytes = 16'384);

  /// Writes the values of `count` lanes to `out`. `variables[k]` points to `count` values of the k-th name. Only
  /// variables with `uses(k)` are read, so the others may be null. `keys` has one key per lane, or is empty if the
  /// expression is not random. Numbers follow IEEE 754: a division by zero gives an infinity, and log(-1) gives NaN.
  /// The value of a lane depends neither on other lanes nor on how lanes are split into calls. `out` may be one of the
  /// variables. Throws std::invalid_argument if variables or keys are missing.
  void evaluate(std::size_t count, std::span<const double* const> variables, std::span<const RandomKey> keys,
                double* out) const;
  /// Like `evaluate`, and writes to slopes[k] the derivatives by the by[k]-th variable, `count` each. Derivatives are
  /// exact, except for noise (symmetric differences, exact to about 1e-8). At kinks, the derivative is that of one
  /// side, and at steps it is 0.
  void evaluate_with_slopes(std::size_t count, std::span<const double* const> variables,
                            std::span<const RandomKey> keys, double* out, std::span<const std::size_t> by,
                            std::span<double* const> slopes) const;
  /// Returns the value of one lane.
  double evaluate(std::span<const double> variables = {}, RandomKey key = RandomKey()) const;

  bool uses(std::size_t variable) const;  ///< true if the k-th variable occurs
  bool is_random() const;                 ///< true if rand, gauss, ran or nran occurs
  bool is_constant() const;               ///< true if there is no variable and no random call
  /// The text from which the expression was compiled.
  const std::string& text() const;
  /// Returns a hash that is equal for expressions with equal bytecode and variables, however they are written.
  std::uint64_t hash() const;

 private:
  struct Program;
  void require(std::size_t count, std::span<const double* const> variables, std::span<const RandomKey> keys) const;
  explicit Expression(std::shared_ptr<const Program> program);
  std::shared_ptr<const Program> program_;
};

}  // namespace meristem
