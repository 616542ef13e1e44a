// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/expression/expression.h"

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace meristem::expression_test {

const ExpressionNames kNames{{"i", "n", "u", "length"}, {{"age", 12}}};

double value_of(std::string_view text) {
  return Expression::compile(text, kNames).evaluate(std::vector{3.0, 10.0, 0.5, 2.0});
}

SyntaxError error_of(std::string_view text) {
  try {
    Expression::compile(text, kNames);
  } catch (const ExpressionError& error) {
    return error.details();
  }
  ADD_FAILURE() << "no fault in: " << text;
  return {};
}

struct Equation {
  const char* text;
  double value;
};

TEST(Expression, PrecedenceBindsAsTheManualSays) {
  const Equation equations[] = {
      {"0 && 0 || 1", 1},
      {"1 || 0 && 0", 1},
      {"0 == 1 && 0", 0},
      {"2 < 1 == 0", 1},
      {"1 + 1 < 1", 0},
      {"1 + 2 * 3", 7},
      {"6 - 4 / 2", 4},
      {"1 + 7 % 4", 4},
      {"-2 * 3", -6},
      {"-2 ^ 2", -4},
      {"2 ^ -1", 0.5},
      {"2 ^ - - 2", 4},
      {"2 * 3 ^ 2", 18},
      {"!0 + 1", 2},
      {"!2 == 0", 1},
      {"!(2 == 0)", 1},
      {"- -3", 3},
      {"+3", 3},
      {"!!5", 1},
      {"1 ? 2 : 3 + 4", 2},
      {"0 ? 2 : 3 + 4", 7},
      {"0 || 1 ? 2 : 3", 2},
      {"(1 ? 2 : 3) + 4", 6},
      {"0 != 1 < 2", 1},
  };
  for (const auto& [text, value] : equations) EXPECT_EQ(value_of(text), value) << text;
}

TEST(Expression, OperatorsGroupFromTheLeftAndPowersFromTheRight) {
  const Equation equations[] = {
      {"7 - 2 - 1", 4},   {"24 / 4 / 2", 3},        {"24 / 4 * 2", 12},       {"17 % 10 % 4", 3},
      {"2 ^ 3 ^ 2", 512}, {"1 ? 2 : 1 ? 3 : 4", 2}, {"0 ? 2 : 0 ? 3 : 4", 4}, {"1 ? 0 ? 5 : 6 : 7", 6},
      {"10 - 4 + 3", 9},  {"2 * 7 % 4", 2},
  };
  for (const auto& [text, value] : equations) EXPECT_EQ(value_of(text), value) << text;
}

TEST(Expression, NumbersAreReadToTheLastBit) {
  const Equation equations[] = {
      {"1", 1},
      {".5", 0.5},
      {"5.", 5},
      {"2e-3", 2e-3},
      {"2E+3", 2000},
      {"0.1", 0.1},
      {"1.7976931348623157e308", 1.7976931348623157e308},
      {" \t\r\n1 ", 1},
  };
  for (const auto& [text, value] : equations) EXPECT_EQ(value_of(text), value) << text;
}

TEST(Expression, NamesStandForVariablesAndConstants) {
  EXPECT_EQ(value_of("i + n*u"), 8);
  EXPECT_EQ(value_of("age - length"), 10);
  EXPECT_EQ(value_of("pi"), 3.14159265358979323846);
  EXPECT_EQ(value_of("e"), 2.71828182845904523536);
  EXPECT_EQ(value_of("golden"), 137.50776405003785);
}

TEST(Expression, FunctionsHaveTheirValuesAtCorners) {
  const Equation equations[] = {
      {"mod(-1, 4)", 3},
      {"-8 % 4", 0},
      {"7.5 % -2", -0.5},
      {"mod(7, -4)", -1},
      {"1/(-1 % 1)", HUGE_VAL},
      {"1/(-0.5 % 0.5)", HUGE_VAL},
      {"5.5 % 2", 1.5},
      {"9007199254740993 % 2", 0},
      {"round(-2.5)", -3},
      {"sign(0)", 0},
      {"cbrt(27)", 3},
      {"cbrt(0)", 0},
      {"log10(1e22)", 22},
      {"log2(0.125)", -3},
      {"clamp(5, 3, 1)", 1},
      {"smoothstep(1, 1, 1)", 1},
      {"smoothstep(1, 1, 0.9)", 0},
      {"smoothstep(2, 0, 2)", 0},
      {"lerp(1, 3, 2)", 5},
      {"min(4, 3, 2, 1, 5)", 1},
      {"max(4, 3, 2, 9, 5)", 9},
      {"atan2(0, 0)", 0},
      {"asin(2)", 90},
      {"step(1, 1)", 1},
      {"0 ^ 0", 1},
      {"(-2) ^ 3", -8},
  };
  for (const auto& [text, value] : equations) EXPECT_EQ(value_of(text), value) << text;
}

TEST(Expression, UndefinedResultsFollowIeee) {
  EXPECT_EQ(value_of("1/0"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(value_of("log(0)"), -std::numeric_limits<double>::infinity());
  for (const char* text : {"0/0", "sqrt(-1)", "log(-1)", "log2(-1)", "log10(-1)", "(-2)^0.5", "sin(1/0)", "5 % 0"}) {
    EXPECT_TRUE(std::isnan(value_of(text))) << text;
  }
  EXPECT_EQ(value_of("0/0 == 0/0"), 0);
  EXPECT_EQ(value_of("0/0 != 0/0"), 1);
  EXPECT_EQ(value_of("0/0 ? 1 : 2"), 1);
}

TEST(Expression, NoiseVariesAtWholeNumbersAndKeepsItsRange) {
  double min = 0;
  double max = 0;
  const auto noise = Expression::compile("noise(i)", kNames);
  for (int k = 0; k < 1000; ++k) {
    const double value = noise.evaluate(std::vector<double>{double(k), 0, 0, 0});
    min = std::min(min, value);
    max = std::max(max, value);
  }
  EXPECT_GE(min, -1);
  EXPECT_LT(min, -0.7);
  EXPECT_LE(max, 1);
  EXPECT_GT(max, 0.7);
  EXPECT_NE(value_of("noise(i, n)"), value_of("noise(i)"));
  EXPECT_NE(value_of("noise(i, n, u)"), value_of("noise(i, n)"));
}

TEST(Expression, DrawsByThePlaceOfTheCallInTheText) {
  const RandomKey key(42);
  const auto drawn = [&](const char* text) {
    return Expression::compile(text, kNames).evaluate(std::vector<double>(4), key);
  };
  EXPECT_EQ(drawn("rand()"), key.uniform(0));
  EXPECT_EQ(drawn("0*rand() + rand()"), key.uniform(1));
  EXPECT_EQ(drawn("rand(2, 5)"), key.uniform(0, 2, 5));
  EXPECT_EQ(drawn("0*(rand() + rand()) + gauss(10, 2)"), 10 + 2 * key.normal(2));
  // The number of an outer call comes before the numbers of calls in its arguments.
  EXPECT_EQ(drawn("rand(rand(), 2)"), key.uniform(0, key.uniform(1), 2));
  EXPECT_EQ(drawn("gauss(rand(), 0)"), key.uniform(1));
  EXPECT_EQ(drawn("ran(3) + ran(-2)"), 3 * key.uniform(0) - 2 * key.uniform(1));
  EXPECT_EQ(drawn("nran(10, 2)"), drawn("gauss(10, 2)"));
  // Constant folding around a call does not change the number of the call.
  EXPECT_EQ(drawn("(1 + 2)*0 + (2 > 1 ? rand() : rand())"), key.uniform(0));
}

TEST(Expression, KnowsWhatItUses) {
  const auto expression = Expression::compile("u*2 + length", kNames);
  EXPECT_FALSE(expression.uses(0));
  EXPECT_TRUE(expression.uses(2));
  EXPECT_TRUE(expression.uses(3));
  EXPECT_FALSE(expression.uses(99));
  EXPECT_FALSE(expression.is_random());
  EXPECT_FALSE(expression.is_constant());
  EXPECT_EQ(expression.text(), "u*2 + length");
  EXPECT_TRUE(Expression::compile("age*2", kNames).is_constant());
  EXPECT_TRUE(Expression::compile("0*gauss(0, 1)", kNames).is_random());
  EXPECT_FALSE(Expression::compile("rand()", kNames).is_constant());
}

TEST(Expression, DefaultIsZero) {
  EXPECT_EQ(Expression().evaluate(), 0);
  EXPECT_TRUE(Expression().is_constant());
}

TEST(Expression, UnusedVariablesMayBeMissing) {
  const auto expression = Expression::compile("n + 1", kNames);
  const double n[] = {1, 2, 3};
  const double* const variables[] = {nullptr, n};
  double out[3] = {};
  expression.evaluate(3, variables, {}, out);
  EXPECT_EQ(out[2], 4);
}

TEST(Expression, MissingVariablesAndKeysAreInvalidArguments) {
  double out[2] = {};
  const RandomKey key;
  const auto expression = Expression::compile("n + 1", kNames);
  EXPECT_THROW(expression.evaluate(2, {}, {}, out), std::invalid_argument);
  EXPECT_THROW(expression.evaluate(std::vector{1.0}), std::invalid_argument);
  EXPECT_THROW(Expression::compile("rand()", kNames).evaluate(2, {}, std::span(&key, 1), out), std::invalid_argument);
  EXPECT_THROW(Expression::compile("1", {{"sin"}, {}}), std::invalid_argument);
  EXPECT_THROW(Expression::compile("1", {{}, {{"2x", 1}}}), std::invalid_argument);
}

TEST(Expression, ResultMayOverwriteAVariable) {
  std::vector<double> i(200);
  for (std::size_t k = 0; k < i.size(); ++k) i[k] = double(k);
  const double* const variables[] = {i.data()};
  Expression::compile("i*i - i", {{"i"}, {}}).evaluate(i.size(), variables, {}, i.data());
  for (std::size_t k = 0; k < i.size(); ++k) ASSERT_EQ(i[k], double(k * k) - double(k));
}

TEST(Expression, ConditionsHoldForNumbersButZero) {
  const auto holds = [](const char* text) { return is_true(Expression::compile(text, {}).evaluate()); };
  for (const char* const text : {"1", "-0.5", "2 > 1", "1 / 0 > 2"}) EXPECT_TRUE(holds(text)) << text;
  for (const char* const text : {"0", "1 / 0", "-1 / 0", "0 / 0", "sqrt(-1)"}) EXPECT_FALSE(holds(text)) << text;
}

TEST(Expression, BuiltinNamesAreIdentifiersAndFound) {
  EXPECT_EQ(builtin_names().size(), 36U);
  for (const std::string& name : builtin_names()) {
    EXPECT_TRUE(is_identifier(name)) << name;
    EXPECT_TRUE(is_builtin_name(name)) << name;
  }
  EXPECT_FALSE(is_builtin_name("age"));
  EXPECT_FALSE(is_identifier(""));
  EXPECT_FALSE(is_identifier("2a"));
  EXPECT_FALSE(is_identifier("a-b"));
  EXPECT_FALSE(is_identifier("\xC3\xA4ge"));
  EXPECT_TRUE(is_identifier("_a2"));
}

struct Rejection {
  std::string text;
  std::size_t offset;
  const char* message;
  const char* expected;
  const char* nearest;
};

void expect_rejected(const Rejection& rejection) {
  const SyntaxError error = error_of(rejection.text);
  EXPECT_EQ(error.offset, rejection.offset) << rejection.text;
  EXPECT_EQ(error.message, rejection.message) << rejection.text;
  EXPECT_EQ(error.expected, rejection.expected) << rejection.text;
  EXPECT_EQ(error.nearest, rejection.nearest) << rejection.text;
}

constexpr const char* kValue = "a number, a name or '('";
constexpr const char* kOperator = "an operator such as '*' or '+'";
constexpr const char* kNumber = "a number such as 1, .5 or 2e-3";
constexpr const char* kText = "numbers, names, operators and parentheses";

TEST(Expression, RejectsMissingValuesAndOperators) {
  const Rejection rejections[] = {
      {"", 0, "the expression is empty", kValue, ""},
      {"  \n", 0, "the expression is empty", kValue, ""},
      {"1 +", 3, "the expression ends where a value should follow", kValue, ""},
      {"1 + * 2", 4, "'*' stands where a value should", kValue, ""},
      {"2**3", 2, "'*' stands where a value should", kValue, "^"},
      {"()", 1, "')' stands where a value should", kValue, ""},
      {"1 2", 2, "'2' follows a value without an operator", kOperator, ""},
      {"(1)(2)", 3, "'(' follows a value without an operator", kOperator, ""},
      {"u and i", 2, "'and' follows a value without an operator", kOperator, "&&"},
      {"not u", 0, "'not' is not a known name", "a variable or a constant", "!"},
      {"1)", 1, "')' does not belong here", "an operator or the end", ""},
      {"1, 2", 1, "',' does not belong here", "an operator or the end", ""},
      {"1 : 2", 2, "':' does not belong here", "an operator or the end", ""},
      {"1 < 2 < 3", 6, "comparisons cannot be chained", "'&&' between two comparisons, or parentheses", ""},
      {"1 == 2 != 3", 7, "comparisons cannot be chained", "'&&' between two comparisons, or parentheses", ""},
  };
  for (const Rejection& rejection : rejections) expect_rejected(rejection);
}

TEST(Expression, RejectsUnclosedParenthesesCallsAndBranchesAtTheirBeginning) {
  const Rejection rejections[] = {
      {"2*(1 + (3)", 2, "'(' is not closed", "')'", ""},
      {"(1, 2)", 2, "',' does not belong here", "')'", ""},
      {"min(1, 2", 3, "'(' is not closed", "',' or ')'", ""},
      {"min(1 2)", 6, "'2' follows a value without an operator", kOperator, ""},
      {"rand(", 5, "the expression ends where a value should follow", kValue, ""},
      {"1 ? 2", 2, "'?' is not closed", "':' and the other value", ""},
      {"1 ? 2 )", 6, "')' does not belong here", "':' and the other value", ""},
  };
  for (const Rejection& rejection : rejections) expect_rejected(rejection);
}

TEST(Expression, RejectsUnknownNamesWithTheNearestOne) {
  const Rejection rejections[] = {
      {"2*lenght", 2, "'lenght' is not a known name", "a variable or a constant", "length"},
      {"Age", 0, "'Age' is not a known name", "a variable or a constant", "age"},
      {"goldn", 0, "'goldn' is not a known name", "a variable or a constant", "golden"},
      {"smothstep", 0, "'smothstep' is not a known name", "a variable or a constant", "smoothstep"},
      {"qqqqq", 0, "'qqqqq' is not a known name", "a variable or a constant", ""},
      {"2*parent.length", 2, "'parent.length' is not a known name", "a variable or a constant", "length"},
      {"u.x", 0, "'u.x' is not a known name", "a variable or a constant", ""},
      {"parent.sin(2)", 0, "'parent.sin' is not a function", "a function", ""},
      {"1 + smothstep(0, 1, u)", 4, "'smothstep' is not a function", "a function", "smoothstep"},
      {"length(2)", 0, "'length' is not a function", kOperator, ""},
      {"1 + sin", 4, "'sin' is a function", "sin(angle)", ""},
  };
  for (const Rejection& rejection : rejections) expect_rejected(rejection);
}

TEST(Expression, RejectsWrongArgumentCountsWithTheSignature) {
  const Rejection rejections[] = {
      {"1 + clamp(1, 2)", 4, "'clamp' has 2 arguments", "clamp(x, low, high)", ""},
      {"sin()", 0, "'sin' has 0 arguments", "sin(angle)", ""},
      {"sin(1, 2)", 7, "'sin' has too many arguments", "sin(angle)", ""},
      {"rand(1)", 0, "'rand' has 1 argument", "rand() or rand(low, high)", ""},
      {"gauss()", 0, "'gauss' has 0 arguments", "gauss(mean, deviation)", ""},
      {"min(1)", 0, "'min' has 1 argument", "min(a, b, ...)", ""},
      {"noise(1, 2, 3, 4)", 15, "'noise' has too many arguments", "noise(x [, y [, z]])", ""},
  };
  for (const Rejection& rejection : rejections) expect_rejected(rejection);
}

TEST(Expression, RejectsMalformedNumbers) {
  const Rejection rejections[] = {
      {"0x10", 0, "'0x10' is not a number", kNumber, ""},
      {"1 + 1.2.3", 4, "'1.2.3' is not a number", kNumber, ""},
      {".", 0, "'.' is not a number", kNumber, ""},
      {"2u", 0, "'2u' is not a number", kNumber, "2*u"},
      {"2e-3u", 0, "'2e-3u' is not a number", kNumber, "2e-3*u"},
      {"2e", 0, "'2e' is not a number", kNumber, "2*e"},
      {"1e999", 0, "'1e999' is too large or too near zero", "a number below 1.8e308", ""},
      {"1e-999", 0, "'1e-999' is too large or too near zero", "a number below 1.8e308", ""},
  };
  for (const Rejection& rejection : rejections) expect_rejected(rejection);
}

TEST(Expression, RejectsStrayCharactersWithTheirAsciiForm) {
  const Rejection rejections[] = {
      {"1 \u2212 2", 2, "'\u2212' has no meaning here", kText, "-"},
      {"2\u00D7u", 1, "'\u00D7' has no meaning here", kText, "*"},
      {"u \u2264 1", 2, "'\u2264' has no meaning here", kText, "<="},
      {"u = 1", 2, "'=' has no meaning here", kText, "=="},
      {"u & 1", 2, "'&' has no meaning here", kText, "&&"},
      {"u | 1", 2, "'|' has no meaning here", kText, "||"},
      {"1 $ 2", 2, "'$' has no meaning here", kText, ""},
      {"1 + \xFF", 4, "byte 0xff is not UTF-8 text", kText, ""},
      {"1 + \xE2\x88", 4, "byte 0xe2 is not UTF-8 text", kText, ""},
      {std::string("1\0", 2), 1, "control character 0x00 has no meaning here", kText, ""},
  };
  for (const Rejection& rejection : rejections) expect_rejected(rejection);
}

TEST(Expression, BoundsTheLengthOfTheText) {
  EXPECT_EQ(Expression::compile("1234", {}, 4).evaluate(), 1234);
  try {
    Expression::compile("12345", {}, 4);
    FAIL();
  } catch (const ExpressionError& error) {
    EXPECT_EQ(error.details().message, "the expression has 5 bytes");
    EXPECT_EQ(error.details().expected, "at most 4");
  }
}

std::string repeated(std::string_view text, int times) {
  std::string result;
  for (int k = 0; k < times; ++k) result += text;
  return result;
}

TEST(Expression, BoundsNestingOfEveryKind) {
  const struct {
    const char* open;
    const char* close;
  } kinds[] = {{"(", ")"}, {"-", ""}, {"1^", ""}, {"1 ? 2 : ", ""}, {"1 ? ", " : 2"}, {"abs(", ")"}, {"min(1, ", ")"}};
  for (const auto& [open, close] : kinds) {
    const auto nested = [&, o = open, c = close](int levels) {
      return repeated(o, levels) + "1" + repeated(c, levels);
    };
    EXPECT_TRUE(std::isfinite(value_of(nested(200)))) << open;
    const SyntaxError error = error_of(nested(201));
    EXPECT_EQ(error.message, "the expression is nested deeper than 200 levels") << open;
    EXPECT_LE(error.offset, 201 * std::string(open).size()) << open;
    EXPECT_GE(error.offset + std::string(open).size(), 200 * std::string(open).size()) << open;
  }
}

TEST(Expression, LongFlatFormulasAreNotNested) {
  EXPECT_EQ(value_of("0" + repeated("+i", 8000)), 24000);
  EXPECT_EQ(value_of("max(0" + repeated(",i", 8000) + ")"), 3);
}

TEST(Expression, ManyPendingOperandsSpillToTheHeap) {
  EXPECT_EQ(value_of(repeated("u + 2*(i*u - (", 90) + "i" + repeated("))", 90)), [] {
    double value = 3;
    for (int k = 0; k < 90; ++k) value = 0.5 + 2 * (3 * 0.5 - value);
    return value;
  }());
}

}  // namespace meristem::expression_test
