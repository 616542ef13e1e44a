// SPDX-License-Identifier: Apache-2.0
// Tests random formulas. They are trees that print themselves and compute their own value lane by lane. This second,
// slow implementation shares neither the parser nor the loops with the tested one.
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "meristem/base/degrees.h"
#include "meristem/base/expression/expression.h"
#include "meristem/base/math.h"

namespace meristem::expression_property_test {

const ExpressionNames kNames{{"i", "u", "v"}, {{"age", 12}}};

/// The variables of one lane and its random key.
struct Lane {
  double values[3];
  RandomKey key;
};

struct Node {
  std::string symbol;  ///< operator, function, name or number
  std::vector<Node> children;
  double value = 0;         ///< value of a number or constant
  int variable = -1;        ///< index of a variable
  std::uint64_t place = 0;  ///< number of a random call
};

struct Operation {
  const char* symbol;
  int level;  ///< level of the operator in the parser's grammar; 0 for functions
  int arity;
  double (*value)(const double*);
};

constexpr int kConditionalLevel = 0;
constexpr int kUnaryLevel = 7;
constexpr int kPowerLevel = 8;
constexpr int kFunctionLevel = 9;

const std::vector<Operation>& operations() {
  static const std::vector<Operation> kOperations = {
      {"||", 1, 2, [](const double* a) { return a[0] != 0 || a[1] != 0 ? 1.0 : 0.0; }},
      {"&&", 2, 2, [](const double* a) { return a[0] != 0 && a[1] != 0 ? 1.0 : 0.0; }},
      {"==", 3, 2, [](const double* a) { return a[0] == a[1] ? 1.0 : 0.0; }},
      {"!=", 3, 2, [](const double* a) { return a[0] != a[1] ? 1.0 : 0.0; }},
      {"<", 4, 2, [](const double* a) { return a[0] < a[1] ? 1.0 : 0.0; }},
      {">=", 4, 2, [](const double* a) { return a[0] >= a[1] ? 1.0 : 0.0; }},
      {"+", 5, 2, [](const double* a) { return a[0] + a[1]; }},
      {"-", 5, 2, [](const double* a) { return a[0] - a[1]; }},
      {"*", 6, 2, [](const double* a) { return a[0] * a[1]; }},
      {"/", 6, 2, [](const double* a) { return a[0] / a[1]; }},
      {"%", 6, 2,
       [](const double* a) {
         const double rest = std::fmod(a[0], a[1]) + 0.0;
         return rest != 0 && (rest < 0) != (a[1] < 0) ? rest + a[1] : rest;
       }},
      {"-", kUnaryLevel, 1, [](const double* a) { return -a[0]; }},
      {"!", kUnaryLevel, 1, [](const double* a) { return a[0] == 0 ? 1.0 : 0.0; }},
      {"^", kPowerLevel, 2, [](const double* a) { return math::pow(a[0], a[1]); }},
      {"?", kConditionalLevel, 3, [](const double* a) { return a[0] != 0 ? a[1] : a[2]; }},
      {"sin", kFunctionLevel, 1, [](const double* a) { return math::sin_deg(a[0]); }},
      {"sqrt", kFunctionLevel, 1, [](const double* a) { return std::sqrt(a[0]); }},
      {"floor", kFunctionLevel, 1, [](const double* a) { return std::floor(a[0]); }},
      {"exp", kFunctionLevel, 1, [](const double* a) { return math::exp(a[0]); }},
      {"min", kFunctionLevel, 2, [](const double* a) { return a[1] < a[0] ? a[1] : a[0]; }},
      {"max", kFunctionLevel, 3,
       [](const double* a) {
         const double larger = a[1] > a[0] ? a[1] : a[0];
         return a[2] > larger ? a[2] : larger;
       }},
      {"lerp", kFunctionLevel, 3, [](const double* a) { return a[0] + (a[1] - a[0]) * a[2]; }},
      {"rand", kFunctionLevel, 0, nullptr},
      {"gauss", kFunctionLevel, 2, nullptr},
  };
  return kOperations;
}

const Operation& operation_of(const Node& node) {
  for (const Operation& operation : operations()) {
    if (node.symbol == operation.symbol && static_cast<std::size_t>(operation.arity) == node.children.size()) {
      return operation;
    }
  }
  throw std::logic_error("no such operation");
}

bool is_leaf(const Node& node) { return node.children.empty() && node.symbol != "rand"; }
int level_of(const Node& node) { return is_leaf(node) ? kFunctionLevel : operation_of(node).level; }

double value_of(const Node& node, const Lane& lane) {
  if (node.variable >= 0) return lane.values[node.variable];
  if (is_leaf(node)) return node.value;
  if (node.symbol == "rand") return lane.key.uniform(node.place);
  double arguments[3] = {};
  for (std::size_t k = 0; k < node.children.size(); ++k) arguments[k] = value_of(node.children[k], lane);
  if (node.symbol == "gauss") return arguments[0] + arguments[1] * lane.key.normal(node.place);
  return operation_of(node).value(arguments);
}

/// Numbers the random calls in the order of the printed text.
void number_calls(Node& node, std::uint64_t& next) {
  const bool stands_first = level_of(node) == kFunctionLevel;
  if (stands_first && (node.symbol == "rand" || node.symbol == "gauss")) node.place = next++;
  for (Node& child : node.children) number_calls(child, next);
}

enum class Parentheses { everywhere, where_needed };

std::string printed(const Node& node, Parentheses style);

/// Prints `child` as an operand, in parentheses if it binds more loosely than `level`.
std::string operand(const Node& child, int level, Parentheses style) {
  const bool bare = style == Parentheses::where_needed ? level_of(child) >= level : is_leaf(child);
  return bare ? printed(child, style) : fmt::format("({})", printed(child, style));
}

std::string printed(const Node& node, Parentheses style) {
  if (is_leaf(node)) return node.symbol;
  const auto& c = node.children;
  const int level = level_of(node);
  if (level == kFunctionLevel) {
    std::string text = node.symbol + "(";
    for (std::size_t k = 0; k < c.size(); ++k) text += (k > 0 ? ", " : "") + printed(c[k], style);
    return text + ")";
  }
  if (level == kUnaryLevel) return node.symbol + operand(c[0], kUnaryLevel, style);
  if (level == kPowerLevel) return operand(c[0], kFunctionLevel, style) + " ^ " + operand(c[1], kUnaryLevel, style);
  if (level == kConditionalLevel) {
    return fmt::format("{} ? {} : {}", operand(c[0], 1, style), operand(c[1], 0, style), operand(c[2], 0, style));
  }
  // Comparisons do not chain. All other operators group from the left.
  const int left = level == 3 || level == 4 ? level + 1 : level;
  return operand(c[0], left, style) + " " + node.symbol + " " + operand(c[1], level + 1, style);
}

Node leaf(int choice) {
  switch (choice) {
    case 0:
      return {"i", {}, 0, 0};
    case 1:
      return {"u", {}, 0, 1};
    case 2:
      return {"v", {}, 0, 2};
    case 3:
      return {"age", {}, 12};
    case 4:
      return {"0", {}, 0};
    case 5:
      return {"0.3", {}, 0.3};
    case 6:
      return {"2", {}, 2};
    default:
      return {"1e3", {}, 1e3};
  }
}

rc::Gen<Node> formula(int depth) {
  auto leaves = rc::gen::map(rc::gen::inRange(0, 8), leaf);
  if (depth == 0) return leaves;
  const auto count = static_cast<int>(operations().size());
  const auto inner = rc::gen::mapcat(rc::gen::inRange(0, count), [depth](int choice) {
    const Operation& operation = operations()[static_cast<std::size_t>(choice)];
    return rc::gen::map(
        rc::gen::container<std::vector<Node>>(static_cast<std::size_t>(operation.arity), formula(depth - 1)),
        [&operation](std::vector<Node> children) {
          return Node{operation.symbol, std::move(children)};
        });
  });
  return rc::gen::weightedOneOf<Node>({{1, leaves}, {3, inner}});
}

Node any_formula() {
  Node node = *formula(4);
  std::uint64_t calls = 0;
  number_calls(node, calls);
  RC_LOG() << printed(node, Parentheses::where_needed) << '\n';
  return node;
}

/// Returns lanes whose values include signs, zeros, halves and infinities.
std::vector<Lane> lanes_for(std::size_t count, std::uint64_t seed) {
  constexpr double kSpecial[] = {0, 1, -1, 0.5, 2, -3, 1e18, HUGE_VAL};
  std::vector<Lane> lanes(count);
  for (std::size_t k = 0; k < count; ++k) {
    const RandomKey key = RandomKey(seed).child(k);
    lanes[k].key = key;
    for (std::uint64_t v = 0; v < 3; ++v) {
      const bool is_special = key.uniform(v + 100) < 0.3;
      const auto which = static_cast<std::size_t>(key.uniform(v + 200) * 8);
      lanes[k].values[v] = is_special ? kSpecial[which] : key.uniform(v + 300, -20, 20);
    }
  }
  return lanes;
}

/// Computes the values of the lanes from `begin` to `end` in one call.
void evaluate(const Expression& expression, const std::vector<Lane>& lanes, std::size_t begin, std::size_t end,
              std::vector<double>& out) {
  std::vector<double> columns[3];
  std::vector<RandomKey> keys;
  for (std::size_t k = begin; k < end; ++k) {
    for (int v = 0; v < 3; ++v) columns[v].push_back(lanes[k].values[v]);
    keys.push_back(lanes[k].key);
  }
  const double* const variables[] = {columns[0].data(), columns[1].data(), columns[2].data()};
  const std::size_t before = out.size();
  out.resize(before + (end - begin));
  expression.evaluate(end - begin, variables, keys, out.data() + before);
}

/// Returns true if two numbers are equal. All NaN are equal, and so are both zeros.
bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

RC_GTEST_PROP(ExpressionProperty, BatchesAgreeWithATreeWorkedOutLaneByLane, ()) {
  const Node node = any_formula();
  const auto lanes = lanes_for(*rc::gen::inRange<std::size_t>(1, 150), *rc::gen::arbitrary<std::uint64_t>());
  std::vector<double> values;
  evaluate(Expression::compile(printed(node, Parentheses::everywhere), kNames), lanes, 0, lanes.size(), values);
  for (std::size_t k = 0; k < lanes.size(); ++k) RC_ASSERT(is_same(values[k], value_of(node, lanes[k])));
}

RC_GTEST_PROP(ExpressionProperty, ParenthesesThatPrecedenceImpliesMayBeLeftOut, ()) {
  const Node node = any_formula();
  const auto lanes = lanes_for(9, 1);
  std::vector<double> full;
  std::vector<double> sparse;
  const std::string text = printed(node, Parentheses::where_needed);
  evaluate(Expression::compile(printed(node, Parentheses::everywhere), kNames), lanes, 0, lanes.size(), full);
  evaluate(Expression::compile(text, kNames), lanes, 0, lanes.size(), sparse);
  for (std::size_t k = 0; k < lanes.size(); ++k) RC_ASSERT(is_same(full[k], sparse[k]));
}

RC_GTEST_PROP(ExpressionProperty, NoLaneDependsOnHowLanesAreSplitIntoCalls, ()) {
  const Expression expression = Expression::compile(printed(any_formula(), Parentheses::where_needed), kNames);
  const auto lanes = lanes_for(200, *rc::gen::arbitrary<std::uint64_t>());
  std::vector<double> whole;
  evaluate(expression, lanes, 0, lanes.size(), whole);
  std::vector<double> parts;
  while (parts.size() < lanes.size()) {
    const auto size = std::min(*rc::gen::inRange<std::size_t>(1, 90), lanes.size() - parts.size());
    evaluate(expression, lanes, parts.size(), parts.size() + size, parts);
  }
  // Checks that zeros keep their sign.
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    RC_ASSERT(is_same(whole[k], parts[k]));
    RC_ASSERT((std::isnan(whole[k]) || std::signbit(whole[k]) == std::signbit(parts[k])));
    RC_ASSERT(is_same(whole[k], expression.evaluate(lanes[k].values, lanes[k].key)));
  }
}

/// Checks that a text either compiles or has an error inside the text.
void expect_answer(const std::string& text) {
  try {
    const Expression expression = Expression::compile(text, kNames);
    RC_ASSERT(expression.text() == text);
    expression.evaluate(std::vector{1.0, 2.0, 3.0});
  } catch (const ExpressionError& error) {
    RC_ASSERT(error.details().offset <= text.size());
    RC_ASSERT(!error.details().message.empty());
    RC_ASSERT(!error.details().expected.empty());
  }
}

RC_GTEST_PROP(ExpressionProperty, AnyBytesCompileOrAreLocated, (const std::string& text)) { expect_answer(text); }

RC_GTEST_PROP(ExpressionProperty, AnyTokensCompileOrAreLocated, ()) {
  const auto token =
      rc::gen::elementOf(std::vector<std::string>{"1", ".5", "i", "age", "sin", "min", "rand", "(", ")",  ",", "?",
                                                  ":", "+",  "-", "*",   "/",   "^",   "!",    "<", "==", " ", "="});
  std::string text;
  for (const std::string& part : *rc::gen::container<std::vector<std::string>>(token)) text += part;
  expect_answer(text);
}

RC_GTEST_PROP(ExpressionProperty, CutAFormulaAnywhereAndItCompilesOrIsLocated, ()) {
  const std::string text = printed(any_formula(), Parentheses::where_needed);
  expect_answer(text.substr(0, *rc::gen::inRange<std::size_t>(0, text.size() + 1)));
}

}  // namespace meristem::expression_property_test
