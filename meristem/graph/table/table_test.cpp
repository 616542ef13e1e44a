// SPDX-License-Identifier: Apache-2.0
// What each kind of row reads, shows and rejects.
#include "meristem/graph/table/table.h"

#include <cmath>
#include <initializer_list>

#include <gtest/gtest.h>

namespace meristem::table_test {

struct Petal {
  double length = 2;
  int veins = 3;
};

struct Flower {
  double height = 0.5;
  float turn = 1.0471976F;  // 60°
  std::optional<double> age;
  int petals = 5;
  std::uint64_t seed = 7;
  bool open = true;
  std::string name = "daisy";
  enum class Kind { single, double_flower } kind = Kind::single;
  Vec3 bend{0, 0.5F, 0};
  std::optional<Vec3> target;
  Vec3 colour{1, 0.5F, 0};
  std::optional<Vec3> edge;
  Curve outline{{{0, 1}, {1, 0}}, CurveKind::linear};
  std::vector<Vec2> profile{{0, 1}, {2, 3}};
  std::vector<Vec2> side{{0, 1}, {1, -2}};
  std::vector<int> size{4, 6};
  std::optional<SiteCondition> where;
  std::optional<ParameterFormula> wave;
  std::optional<InstanceSelection> omit;
  Petal petal;
  std::optional<Petal> sepal;
  std::vector<Petal> whorls{Petal{}, Petal{.length = 4, .veins = 1}};
};

const ParameterTable& petal_table() {
  static const ParameterTable table = Table<Petal>("a petal", "One petal.")
                                          .number("length", &Petal::length, {.min = 0, .max = 10}, "Length.")
                                          .integer("veins", &Petal::veins, {.min = 1, .max = 9}, "Veins.")
                                          .shorthand("length");
  return table;
}

const ParameterTable& flower_table() {
  static const ParameterTable table =
      Table<Flower>("a flower", "A flower.")
          .number("height", &Flower::height, {.unit = Unit::metre, .min = 0, .max = 1, .above_min = true}, "Height.")
          .number("turn", &Flower::turn, {.unit = Unit::degree, .min = -360, .max = 360}, "Turn.")
          .number("age", &Flower::age, {.min = 0}, "Age.")
          .integer("petals", &Flower::petals, {.min = 1, .max = 50}, "Petals.")
          .integer("seed", &Flower::seed, {.min = 0, .max = 9007199254740992}, "Seed.")
          .boolean("open", &Flower::open, "Open.")
          .text("name", &Flower::name, "Name.")
          .choice("kind", &Flower::kind, {"single", "double"}, "Kind.")
          .vector("bend", &Flower::bend, {.unit = Unit::degree, .min = -90, .max = 90}, "Bend.")
          .vector("target", &Flower::target, {}, "Target.")
          .colour("colour", &Flower::colour, "Colour.")
          .colour("edge", &Flower::edge, "Colour of the edge.")
          .curve("outline", &Flower::outline, "Outline.")
          .points("profile", &Flower::profile, {.min = 0, .max = 9}, "Profile.")
          .points("side", &Flower::side, {.min = 0, .max = 1}, "Side.")
          .second(-2, 2)
          .integers("size", &Flower::size, 2, {.min = 1, .max = 99}, "Size.")
          .condition("where", &Flower::where, {"u", "order"}, "Where.")
          .formula("wave", &Flower::wave, {"s", "u"}, "Wave.")
          .selection("omit", &Flower::omit, "Omit.")
          .object("petal", &Flower::petal, petal_table, "Petal.")
          .object("sepal", &Flower::sepal, petal_table, "Sepal.")
          .list("whorls", &Flower::whorls, petal_table, "Whorls.");
  return table;
}

struct Read {
  Flower flower;
  std::vector<Diagnostic> errors;
};

Read read(const Value& value, std::vector<ExpressionNames::Constant> variables = {}) {
  Read result;
  ParameterReader reader(std::move(variables), SizeLimits{});
  const DocumentPath top;
  reader.read(flower_table(), &result.flower, value, DocumentPath(top, "flower"));
  result.errors = reader.take_diagnostics();
  return result;
}

Read read_member(const char* name, Value value) { return read(Value::Object{{name, std::move(value)}}); }

Flower good(const char* name, Value value) {
  Read result = read_member(name, std::move(value));
  EXPECT_TRUE(result.errors.empty()) << result.errors[0].text();
  return result.flower;
}

Value shown(const char* name, const Flower& flower = {}) { return flower_table().find(name)->show(&flower); }

// Returns the single fault of a member, which must lie at `path`.
Diagnostic error(const char* name, Value value, std::string_view path) {
  const Read result = read_member(name, std::move(value));
  EXPECT_EQ(result.errors.size(), 1U) << name;
  if (result.errors.empty()) return {};
  EXPECT_EQ(result.errors[0].path, path) << result.errors[0].text();
  return result.errors[0];
}

TEST(Table, NumbersAreReadInDocumentUnits) {
  EXPECT_EQ(good("height", 0.25).height, 0.25);
  EXPECT_FLOAT_EQ(good("turn", 90).turn, static_cast<float>(kPi / 2));
  EXPECT_EQ(good("petals", 8).petals, 8);
  EXPECT_EQ(good("seed", 9007199254740992.0).seed, 9007199254740992U);
  EXPECT_EQ(good("age", 3).age, 3);
  EXPECT_EQ(good("age", 3).petals, Flower{}.petals);
}

TEST(Table, DefaultsAreShownAsDocumentsWriteThem) {
  EXPECT_EQ(shown("height"), Value(0.5));
  EXPECT_EQ(shown("turn"), Value(60.0));
  EXPECT_TRUE(shown("age").is_null());
  EXPECT_EQ(shown("petals"), Value(5));
  EXPECT_EQ(shown("open"), Value(true));
  EXPECT_EQ(shown("name"), Value("daisy"));
  EXPECT_EQ(shown("kind"), Value("single"));
  EXPECT_EQ(shown("bend"), Value(Value::List{0, 28.64789, 0}));
  EXPECT_TRUE(shown("target").is_null());
  EXPECT_EQ(shown("colour"), Value("#ff8000"));
  EXPECT_TRUE(shown("edge").is_null());
  EXPECT_EQ(shown("outline"),
            Value(Value::Object{{"curve", Value::List{Value::List{0, 1}, Value::List{1, 0}}}, {"kind", "linear"}}));
  EXPECT_EQ(shown("profile"), Value(Value::List{Value::List{0, 1}, Value::List{2, 3}}));
  EXPECT_EQ(shown("size"), Value(Value::List{4, 6}));
  EXPECT_TRUE(shown("where").is_null());
  EXPECT_TRUE(shown("omit").is_null());
  EXPECT_EQ(shown("petal"), Value(Value::Object{{"length", 2}, {"veins", 3}}));
  EXPECT_TRUE(shown("sepal").is_null());
  EXPECT_EQ(shown("whorls"),
            Value(Value::List{Value::Object{{"length", 2}, {"veins", 3}}, Value::Object{{"length", 4}, {"veins", 1}}}));
}

TEST(Table, WhatIsShownIsReadBackAsItWas) {
  const Value::Object written{
      {"height", 0.25},
      {"turn", -90},
      {"age", 2},
      {"kind", "double"},
      {"bend", Value::List{10, -20, 30}},
      {"target", Value::List{1, 2, 3}},
      {"edge", "#6b8e23"},
      {"outline", Value::Object{{"curve", Value::List{Value::List{0, 0}, Value::List{0.5, 1}}}}},
      {"where", "order == 1 && u < 0.5"},
      {"omit", Value::List{0, Value::List{3, 5}, "i % 4 == 2"}},
      {"sepal", Value::Object{{"length", 1}, {"veins", 2}}},
      {"whorls", Value::List{Value::Object{{"length", 5}, {"veins", 9}}}}};
  const Read result = read(written);
  ASSERT_TRUE(result.errors.empty()) << result.errors[0].text();
  for (const auto& [name, value] : written) EXPECT_EQ(shown(name.c_str(), result.flower), value) << name;
}

TEST(Table, DefaultsComeFromTheStruct) {
  const std::vector<Value> defaults = flower_table().defaults();
  ASSERT_EQ(defaults.size(), flower_table().parameters.size());
  EXPECT_EQ(defaults[0], Value(0.5));
  EXPECT_EQ(defaults[3], Value(5));
}

TEST(Table, AMemberOfTheWrongKindIsNamedWithWhatIsExpected) {
  const Value::Object wrong{{"height", true},
                            {"petals", Value::List{}},
                            {"open", 1},
                            {"name", 3},
                            {"kind", false},
                            {"bend", 4},
                            {"target", Value::List{1}},
                            {"colour", 7},
                            {"outline", 1},
                            {"profile", "flat"},
                            {"size", Value::List{1, 2, 3}},
                            {"where", 1},
                            {"omit", "all"},
                            {"whorls", Value::Object{}}};
  for (const auto& [name, value] : wrong) {
    const Diagnostic found = error(name.c_str(), value, "flower." + name);
    EXPECT_NE(found.message.find("'" + name + "'"), std::string::npos) << found.text();
    EXPECT_FALSE(found.expected.empty()) << found.text();
  }
  EXPECT_EQ(error("petal", Value::List{}, "flower.petal").message,
            "'length' is one number (only those of components vary) and cannot be an empty list");
  EXPECT_EQ(error("height", true, "flower.height").text(),
            "flower.height: 'height' cannot be true; expected a number (m) above 0 to 1");
}

TEST(Table, NumbersOutOfRangeAreRejected) {
  EXPECT_EQ(error("height", 0, "flower.height").message, "the value 0 is out of range for 'height'");
  error("height", 1.5, "flower.height");
  error("turn", -361, "flower.turn");
  error("age", -0.1, "flower.age");
  error("petals", 51, "flower.petals");
  error("petals", 2.5, "flower.petals");
  error("bend", Value::List{0, 91, 0}, "flower.bend[1]");
  error("size", Value::List{0, 5}, "flower.size[0]");
  error("profile", Value::List{Value(Value::List{1, 10})}, "flower.profile[0][1]");
  EXPECT_EQ(good("turn", 360).turn, static_cast<float>(2 * kPi));  // the bound itself is allowed
}

TEST(Table, SecondNumbersOfPointsHaveARangeOfTheirOwn) {
  const auto points = [](double first, double second) { return Value::List{Value(Value::List{first, second})}; };
  EXPECT_EQ(good("side", points(1, -2)).side[0], Vec2(1, -2));
  EXPECT_EQ(error("side", points(1.445, 0), "flower.side[0][0]").message, "the value 1.445 is out of range for 'side'");
  error("side", points(-0.1, 0), "flower.side[0][0]");
  EXPECT_EQ(error("side", points(1, 2.5), "flower.side[0][1]").expected, "a number from -2 to 2");
  EXPECT_EQ(flower_table().find("side")->expectation(),
            "a list of pairs of a number from 0 to 1 and a number from -2 to 2");
}

TEST(Table, NumbersThatDoNotFitAFloatAreRejectedWhereAFloatIsStored) {
  error("target", Value::List{0, 1e300, 0}, "flower.target[1]");
  error("outline", Value::Object{{"curve", Value::List{Value(Value::List{0, 1e300})}}}, "flower.outline.curve[0][1]");
}

TEST(Table, AnUnknownNameIsReportedWithTheNearestOne) {
  const Diagnostic found = error("heigth", 1, "flower.heigth");
  EXPECT_EQ(found.message, "'heigth' is not a parameter of a flower");
  EXPECT_EQ(found.nearest, "height");
  EXPECT_EQ(found.text_offset, kAtName);
  EXPECT_EQ(error("petal", Value::Object{{"lenght", 1}}, "flower.petal.lenght").nearest, "length");
  const Diagnostic strange = error("zzzzzz", 1, "flower.zzzzzz");
  EXPECT_TRUE(strange.nearest.empty());
  EXPECT_NE(strange.expected.find("one of height, turn"), std::string::npos);
}

TEST(Table, AnUnknownChoiceIsReportedWithTheNearestOne) {
  EXPECT_EQ(good("kind", "double").kind, Flower::Kind::double_flower);
  const Diagnostic found = error("kind", "dubble", "flower.kind");
  EXPECT_EQ(found.nearest, "double");
  EXPECT_EQ(found.expected, "one of single, double");
}

TEST(Table, ColoursAreSixHexadecimalDigits) {
  const Vec3 colour = good("colour", "#6B8e23").colour;
  EXPECT_EQ(colour, Vec3(0x6b, 0x8e, 0x23) / 255.0F);
  for (const char* wrong : {"6b8e23", "#6b8e2", "#6b8e234", "#6b8e2g", "red", ""})
    error("colour", wrong, "flower.colour");
}

TEST(Table, CurvesNeedPointsThatRiseWithinZeroToOne) {
  const auto curve = [](std::initializer_list<Value::List> points) {
    return Value(Value::Object{{"curve", Value::List(points.begin(), points.end())}});
  };
  EXPECT_EQ(good("outline", curve({{0, 0}, {1, 2}})).outline, Curve({{0, 0}, {1, 2}}));
  error("outline", curve({{0.5, 0}, {0.5, 1}}), "flower.outline.curve[1]");
  error("outline", curve({{0, 0}, {1.5, 1}}), "flower.outline.curve[1]");
  error("outline", curve({}), "flower.outline.curve");
  error("outline", curve({{0, 0, 0}}), "flower.outline.curve[0]");
  EXPECT_EQ(error("outline", Value::Object{{"curve", Value::List{Value(Value::List{0, 1})}}, {"kind", "splin"}},
                  "flower.outline.kind")
                .nearest,
            "spline");
  error("outline", Value::Object{{"curv", Value::List{Value(Value::List{0, 1})}}}, "flower.outline.curv");
  error("outline", Value::Object{}, "flower.outline");
}

TEST(Table, ConditionsAreExpressionsOverTheirNames) {
  EXPECT_EQ(good("where", "u < order").where->text, "u < order");
  const Diagnostic found = error("where", "u < oder", "flower.where");
  EXPECT_EQ(found.nearest, "order");
  EXPECT_EQ(found.text_offset, 4);
}

TEST(Table, FormulasAreNumbersOrExpressionsOverTheirNames) {
  const std::vector<double> names{3, 0.5};
  EXPECT_EQ(good("wave", "s*u").wave->expression.evaluate(names), 1.5);
  EXPECT_EQ(good("wave", 0.1).wave->expression.evaluate(names), 0.1);
  EXPECT_EQ(good("wave", -1e-20).wave->expression.evaluate(names), -1e-20);
  EXPECT_EQ(error("wave", "s*v", "flower.wave").text_offset, 2);
  EXPECT_NE(error("wave", true, "flower.wave").expected.find("a number, or an expression over s, u"),
            std::string::npos);
}

TEST(Table, SelectionsHoldNumbersRangesAndConditions) {
  const InstanceSelection selection = *good("omit", Value::List{0, Value::List{3, 5}, "i % 10 == 9"}).omit;
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t i = 0; i < 20; ++i) {
    Site site;
    site.i = i;
    if (selection.contains(site, 0)) chosen.push_back(i);
  }
  EXPECT_EQ(chosen, (std::vector<std::uint32_t>{0, 3, 4, 5, 9, 19}));
  for (const char* const no_answer : {"1 / (0*i)", "0 / (0*i)"}) {
    EXPECT_FALSE(good("omit", Value::List{no_answer}).omit->contains(Site(), 0)) << no_answer;
  }
  error("omit", Value::List{-1}, "flower.omit[0]");
  error("omit", Value::List{1, 2.5}, "flower.omit[1]");
  error("omit", Value::List{Value(Value::List{1, 2, 3})}, "flower.omit[0]");
  error("omit", Value::List{Value(Value::List{5, 3})}, "flower.omit[0]");
  error("omit", Value::List{"i ="}, "flower.omit[0]");
}

TEST(Table, ABareValueSetsTheShorthand) {
  EXPECT_EQ(good("petal", 7).petal.length, 7);
  EXPECT_EQ(good("petal", Value::Object{{"veins", 4}}).petal.veins, 4);
  EXPECT_EQ(good("sepal", 1).sepal->veins, 3);
  error("petal", 11, "flower.petal");
}

TEST(Table, ListsReadEachElementAndReportItsIndex) {
  const Flower flower = good("whorls", Value::List{1, Value::Object{{"veins", 2}}});
  ASSERT_EQ(flower.whorls.size(), 2U);
  EXPECT_EQ(flower.whorls[0].length, 1);
  EXPECT_EQ(flower.whorls[1].veins, 2);
  error("whorls", Value::List{1, Value::Object{{"veins", 99}}}, "flower.whorls[1].veins");
}

TEST(Table, ExpressionsOfVariablesStandForFixedNumbers) {
  const Read result =
      read(Value::Object{{"height", "age / 10"}, {"turn", "45 * 2"}, {"petals", "age * 1.5"}}, {{"age", 5}});
  ASSERT_TRUE(result.errors.empty()) << result.errors[0].text();
  EXPECT_EQ(result.flower.height, 0.5);
  EXPECT_FLOAT_EQ(result.flower.turn, static_cast<float>(kPi / 2));
  EXPECT_EQ(result.flower.petals, 8);  // 7.5, rounded
}

TEST(Table, WhatDiffersBetweenInstancesIsRejectedForPlainStructs) {
  for (const Value& value : {Value("0.1 * i"), Value("rand()"), Value(Value::List{0.1, 0.2}),
                             Value(Value::Object{{"range", Value::List{0.1, 0.2}}})}) {
    EXPECT_EQ(error("height", value, "flower.height").message.find("'height' is one number (only those of components"),
              0U);
  }
}

TEST(Table, ExpressionsWithoutAFiniteValueAreRejected) {
  EXPECT_EQ(error("height", "0 / 0", "flower.height").message.find("the expression's value"), 0U);
  error("height", "log(0)", "flower.height");
  error("age", "1 / 0", "flower.age");
  EXPECT_EQ(error("height", "0.1 +", "flower.height").text_offset, 5);
}

struct Pair {
  double a = 0;
  double b = 0;
  double c = 0;
};

std::vector<Diagnostic> pair_errors(const Value& value) {
  static const ParameterTable table =
      Table<Pair>("a pair", "Two of three.")
          .number("a", &Pair::a, {.min = 0, .max = 9}, "A.")
          .required()
          .number("b", &Pair::b, {}, "B.")
          .number("c", &Pair::c, {}, "C.")
          .one_of({"b", "c"})
          .elsewhere({"type"})
          .check([](const Pair& pair, const DocumentPath& path, ParameterReader& reader) {
            if (pair.a > 5) reader.add_error(DocumentPath(path, "a"), "too large");
          });
  Pair pair;
  ParameterReader reader({}, SizeLimits{});
  reader.read(table, &pair, value, DocumentPath());
  return reader.take_diagnostics();
}

TEST(Table, RequiredMembersAndExactlyOneOfAGroup) {
  EXPECT_TRUE(pair_errors(Value::Object{{"a", 1}, {"b", 2}, {"type", "x"}}).empty());
  const auto missing = pair_errors(Value::Object{{"c", 2}});
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_EQ(missing[0].message, "a pair has no 'a'");
  const auto none = pair_errors(Value::Object{{"a", 1}});
  ASSERT_EQ(none.size(), 1U);
  EXPECT_EQ(none[0].message, "a pair has none of b, c");
  const auto both = pair_errors(Value::Object{{"a", 1}, {"b", 1}, {"c", 1}});
  ASSERT_EQ(both.size(), 1U);
  EXPECT_EQ(both[0].message, "a pair has more than one of b, c");
  EXPECT_EQ(pair_errors(3).at(0).message, "a pair cannot be the number 3");
}

TEST(Table, RulesAreCheckedOnlyWhenAllCouldBeRead) {
  EXPECT_EQ(pair_errors(Value::Object{{"a", 6}, {"b", 1}}).at(0).message, "too large");
  const auto errors = pair_errors(Value::Object{{"a", 6}, {"b", "?"}});
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "b");
}

struct Sum {
  double a = 1, b = 2, sum = 0;
};

TEST(Table, WhatFollowsFromSeveralParametersIsPreparedOnceTheyHold) {
  static const ParameterTable table =
      Table<Sum>("a sum", "A sum of two numbers.")
          .number("a", &Sum::a, {.min = 0}, "A.")
          .number("b", &Sum::b, {}, "B.")
          .check([](const Sum& sum, const DocumentPath& path, ParameterReader& reader) {
            if (sum.b < 0) reader.add_error(DocumentPath(path, "b"), "below 0");
          })
          .prepare([](Sum& sum, const DocumentPath&, ParameterReader&) { sum.sum = sum.a + sum.b; });
  const auto sum_of = [](const Value& value) {
    Sum sum;
    ParameterReader reader({}, SizeLimits{});
    reader.read(table, &sum, value, DocumentPath());
    return sum.sum;
  };
  EXPECT_EQ(sum_of(Value::Object{{"a", 5}}), 7);
  EXPECT_EQ(sum_of(Value::Object{{"b", -1}}), 0);
  EXPECT_EQ(sum_of(Value::Object{{"a", -1}}), 0);
}

TEST(Table, TellsWhichRowsAValueGave) {
  Flower flower;
  ParameterReader reader({}, SizeLimits{});
  const DocumentPath top;
  const Value value = Value::Object{{"petals", 9}, {"sepal", 3}, {"colour", "#000000"}};
  const GivenRows given = reader.read(flower_table(), &flower, value, top);
  EXPECT_EQ(given.count(), 3U);
  EXPECT_TRUE(given.contains("petals") && given.contains("sepal") && given.contains("colour"));
  EXPECT_FALSE(given.contains("height") || given.contains("length"));
  EXPECT_TRUE(reader.read(flower_table(), &flower, Value::Object{}, top).is_empty());
  EXPECT_TRUE(reader.read(petal_table(), &flower.petal, 3, top).contains("length"));  // by the shorthand
  EXPECT_EQ(reader.error_count(), 0U);
}

TEST(Table, CopiesTheRowsThatWereGivenAndNoOthers) {
  Flower flower, other;
  other.height = 0.25;
  other.name = "rose";
  ParameterReader reader({}, SizeLimits{});
  const DocumentPath top;
  const Value value = Value::Object{{"petals", 9}, {"sepal", 3}, {"whorls", Value::List{1}}, {"where", "u > 1"}};
  reader.read(flower_table(), &flower, value, top).copy(&flower, &other);
  EXPECT_EQ(other.height, 0.25);
  EXPECT_EQ(other.name, "rose");
  EXPECT_EQ(other.petals, 9);
  ASSERT_TRUE(other.sepal && other.where);
  EXPECT_EQ(other.sepal->length, 3);
  EXPECT_EQ(other.whorls.size(), 1U);
  EXPECT_EQ(other.where->text, "u > 1");
}

TEST(Reader, CountsTheFaultsThatItNoLongerKeeps) {
  SizeLimits limits;
  limits.diagnostics = 3;
  ParameterReader reader({}, limits);
  Flower flower;
  Value::Object members;
  for (int k = 0; k < 10; ++k) members.emplace_back("wrong" + std::to_string(k), k);
  reader.read(flower_table(), &flower, members, DocumentPath());
  EXPECT_EQ(reader.error_count(), 10U);
  EXPECT_EQ(reader.diagnostics().size(), 3U);
}

}  // namespace meristem::table_test
