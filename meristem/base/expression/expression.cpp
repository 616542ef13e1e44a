// SPDX-License-Identifier: Apache-2.0
// The public side of expressions: compiles a text to bytecode, checks the arguments of evaluations, and runs the
// bytecode over lanes. Expressions share their bytecode, so copies cost little.
#include "meristem/base/expression/expression.h"

#include <algorithm>

#include <fmt/format.h>

#include "meristem/base/expression/expression_bytecode.h"
#include "meristem/base/expression/expression_parser.h"
#include "meristem/base/expression/expression_scope.h"
#include "meristem/base/fingerprint.h"

namespace meristem {

struct Expression::Program {
  std::string text;
  ExpressionBytecode code;
};

namespace {

void require_names(const ExpressionNames& names) {
  const auto require = [](const std::string& name) {
    if (!is_identifier(name) || is_builtin_name(name)) {
      throw std::invalid_argument(fmt::format("an expression's variable cannot be named '{}'", name));
    }
  };
  for (const auto& variable : names.variables) require(variable);
  for (const auto& constant : names.constants) require(constant.name);
}

}  // namespace

Expression::Expression() {
  static const Expression kZero = compile("0", {});
  program_ = kZero.program_;
}

Expression::Expression(std::shared_ptr<const Program> program) : program_(std::move(program)) {}

Expression Expression::compile(std::string_view text, const ExpressionNames& names, std::size_t max_bytes) {
  require_names(names);
  return compile_in(text, {.variables = names.variables, .constants = names.constants}, max_bytes);
}

Expression Expression::compile_in(std::string_view text, const ExpressionScope& scope, std::size_t max_bytes) {
  if (text.size() > max_bytes) {
    throw ExpressionError(
        {max_bytes, fmt::format("the expression has {} bytes", text.size()), fmt::format("at most {}", max_bytes), ""});
  }
  return Expression(std::make_shared<const Program>(Program{std::string(text), parse_expression(text, scope)}));
}

void Expression::require(std::size_t count, std::span<const double* const> variables,
                         std::span<const RandomKey> keys) const {
  const ExpressionBytecode& code = program_->code;
  for (std::size_t k = 0; k < code.used.size(); ++k) {
    if (code.used[k] && (k >= variables.size() || variables[k] == nullptr)) {
      throw std::invalid_argument(fmt::format("no values for variable {} of '{}'", k, text()));
    }
  }
  if (code.is_random && keys.size() < count) throw std::invalid_argument("fewer keys than lanes");
}

void Expression::evaluate(std::size_t count, std::span<const double* const> variables, std::span<const RandomKey> keys,
                          double* out) const {
  require(count, variables, keys);
  program_->code.run(count, variables, keys, out);
}

void Expression::evaluate_with_slopes(std::size_t count, std::span<const double* const> variables,
                                      std::span<const RandomKey> keys, double* out, std::span<const std::size_t> by,
                                      std::span<double* const> slopes) const {
  require(count, variables, keys);
  program_->code.run(count, variables, keys, out, by, slopes);
}

double Expression::evaluate(std::span<const double> variables, RandomKey key) const {
  const ExpressionBytecode& code = program_->code;
  if (variables.size() < code.used.size()) {
    throw std::invalid_argument(fmt::format("too few values of variables for '{}'", text()));
  }
  // Most components have about 20 variables.
  constexpr std::size_t kOnStack = 32;
  const double* on_stack[kOnStack];
  std::vector<const double*> on_heap;
  std::span<const double*> pointers(on_stack, std::min(kOnStack, variables.size()));
  if (variables.size() > kOnStack) {
    on_heap.resize(variables.size());
    pointers = on_heap;
  }
  for (std::size_t k = 0; k < variables.size(); ++k) pointers[k] = &variables[k];
  double result = 0;
  code.run(1, pointers, std::span(&key, 1), &result);
  return result;
}

bool Expression::uses(std::size_t variable) const {
  return variable < program_->code.used.size() && program_->code.used[variable];
}
bool Expression::is_random() const { return program_->code.is_random; }
bool Expression::is_constant() const { return !is_random() && program_->code.used.empty(); }
const std::string& Expression::text() const { return program_->text; }

std::uint64_t Expression::hash() const {
  const ExpressionBytecode& code = program_->code;
  Fingerprint hash;
  hash.add(code.variable_count).add(code.result);
  for (const auto& [op, out, in, place, value] : code.instructions) {
    hash.add(op).add(out).add(in[0]).add(in[1]).add(in[2]).add(place).add(value);
  }
  return hash.hash();
}

}  // namespace meristem
