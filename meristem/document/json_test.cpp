// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/json.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace meristem::json_test {

/// "line:column: message; expected ...", as users read it.
std::string error_of(std::string_view text, const SizeLimits& limits = {}) {
  try {
    parse_json(text, limits);
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().size(), 1U);
    return error.what();
  }
  return "no fault";
}

TEST(Json, ReadsEveryKindOfValueInOrder) {
  const Value value = parse_json(R"({"z": null, "a": [true, false, -1.5e2], "text": "\u00e4\n\ud83c\udf31"})");
  const Value expected =
      Value::Object{{"z", Value()}, {"a", Value::List{true, false, -150.0}}, {"text", "\xC3\xA4\n\xF0\x9F\x8C\xB1"}};
  EXPECT_EQ(value, expected);
}

TEST(Json, SkipsCommentsAndAByteOrderMark) {
  EXPECT_EQ(parse_json("\xEF\xBB\xBF// head\n[1, /* two */ 2] // tail"), Value(Value::List{1.0, 2.0}));
  EXPECT_EQ(parse_json(R"("// no comment")"), Value("// no comment"));
}

TEST(Json, SaysWhereTheSyntaxBreaksAndWhatWasExpected) {
  EXPECT_EQ(error_of(R"({"a": 1 "b": 2})"), "1:9: unexpected string literal; expected ',' or '}'");
  EXPECT_EQ(error_of("[1,\n  2,, 3]"), "2:5: unexpected ','; expected a value");
  EXPECT_EQ(error_of(R"({"a" 1})"), "1:6: unexpected number literal; expected ':'");
  EXPECT_EQ(error_of(R"({"a": 1,})"), "1:9: unexpected '}'; expected a key in quotes");
  EXPECT_EQ(error_of("[1 2]"), "1:4: unexpected number literal; expected ',' or ']'");
  EXPECT_EQ(error_of("[1] [2]"), "1:5: unexpected '['; expected end of input");
  EXPECT_EQ(error_of(""), "1:1: unexpected end of input; expected a value");
  EXPECT_EQ(error_of("[tru]"), "1:5: invalid literal");
  EXPECT_EQ(error_of("[-x]"), "1:3: invalid number; expected digit after '-'");
  EXPECT_EQ(error_of(R"(["a)"), "1:4: invalid string: missing closing quote");
  EXPECT_EQ(error_of(R"(["\q"])"), "1:4: invalid string: forbidden character after backslash");
  EXPECT_EQ(error_of("[/* "), "1:5: invalid comment; missing closing '*/'");
}

TEST(Json, CountsColumnsInCharacters) {
  EXPECT_EQ(error_of("[\"\xC3\xA4\xC3\xA4\", ]"), "1:8: unexpected ']'; expected a value");
}

TEST(Json, RejectsTextThatIsNotUtf8WithoutRepeatingIt) {
  EXPECT_EQ(error_of("[\"a\xFF\"]"), "1:4: invalid string: ill-formed UTF-8 byte");
  EXPECT_EQ(error_of("[\"\xC0\xAF\"]"), "1:3: invalid string: ill-formed UTF-8 byte");
  EXPECT_EQ(error_of("[\xFF]"), "1:2: invalid literal");
}

TEST(Json, RejectsAByteThatTheParserTakesForTheEnd) {
  EXPECT_EQ(error_of(std::string_view("[1, // \0 2]\n3]", 15)), "1:8: a byte 0x00; expected text in UTF-8 without it");
  EXPECT_EQ(error_of(std::string_view("[1]\0 2", 6)), "1:4: a byte 0x00; expected text in UTF-8 without it");
}

TEST(Json, RejectsNumbersThatADoubleCannotHold) {
  EXPECT_EQ(error_of("[1,\n 1e999]"), "2:2: the number 1e999 is too large");
  EXPECT_EQ(parse_json("1e-999"), Value(0.0));
}

TEST(Json, RejectsAKeyGivenTwiceAtItsSecondPlace) {
  EXPECT_EQ(error_of("{\"a\": {\"b\": 1,\n  \"c\": 2, \"b\": 3}}"),
            "2:11: a.b: the key 'b' is given twice in one object; expected each key once");
  EXPECT_EQ(error_of(R"([{"a": 1, "\u0061": 2}])"),
            "1:11: [0].a: the key 'a' is given twice in one object; expected each key once");
}

TEST(Json, RejectsKeysOfAThousandBytes) {
  EXPECT_EQ(error_of("{\"" + std::string(1001, 'k') + "\": 1}"),
            "1:1: a key is 1001 bytes long; expected at most 1000");
}

TEST(Json, RejectsNestingPastTheLimitWhereItPasses) {
  const SizeLimits limits{.nesting = 3};
  EXPECT_EQ(parse_json("[[[1]]]", limits), Value(Value::List{Value(Value::List{Value(Value::List{1.0})})}));
  EXPECT_EQ(error_of("[[\n [[1]]]]", limits),
            "2:3: [0][0][0]: lists and objects are nested deeper than 3 levels; expected a flatter document");
}

TEST(Json, AnswersForMillionsOfBrackets) {
  for (const char* bracket : {"[", "{\"a\":", "[{\"a\":"}) {
    std::string text;
    while (text.size() < 4'000'000) text += bracket;
    EXPECT_NE(error_of(text).find("nested deeper than 64 levels"), std::string::npos);
  }
}

TEST(Json, RejectsTextPastTheLimitOfBytes) {
  EXPECT_EQ(error_of("[1, 2]", {.document_bytes = 5}), "the text has 6 bytes; expected at most 5");
}

TEST(Json, WritesACanonicalForm) {
  const Value value = Value::Object{{"seed", 7},
                                    {"x", 0.1},
                                    {"list", Value::List{Value::List{0, 1}, Value::List{0.5, 2}}},
                                    {"empty", Value::Object{}},
                                    {"objects", Value::List{Value::Object{{"a", true}}, Value()}}};
  EXPECT_EQ(write_json(value), R"({
  "seed": 7,
  "x": 0.1,
  "list": [[0, 1], [0.5, 2]],
  "empty": {},
  "objects": [
    {
      "a": true
    },
    null
  ]
}
)");
  EXPECT_EQ(write_json_line(value),
            R"({"seed": 7, "x": 0.1, "list": [[0, 1], [0.5, 2]], "empty": {}, "objects": [{"a": true}, null]})");
}

TEST(Json, WritesWholeNumbersWithoutAPoint) {
  EXPECT_EQ(write_json_line(Value::List{9007199254740992.0, -3.0, 1e300, 1e-7}),
            "[9007199254740992, -3, 1e+300, 1e-07]");
  EXPECT_EQ(write_json_line(Value::List{INFINITY, NAN}), "[null, null]");
}

/// A tree of random depth with every kind of value, its texts of any character from U+0001 to U+00FF.
Value random_value(int depth) {
  const int kind = *rc::gen::inRange(0, depth > 0 ? 6 : 4);
  const auto text = [] {
    std::string out;
    for (const int c : *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 256))) {
      if (c >= 0x80) out += static_cast<char>(0xC0 | c >> 6);
      out += static_cast<char>(c < 0x80 ? c : 0x80 | (c & 0x3F));
    }
    return out;
  };
  if (kind == 0) return {};
  if (kind == 1) return *rc::gen::arbitrary<bool>();
  if (kind == 2) return *rc::gen::arbitrary<double>();
  if (kind == 3) return text();
  const int count = *rc::gen::inRange(0, 4);
  Value::List list;
  Value::Object object;
  for (int k = 0; k < count; ++k) {
    if (kind == 4) list.push_back(random_value(depth - 1));
    if (kind == 5) object.emplace_back(text() + std::to_string(k), random_value(depth - 1));
  }
  return kind == 4 ? Value(std::move(list)) : Value(std::move(object));
}

TEST(Json, ReadsBackWhatItWrites) {
  EXPECT_TRUE(rc::check([] {
    const Value value = random_value(4);
    RC_ASSERT(parse_json(write_json(value)) == value);
    RC_ASSERT(parse_json(write_json_line(value)) == value);
    RC_ASSERT(write_json_line(value).find('\n') == std::string::npos);
  }));
}

}  // namespace meristem::json_test
