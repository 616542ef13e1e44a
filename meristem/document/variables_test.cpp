// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/variables.h"

#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/components/leaf.h"
#include "meristem/components/registry.h"
#include "tests/support/temporary_folder.h"

namespace meristem::variables_test {

/// A leaf as long as `length` says, with variables.
std::string with(const std::string& variables, const std::string& length = "1") {
  return fmt::format(
      R"({{"meristem": 1,
"variables": {{{}}},
"components": {{"leaf": {{"type": "leaf", "length": "{}"}}}}}})",
      variables, length);
}

Document read(const std::string& text, const std::vector<std::string>& sets = {}, const std::string& file = "d.json") {
  std::vector<ValueOverride> overrides;
  for (const std::string& set : sets) overrides.push_back(parse_override(set));
  return read_document(text, file, builtin_components(), {.overrides = overrides});
}

std::string errors_of(const std::string& text, const std::vector<std::string>& sets = {}) {
  try {
    read(text, sets);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

std::string warnings_of(const Document& document) {
  std::string all;
  for (const Diagnostic& warning : document.warnings) all += warning.text() + "\n";
  return all;
}

double length_of(const Document& document) {
  return static_cast<const Leaf*>(document.graph.components[0].parameters.get())->blade.length;
}

constexpr const char* kTree = R"("half": "tall/2", "tall": {"value": "2 + 0.1*age", "private": true}, "age": 10)";

TEST(Variables, AreWorkedOutFromEachOtherInAnyOrder) {
  const Document document = read(with(kTree, "half"));
  EXPECT_EQ(document.variables[0].value, 1.5);
  EXPECT_EQ(document.variables[1].value, 3);
  EXPECT_EQ(document.variables[2].value, 10);
  EXPECT_EQ(length_of(document), 1.5);
}

TEST(Variables, TellTheirExpressionAndWhetherTheyArePrivate) {
  const Document document = read(with(kTree, "half"));
  EXPECT_EQ(document.variables[0].expression, "tall/2");
  EXPECT_FALSE(document.variables[0].is_private);
  EXPECT_EQ(document.variables[1].expression, "2 + 0.1*age");
  EXPECT_TRUE(document.variables[1].is_private);
  EXPECT_EQ(document.variables[2].expression, "");
}

TEST(Variables, FollowWhatIsSetOrAreSetThemselves) {
  EXPECT_EQ(length_of(read(with(kTree, "half"), {"age=20"})), 2);
  EXPECT_EQ(length_of(read(with(kTree, "half"), {"tall=5"})), 2.5);
  EXPECT_EQ(length_of(read(with(kTree, "half"), {"tall=age"})), 5);
  EXPECT_EQ(length_of(read(with(kTree, "half"), {"half=0.25", "age=20"})), 0.25);
}

TEST(Variables, MayGiveTheRangeOfOthers) {
  const Document document = read(with(R"("a": {"value": 3, "max": "2*b"}, "b": 4)", "a"));
  EXPECT_EQ(document.variables[0].max, 8);
}

TEST(Variables, ThatGoRoundAreNamed) {
  EXPECT_EQ(
      errors_of(with(R"("top": "c", "c": {"value": "1 + a"}, "a": "b", "b": "c + size", "size": 2)", "top")),
      "d.json:2:42: variables.c.value: the variables c -> a -> b -> c depend on each other in a circle; expected an "
      "expression without this circle");
  EXPECT_EQ(errors_of(with(R"("age": "age + 1")", "age")),
            "d.json:2:22: variables.age: 'age' depends on itself; expected an expression without this circle");
  // Two circles are two faults. A variable that uses one of them causes no further fault.
  EXPECT_EQ(
      errors_of(with(R"("a": "b", "b": "a", "c": "d", "d": "c", "last": "a + c")", "last")),
      "d.json:2:20: variables.a: the variables a -> b -> a depend on each other in a circle; expected an expression "
      "without this circle\n"
      "d.json:2:40: variables.c: the variables c -> d -> c depend on each other in a circle; expected an expression "
      "without this circle");
}

TEST(Variables, ThatAreSetInACircleSaySo) {
  EXPECT_EQ(errors_of(with(R"("a": 1, "b": "a")", "b"), {"a=b"}),
            "--set a: variables.a: the variables a -> b -> a depend on each other in a circle; expected an expression "
            "without "
            "this circle");
}

TEST(Variables, NameTheNearestOfAnUnknownName) {
  EXPECT_EQ(errors_of(with(R"("tall": "2 + 0.1*agee", "age": 10)", "tall*age")),
            "d.json:2:32: variables.tall: 'agee' is not a known name; expected a variable or a constant; did you mean "
            "'age'?");
}

TEST(Variables, AreOneNumberForAll) {
  EXPECT_EQ(errors_of(with(R"("a": "rand() + 1")", "a")),
            "d.json:2:20: variables.a: 'value' is one number (only those of components vary), and this expression "
            "differs between instances; expected an expression of numbers and the document's variables");
  EXPECT_EQ(errors_of(with(R"("a": "u", "b": "a")", "b")),
            "d.json:2:20: variables.a: 'value' is one number (only those of components vary), and this expression "
            "differs between instances; expected an expression of numbers and the document's variables");
}

TEST(Variables, WithoutAFiniteValueAreFaults) {
  EXPECT_EQ(errors_of(with(R"("a": 0, "b": "1/a")", "b")),
            "d.json:2:28: variables.b: the expression's value inf is out of range for 'value'; expected a number");
}

TEST(Variables, ChainsOfAThousandAreWorkedOut) {
  std::string chain = "\"v0\": \"v1 + 1\"";
  for (int k = 1; k < 999; ++k) chain += fmt::format(", \"v{}\": \"v{} + 1\"", k, k + 1);
  EXPECT_EQ(read(with(chain + ", \"v999\": 1", "v0/1000")).variables[0].value, 1000);
  EXPECT_EQ(errors_of(with(chain + ", \"v999\": 1, \"more\": 2", "1")),
            "d.json:2:14: variables: the document has 1001 variables; expected at most 1000");
}

TEST(Variables, ThatNothingUsesAreWarnings) {
  EXPECT_EQ(warnings_of(read(with(R"("a": 1, "ab": 2, "c": "a")", "ab"))),
            "d.json:2:37: variables.c: nothing uses 'c'\n");
}

TEST(Variables, AreUsedByTheGrammarsOfFiles) {
  const TemporaryFolder folder;
  std::ofstream(folder / "plant.l") << "#axiom A\n#rules\nA -> F[+(bend)A]F\n";
  const std::string text = R"j({"meristem": 1, "variables": {"bend": 20},
    "components": {"weed": {"type": "lsystem", "file": "plant.l", "steps": 3}}})j";
  EXPECT_EQ(warnings_of(read(text, {}, (folder / "weed.json").string())), "");
}

TEST(Variables, BeyondTheirOwnRangeAreWarnings) {
  const std::string text = with(R"("age": {"value": 12, "min": 1, "max": 40})", "age/10");
  EXPECT_EQ(warnings_of(read(text)), "");
  EXPECT_EQ(warnings_of(read(text, {"age=50"})),
            "--set age: variables.age.value: 'age' is 50, beyond its range of 1 to 40\n");
}

TEST(Variables, ThatWereSetAreToldWhereTheyBreakARule) {
  const std::string text =
      with(R"("age": {"value": 1, "min": 1, "max": 400}, "tall": {"value": "age", "private": true}, "wide": 2)",
           "tall*wide");
  EXPECT_EQ(errors_of(text, {"age=200", "wide=3"}),
            "d.json:3:51: components.leaf.length: the expression's value 600 is out of range for 'length' (age is 200; "
            "wide is 3); expected a number (m) from 0.0001 to 100");
  EXPECT_NE(errors_of(text, {"age=1000"}).find("(age is 1000, beyond 1 to 400)"), std::string::npos);
  // What nobody set is as its author meant it.
  EXPECT_EQ(errors_of(with(R"("wide": 600)", "wide")).find("(wide"), std::string::npos);
}

}  // namespace meristem::variables_test
