// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/kinds.h"

#include <gtest/gtest.h>

#include "meristem/graph/table/table.h"

namespace meristem::kinds_test {

struct Snip {
  int at = 1;
  double length = 2;
  std::string path;
};
struct Bend {
  int at = 1;
  double angle = 0.5;
  std::string toward = "north";
  std::string path;
};
struct Garden {
  std::vector<std::variant<Snip, Bend>> work;
  double size = 1;
};

const ElementKinds& work_kinds();

void check_snip(const Snip& snip, const DocumentPath& path, ParameterReader& reader) {
  if (snip.length > snip.at) reader.add_error(DocumentPath(path, "length"), "longer than it has grown");
}
template <class Kind>
void note_place(Kind& kind, const DocumentPath& path, ParameterReader&) {
  kind.path = path.text();
}

const ParameterTable& snip_table() {
  static const ParameterTable table = Table<Snip>("a snip", "Takes something off.")
                                          .integer("at", &Snip::at, {.min = 1, .max = 99}, "When.")
                                          .required()
                                          .number("length", &Snip::length, {.min = 0, .max = 9}, "How much.")
                                          .required()
                                          .elsewhere({"do"})
                                          .check(check_snip)
                                          .prepare(note_place<Snip>);
  return table;
}
const ParameterTable& bend_table() {
  static const ParameterTable table =
      Table<Bend>("a bend", "Turns something.")
          .integer("at", &Bend::at, {.min = 1, .max = 99}, "When.")
          .required()
          .number("angle", &Bend::angle, {.unit = Unit::degree, .min = 0, .max = 90}, "How far.")
          .text("toward", &Bend::toward, "Where to.")
          .elsewhere({"do"})
          .prepare(note_place<Bend>);
  return table;
}
const ElementKinds& work_kinds() {
  static const ElementKinds kinds{.element = "a piece of work",
                                  .doc = "What is done.",
                                  .key = "do",
                                  .key_doc = "Its kind.",
                                  .kinds = {{"snip", snip_table}, {"bend", bend_table}}};
  return kinds;
}
const ParameterTable& work_table() {
  static const ParameterTable table = table_of_kinds(work_kinds());
  return table;
}
const ParameterTable& garden_table() {
  static const ParameterTable table =
      Table<Garden>("a garden", "A garden.")
          .list_of_kinds("work", &Garden::work, work_kinds, work_table, "What is done, in this order.")
          .number("size", &Garden::size, {.min = 0, .max = 9}, "Its size.");
  return table;
}

struct Result {
  Garden garden;
  std::vector<Diagnostic> errors;
};

Result read(Value::List work) {
  Result result;
  ParameterReader reader({}, SizeLimits{});
  const DocumentPath top;
  reader.read(garden_table(), &result.garden, Value::Object{{"work", Value(std::move(work))}},
              DocumentPath(top, "garden"));
  result.errors = reader.take_diagnostics();
  return result;
}

Value snip(int at, double length) { return Value::Object{{"do", "snip"}, {"at", at}, {"length", length}}; }
Value bend(Value angle) { return Value::Object{{"angle", std::move(angle)}, {"at", 3}, {"do", "bend"}}; }

/// The only fault.
Diagnostic error(Value::List work) {
  const Result result = read(std::move(work));
  EXPECT_EQ(result.errors.size(), 1U);
  return result.errors.empty() ? Diagnostic{} : result.errors[0];
}

TEST(Kinds, ElementsAreReadByTheTableOfTheirKind) {
  const Result result = read({snip(5, 4), bend(90), snip(7, 1)});
  ASSERT_TRUE(result.errors.empty()) << result.errors[0].text();
  const auto& work = result.garden.work;
  ASSERT_EQ(work.size(), 3U);
  EXPECT_EQ(std::get<Snip>(work[0]).length, 4);
  EXPECT_NEAR(std::get<Bend>(work[1]).angle, 1.5708, 1e-4);
  EXPECT_EQ(std::get<Bend>(work[1]).toward, "north");
  EXPECT_EQ(std::get<Snip>(work[2]).at, 7);
}

TEST(Kinds, EachKnowsItsPlaceAmongAllOfThem) {
  const Result result = read({snip(5, 4), bend(10), snip(7, 1), bend(20)});
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string path = std::visit([](const auto& one) { return one.path; }, result.garden.work[k]);
    EXPECT_EQ(path, "garden.work[" + std::to_string(k) + "]");
  }
}

TEST(Kinds, FaultsNameTheElementAtFault) {
  // A number that is out of range, and a rule that does not hold, behind an element of the other kind.
  EXPECT_EQ(error({snip(5, 4), bend(91), snip(7, 1)}).path, "garden.work[1].angle");
  EXPECT_EQ(error({bend(9), snip(5, 4), bend(9), snip(3, 4)}).path, "garden.work[3].length");
}

TEST(Kinds, MembersOfAnotherKindAreRefused) {
  const Value mixed = Value::Object{{"do", "bend"}, {"at", 3}, {"length", 2}};
  const Diagnostic found = error({snip(5, 4), mixed});
  EXPECT_EQ(found.path, "garden.work[1].length");
  EXPECT_EQ(found.message, "'length' is not a parameter of a bend");
  EXPECT_NE(found.expected.find("angle"), std::string::npos) << found.expected;
}

TEST(Kinds, EachRequiresItsOwn) {
  const Diagnostic found = error({bend(9), Value::Object{{"do", "snip"}, {"at", 3}}});
  EXPECT_EQ(found.path, "garden.work[1]");
  EXPECT_EQ(found.message, "a snip has no 'length'");
}

TEST(Kinds, AnElementWithoutAKindIsRefused) {
  EXPECT_EQ(error({bend(9), Value::Object{{"at", 3}}}).text(),
            "garden.work[1]: a piece of work has no 'do'; expected one of snip, bend");
  EXPECT_EQ(error({bend(9), 4}).path, "garden.work[1]");
  const Diagnostic unknown = error({bend(9), Value::Object{Value::Member("do", "bent")}});
  EXPECT_EQ(unknown.path, "garden.work[1].do");
  EXPECT_EQ(unknown.nearest, "bend");
}

TEST(Kinds, OneTableHasTheRowsOfAll) {
  const ParameterTable& all = work_table();
  EXPECT_EQ(all.names(), (std::vector<std::string>{"do", "at", "length", "angle", "toward"}));
  EXPECT_EQ(all.find("do")->choices, (std::vector<std::string>{"snip", "bend"}));
  EXPECT_TRUE(all.find("do")->required);
  EXPECT_TRUE(all.find("at")->required);
  EXPECT_FALSE(all.find("length")->required);
  EXPECT_EQ(all.defaults().size(), all.parameters.size());
  EXPECT_EQ(all.defaults()[4], Value("north"));
}

TEST(Kinds, ElementsAreShownAsDocumentsWriteThem) {
  const Value::List work{snip(5, 4), Value::Object{{"do", "bend"}, {"at", 3}, {"angle", 30}, {"toward", "east"}}};
  const Result result = read(work);
  EXPECT_EQ(garden_table().parameters[0].show(&result.garden), Value(work));
}

}  // namespace meristem::kinds_test
