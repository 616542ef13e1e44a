// SPDX-License-Identifier: Apache-2.0
// Parses by recursive descent, with precedence climbing for the binary operators. Instructions are emitted as soon as
// an operator's operands are known, so there is no tree. Recursion is limited by kDeepestExpression.
//
// Based on: Richards, Whitby-Strevens: BCPL, the language and its compiler (1979), precedence climbing.
#include "meristem/base/expression/expression_parser.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "meristem/base/counted.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/expression/expression_functions.h"
#include "meristem/base/expression/expression_lexer.h"
#include "meristem/base/expression/expression_scope.h"
#include "meristem/base/in_quotes.h"

namespace meristem {

namespace {

using Kind = ExpressionToken::Kind;
using Op = ExpressionOp;
using Operand = ExpressionOperand;

constexpr std::string_view kValueExpected = "a number, a name or '('";
constexpr std::string_view kOperatorExpected = "an operator such as '*' or '+'";

struct BinaryOperator {
  std::string_view text;
  int level;  ///< a higher level binds tighter
  Op op;
  bool is_comparison = false;
};

constexpr BinaryOperator kBinaryOperators[] = {
    {"||", 1, Op::logical_or},   {"&&", 2, Op::logical_and},
    {"==", 3, Op::equal, true},  {"!=", 3, Op::unequal, true},
    {"<", 4, Op::less, true},    {"<=", 4, Op::less_equal, true},
    {">", 4, Op::greater, true}, {">=", 4, Op::greater_equal, true},
    {"+", 5, Op::add},           {"-", 5, Op::subtract},
    {"*", 6, Op::multiply},      {"/", 6, Op::divide},
    {"%", 6, Op::modulo},
};

const BinaryOperator* find_binary_operator(const ExpressionToken& token) {
  if (token.kind != Kind::operation) return nullptr;
  for (const BinaryOperator& op : kBinaryOperators) {
    if (op.text == token.text) return &op;
  }
  return nullptr;
}

/// Returns the operator that other languages write as a word.
std::string operator_for_word(std::string_view word) {
  if (word == "and") return "&&";
  if (word == "or") return "||";
  if (word == "not") return "!";
  return "";
}

const std::string& name_of(const std::string& variable) { return variable; }
const std::string& name_of(const ExpressionNames::Constant& constant) { return constant.name; }

/// Returns the position of a name in a list, from the list's table if it exists.
template <class Named>
std::optional<std::size_t> position_of(std::string_view name, const NameTable* table, std::span<const Named> list) {
  if (table != nullptr) return table->find(name);
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (name_of(list[k]) == name) return k;
  }
  return std::nullopt;
}

class Parser {
 public:
  Parser(std::string_view text, const ExpressionScope& scope)
      : lexer_(text), scope_(scope), emitter_(scope.variables.size()) {}

  ExpressionBytecode parse();

 private:
  [[noreturn]] void fail(std::size_t offset, std::string message, std::string_view expected, std::string nearest = "");
  [[noreturn]] void fail_without_value();
  [[noreturn]] void fail_unknown_name(const ExpressionToken& name);
  [[noreturn]] void fail_unknown_function(const ExpressionToken& name);
  [[noreturn]] void fail_unclosed(const ExpressionToken& opening, std::string_view expected);
  [[noreturn]] void fail_after_value(std::string_view expected);

  void advance() {
    previous_ = token_;
    token_ = lexer_.next();
  }
  bool accept(std::string_view operation);
  void enter_level();

  Operand parse_nested();
  Operand parse_conditional();
  Operand parse_binary(int lowest_level);
  Operand parse_unary();
  Operand parse_power();
  Operand parse_primary();
  Operand parse_parentheses();
  Operand parse_name();
  Operand parse_call(const ExpressionToken& name);
  Operand parse_arguments(const ExpressionFunction& function, const ExpressionToken& name,
                          const ExpressionToken& opening);
  std::optional<Operand> find_value(std::string_view name);

  Operand emit(Op op, std::initializer_list<Operand> operands) {
    return emitter_.apply(op, std::span(operands.begin(), operands.size()));
  }

  ExpressionLexer lexer_;
  const ExpressionScope& scope_;
  ExpressionEmitter emitter_;
  ExpressionToken token_;
  ExpressionToken previous_;
  int depth_ = 0;
  std::uint32_t random_calls_ = 0;
};

void Parser::fail(std::size_t offset, std::string message, std::string_view expected, std::string nearest) {
  throw ExpressionError({offset, std::move(message), std::string(expected), std::move(nearest)});
}

void Parser::fail_without_value() {
  if (token_.kind == Kind::end) {
    fail(token_.offset, "the expression ends where a value should follow", kValueExpected);
  }
  const bool is_double_star = token_.is("*") && previous_.is("*") && previous_.offset + 1 == token_.offset;
  fail(token_.offset, fmt::format("'{}' stands where a value should", token_.text), kValueExpected,
       is_double_star ? "^" : "");
}

void Parser::fail_unknown_name(const ExpressionToken& name) {
  const std::string message = fmt::format("{} is not a known name", in_quotes(name.text));
  constexpr std::string_view kExpected = "a variable or a constant";
  if (!scope_.has_nearest) fail(name.offset, message, kExpected);
  std::vector<std::string> values(scope_.variables.begin(), scope_.variables.end());
  for (const auto& constant : scope_.constants) values.push_back(constant.name);
  for (const auto& constant : expression_constants()) values.push_back(constant.name);
  std::string nearest = operator_for_word(name.text);
  // Users who write "parent.length" mean the variable that is called "length" here.
  const std::string_view last_part = name.text.substr(name.text.rfind('.') + 1);
  if (last_part != name.text && std::ranges::find(values, last_part) != values.end()) nearest = last_part;
  if (nearest.empty()) nearest = nearest_name(name.text, values);
  if (nearest.empty()) nearest = nearest_name(name.text, builtin_names());
  fail(name.offset, message, kExpected, std::move(nearest));
}

void Parser::fail_unknown_function(const ExpressionToken& name) {
  std::vector<std::string> functions;
  for (const auto& function : expression_functions()) functions.push_back(function.name);
  const bool is_value = find_value(name.text).has_value();
  fail(name.offset, fmt::format("{} is not a function", in_quotes(name.text)),
       is_value ? kOperatorExpected : "a function", is_value ? "" : nearest_name(name.text, functions));
}

void Parser::fail_unclosed(const ExpressionToken& opening, std::string_view expected) {
  if (token_.kind != Kind::end) fail_after_value(expected);
  fail(opening.offset, fmt::format("'{}' is not closed", opening.text), expected);
}

void Parser::fail_after_value(std::string_view expected) {
  if (token_.kind == Kind::operation && !token_.is("(") && !token_.is("!")) {
    fail(token_.offset, fmt::format("'{}' does not belong here", token_.text), expected);
  }
  fail(token_.offset, fmt::format("{} follows a value without an operator", in_quotes(token_.text)), kOperatorExpected,
       operator_for_word(token_.text));
}

bool Parser::accept(std::string_view operation) {
  if (!token_.is(operation)) return false;
  advance();
  return true;
}

void Parser::enter_level() {
  if (++depth_ > kDeepestExpression) {
    fail(token_.offset, fmt::format("the expression is nested deeper than {} levels", kDeepestExpression),
         "fewer parentheses, branches or signs inside each other");
  }
}

ExpressionBytecode Parser::parse() {
  advance();
  if (token_.kind == Kind::end) fail(0, "the expression is empty", kValueExpected);
  const Operand result = parse_conditional();
  if (token_.kind != Kind::end) fail_after_value("an operator or the end");
  return emitter_.finish(result);
}

Operand Parser::parse_nested() {
  enter_level();
  const Operand result = parse_conditional();
  --depth_;
  return result;
}

Operand Parser::parse_conditional() {
  const Operand condition = parse_binary(1);
  const ExpressionToken question = token_;
  if (!accept("?")) return condition;
  const Operand then = parse_nested();
  if (!accept(":")) fail_unclosed(question, "':' and the other value");
  return emit(Op::select, {condition, then, parse_nested()});
}

Operand Parser::parse_binary(int lowest_level) {
  Operand left = parse_unary();
  int compared_level = 0;
  for (const BinaryOperator* op = find_binary_operator(token_); op != nullptr && op->level >= lowest_level;
       op = find_binary_operator(token_)) {
    // a < b < c would compare c with 0 or 1, which no user means.
    if (op->is_comparison && op->level == compared_level) {
      fail(token_.offset, "comparisons cannot be chained", "'&&' between two comparisons, or parentheses");
    }
    advance();
    const Operand right = parse_binary(op->level + 1);
    left = emit(op->op, {left, right});
    compared_level = op->is_comparison ? op->level : 0;
  }
  return left;
}

Operand Parser::parse_unary() {
  const bool is_minus = token_.is("-");
  const bool is_not = token_.is("!");
  if (!is_minus && !is_not && !token_.is("+")) return parse_power();
  enter_level();
  advance();
  const Operand operand = parse_unary();
  --depth_;
  if (is_minus) return emit(Op::negate, {operand});
  return is_not ? emit(Op::logical_not, {operand}) : operand;
}

Operand Parser::parse_power() {
  const Operand base = parse_primary();
  if (!accept("^")) return base;
  enter_level();
  const Operand exponent = parse_unary();
  --depth_;
  return emit(Op::power, {base, exponent});
}

Operand Parser::parse_primary() {
  if (token_.kind == Kind::name) return parse_name();
  if (token_.is("(")) return parse_parentheses();
  if (token_.kind != Kind::number) fail_without_value();
  const Operand number = ExpressionEmitter::constant(token_.value);
  advance();
  return number;
}

Operand Parser::parse_parentheses() {
  const ExpressionToken opening = token_;
  advance();
  const Operand inside = parse_nested();
  if (!accept(")")) fail_unclosed(opening, "')'");
  return inside;
}

std::optional<Operand> Parser::find_value(std::string_view name) {
  if (const auto k = position_of(name, scope_.variable_table, scope_.variables)) return emitter_.variable(*k);
  if (const auto k = position_of(name, scope_.constant_table, scope_.constants)) {
    return ExpressionEmitter::constant(scope_.constants[*k].value);
  }
  const ExpressionConstant* constant = find_expression_constant(name);
  if (constant == nullptr) return std::nullopt;
  return ExpressionEmitter::constant(constant->value);
}

Operand Parser::parse_name() {
  const ExpressionToken name = token_;
  advance();
  if (token_.is("(")) return parse_call(name);
  if (const auto value = find_value(name.text)) return *value;
  if (const ExpressionFunction* function = find_expression_function(name.text)) {
    fail(name.offset, fmt::format("'{}' is a function", name.text), function->signature);
  }
  fail_unknown_name(name);
}

Operand Parser::parse_call(const ExpressionToken& name) {
  const ExpressionFunction* function = find_expression_function(name.text);
  if (function == nullptr) fail_unknown_function(name);
  const ExpressionToken opening = token_;
  advance();
  return parse_arguments(*function, name, opening);
}

Operand Parser::parse_arguments(const ExpressionFunction& function, const ExpressionToken& name,
                                const ExpressionToken& opening) {
  // Number a random call before the calls in its arguments, so that the numbers follow the text.
  const std::uint32_t place = is_random(function.op) ? random_calls_++ : 0;
  std::array<Operand, 3> operands;
  std::size_t held = 0;
  std::size_t count = 0;
  if (!token_.is(")")) {
    do {
      const std::size_t offset = token_.offset;
      if (held == function.largest_arity() && function.takes_more) {
        // Combine the arguments so far, so that any number of arguments needs only two registers.
        operands[0] = emitter_.apply(function.op, std::span(operands).first(held));
        held = 1;
      }
      if (held == function.largest_arity()) {
        fail(offset, fmt::format("'{}' has too many arguments", name.text), function.signature);
      }
      operands[held++] = parse_nested();
      ++count;
    } while (accept(","));
  }
  if (!accept(")")) fail_unclosed(opening, count == 0 ? "')'" : "',' or ')'");
  if (!function.takes(count)) {
    fail(name.offset, fmt::format("'{}' has {}", name.text, counted(count, "argument")), function.signature);
  }
  return emitter_.apply(function.op_for(count), std::span(operands).first(held), place);
}

}  // namespace

ExpressionBytecode parse_expression(std::string_view text, const ExpressionScope& scope) {
  return Parser(text, scope).parse();
}

}  // namespace meristem
