// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/edit/text_edit.h"

#include <string>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/document/json.h"

namespace meristem::text_edit_test {

std::string set(const std::string& text, const std::string& path, const Value& value) {
  return apply_patch(text, set_value(LocatedTree(text), path, value));
}
std::string insert(const std::string& text, const std::string& path, const Value& value,
                   std::optional<std::size_t> index = {}) {
  return apply_patch(text, insert_value(LocatedTree(text), path, value, index));
}
std::string remove(const std::string& text, const std::string& path) {
  return apply_patch(text, remove_value(LocatedTree(text), path));
}
std::string move(const std::string& text, const std::string& path, std::size_t index) {
  return apply_patch(text, move_value(LocatedTree(text), path, index));
}
std::string rename(const std::string& text, const std::string& path, const std::string& name) {
  return apply_patch(text, rename_member(LocatedTree(text), path, name));
}

template <class Edit>
Diagnostic error_of(Edit edit) {
  try {
    edit();
  } catch (const InputError& error) {
    return error.diagnostics()[0];
  }
  return {};
}

const std::string kLeaf = R"(// A leaf.
{
  "meristem": 1,
  "components": {
    // It is green.
    "leaf": {"type": "leaf", "length": 0.10, "width": 0.03},  // in summer
    "stem": {
      "type": "tree",  // straight
      "length": 1
    }
  },
  "links": [
    ["stem", "leaf"]
  ]
}
)";

std::string with(const std::string& before, const std::string& after) {
  std::string text = kLeaf;
  const std::size_t at = text.find(before);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, before.size(), after);
}

TEST(TextEdit, WritesANumberOverAnotherAndNothingElse) {
  EXPECT_EQ(set(kLeaf, "components.leaf.length", 0.12), with("0.10", "0.12"));
  EXPECT_EQ(set(kLeaf, "components.leaf.length", 2.0), with("0.10", "2"));
}

TEST(TextEdit, LeavesAValueAsItIsSpelledWhereItSaysTheSame) {
  EXPECT_TRUE(set_value(LocatedTree(kLeaf), "components.leaf.length", 0.1).empty());
}

TEST(TextEdit, AddsAMemberInTheLineOfItsNeighbours) {
  EXPECT_EQ(set(kLeaf, "components.leaf.curl", "20 + 3"), with("0.03}", "0.03, \"curl\": \"20 + 3\"}"));
}

TEST(TextEdit, AddsAMemberOnALineOfItsOwnWhereItsNeighboursHaveOne) {
  EXPECT_EQ(set(kLeaf, "components.stem.radius", 0.1),
            with("\"length\": 1\n", "\"length\": 1,\n      \"radius\": 0.1\n"));
}

TEST(TextEdit, AddsAllMembersOfAPathThatAreNotThere) {
  EXPECT_EQ(set(kLeaf, "components.leaf.frame.scale", Value::List{1, 2, 3}),
            with("0.03}", "0.03, \"frame\": {\"scale\": [1, 2, 3]}}"));
}

TEST(TextEdit, AddsAComponentLikeTheOthers) {
  EXPECT_EQ(insert(kLeaf, "components.bud", parse_json(R"({"type": "simple"})")),
            with("\"length\": 1\n    }\n", "\"length\": 1\n    },\n    \"bud\": {\"type\": \"simple\"}\n"));
  EXPECT_EQ(insert(kLeaf, "components.bud", parse_json(R"({"type": "simple"})"), 1),
            with("// in summer\n", "// in summer\n    \"bud\": {\"type\": \"simple\"},\n"));
}

TEST(TextEdit, LeavesTheCommentAboveAMemberWithIt) {
  EXPECT_EQ(insert(kLeaf, "components.bud", parse_json(R"({"type": "simple"})"), 0),
            with("\"components\": {\n", "\"components\": {\n    \"bud\": {\"type\": \"simple\"},\n"));
}

TEST(TextEdit, InsertsElementsBeforeTheirIndexAndBehindTheLast) {
  const Value link(Value::List{"leaf", "bud"});
  EXPECT_EQ(insert(kLeaf, "links[0]", link),
            with("[\"stem\", \"leaf\"]", "[\"leaf\", \"bud\"],\n    [\"stem\", \"leaf\"]"));
  const std::string behind = with("[\"stem\", \"leaf\"]", "[\"stem\", \"leaf\"],\n    [\"leaf\", \"bud\"]");
  EXPECT_EQ(insert(kLeaf, "links[1]", link), behind);
  EXPECT_EQ(insert(kLeaf, "links[]", link), behind);
  EXPECT_EQ(insert(kLeaf, "links[0][1]", "x"), with("[\"stem\", \"leaf\"]", "[\"stem\", \"x\", \"leaf\"]"));
}

TEST(TextEdit, BreaksALineThatWouldGetTooLong) {
  const std::string text = "{\n  \"a\": \"" + std::string(100, 'x') + "\", \"b\": 1\n}\n";
  EXPECT_EQ(set(text, "c", 1234), "{\n  \"a\": \"" + std::string(100, 'x') + "\", \"b\": 1,\n  \"c\": 1234\n}\n");
}

TEST(TextEdit, WritesALargeValueInLines) {
  const Value value =
      parse_json("{\"a\": \"" + std::string(60, 'x') + "\", \"b\": {\"c\": \"" + std::string(60, 'y') + "\"}}");
  EXPECT_EQ(set("{\n\t\"u\": 0\n}", "u", value), "{\n\t\"u\": {\n\t\t\"a\": \"" + std::string(60, 'x') +
                                                     "\",\n\t\t\"b\": {\"c\": \"" + std::string(60, 'y') +
                                                     "\"}\n\t}\n}");
  Value::List numbers(50, 1.125);
  EXPECT_EQ(set("{\n  \"u\": 0\n}", "u", numbers).find('\n', 6), 10U);
  EXPECT_EQ(parse_json(set("{\n  \"u\": 0\n}", "u", numbers)).find("u")->list()->size(), 50U);
}

TEST(TextEdit, TakesAMemberOutWithItsLinesAndTheCommentInThem) {
  EXPECT_EQ(remove(kLeaf, "components.leaf"),
            with("    \"leaf\": {\"type\": \"leaf\", \"length\": 0.10, \"width\": 0.03},  // in summer\n", ""));
  EXPECT_EQ(remove(kLeaf, "components.stem.type"), with("      \"type\": \"tree\",  // straight\n", ""));
}

TEST(TextEdit, TakesTheCommaBeforeTheLastMemberOut) {
  EXPECT_EQ(remove(kLeaf, "components.stem.length"),
            with("\"tree\",  // straight\n      \"length\": 1", "\"tree\"  // straight"));
  EXPECT_EQ(remove("[1, /* two */ 2]", "[1]"), "[1 /* two */]");
}

TEST(TextEdit, TakesAMemberOutOfALine) {
  EXPECT_EQ(remove(kLeaf, "components.leaf.length"), with("\"length\": 0.10, ", ""));
  EXPECT_EQ(remove(kLeaf, "components.leaf.width"), with(", \"width\": 0.03", ""));
  EXPECT_EQ(remove("{\"a\": [1, 2,\n 3]}", "a[1]"), "{\"a\": [1,\n 3]}");
  EXPECT_EQ(remove("{\"a\": [ 1 /* one */, 2]}", "a[0]"), "{\"a\": [ 2]}");
}

TEST(TextEdit, LeavesNoBlanksInWhatIsEmptyThen) {
  EXPECT_EQ(remove(kLeaf, "links[0]"), with("[\n    [\"stem\", \"leaf\"]\n  ]", "[]"));
  EXPECT_EQ(remove("{\n  // none\n  \"a\": 1  // one\n}", "a"), "{\n  // none\n}");
}

TEST(TextEdit, KeepsTheEndOfACommentsLine) {
  EXPECT_EQ(remove("[1, // one\n 2]", "[1]"), "[1 // one\n ]");
  EXPECT_EQ(insert("[1 // one\n]", "[1]", 2), "[1, // one\n  2\n]");
  EXPECT_EQ(move("{\n  \"a\": 1, // one\n  \"b\": 2}", "a", 1), "{\n  \"b\": 2,\n  \"a\": 1 // one\n}");
}

TEST(TextEdit, FillsWhatIsEmpty) {
  EXPECT_EQ(set("{}", "a", 1), "{\n  \"a\": 1\n}");
  EXPECT_EQ(set("{\n  \"a\": { }\n}", "a.b", 1), "{\n  \"a\": {\"b\": 1}\n}");
  EXPECT_EQ(set("{\n  \"a\": {}\n}", "a.b", Value::Object{}), "{\n  \"a\": {\n    \"b\": {}\n  }\n}");
  EXPECT_EQ(insert("{\n  \"a\": [\n    // none\n  ]\n}", "a[]", 1), "{\n  \"a\": [\n    // none\n    1\n  ]\n}");
}

TEST(TextEdit, MovesAMemberWithTheCommentInItsLine) {
  EXPECT_EQ(move("{\n  \"a\": 1, // one\n  \"b\": 2, // two\n  \"c\": 3 // three\n}\n", "c", 0),
            "{\n  \"c\": 3, // three\n  \"a\": 1, // one\n  \"b\": 2 // two\n}\n");
  EXPECT_EQ(move("{\n  \"a\": 1, // one\n  \"b\": 2, // two\n  \"c\": 3 // three\n}\n", "a", 2),
            "{\n  \"b\": 2, // two\n  \"c\": 3, // three\n  \"a\": 1 // one\n}\n");
  EXPECT_EQ(move("[1.0, 2, 3e0]", "[2]", 0), "[3e0, 1.0, 2]");
  EXPECT_EQ(move("[1.0, 2, 3e0]", "[0]", 1), "[2, 1.0, 3e0]");
}

TEST(TextEdit, MovesAMemberWithTheNoteAboveIt) {
  const std::string text =
      "{\n  // the first\n  \"a\": 1, // one\n  \"b\": 2,\n\n  // the last,\n  /* of all */\n  \"c\": 3\n}\n";
  EXPECT_EQ(move(text, "a", 1),
            "{\n  \"b\": 2,\n  // the first\n  \"a\": 1, // one\n\n  // the last,\n  /* of all */\n  \"c\": 3\n}\n");
  EXPECT_EQ(move(text, "c", 0),
            "{\n  // the last,\n  /* of all */\n  \"c\": 3,\n  // the first\n  \"a\": 1, // one\n  \"b\": 2\n\n}\n");
  // A comment separated by an empty line does not belong to the member, and neither does a comment above several
  // members.
  EXPECT_EQ(move("{\n  // all\n\n  \"a\": 1,\n  \"b\": 2\n}\n", "b", 0), "{\n  \"b\": 2,\n  // all\n\n  \"a\": 1\n}\n");
  EXPECT_EQ(move("{\n  // both\n  \"a\": 1, \"b\": 2\n}\n", "a", 1), "{\n  // both\n  \"b\": 2,\n  \"a\": 1\n}\n");
}

TEST(TextEdit, RenamesAMember) {
  EXPECT_EQ(rename(kLeaf, "components.leaf", "foliage"), with("\"leaf\": {", "\"foliage\": {"));
  EXPECT_EQ(error_of([] { rename(kLeaf, "components.leaf", "stem"); }).message, "there is a 'stem' already");
}

TEST(TextEdit, ChangesOnlyWhatDiffersInListsAndObjects) {
  const std::string text = "{\"a\": [1.0, /* two */ 2.0, 3.0], \"b\": {\"c\": 1e0, \"d\": 5}}";
  EXPECT_EQ(set(text, "a", Value::List{1, 7, 3}), "{\"a\": [1.0, /* two */ 7, 3.0], \"b\": {\"c\": 1e0, \"d\": 5}}");
  EXPECT_EQ(set(text, "a", Value::List{1, 2, 9, 3}),
            "{\"a\": [1.0, /* two */ 2.0, 9, 3.0], \"b\": {\"c\": 1e0, \"d\": 5}}");
  EXPECT_EQ(set(text, "a", Value::List{1, 3}), "{\"a\": [1.0, /* two */ 3.0], \"b\": {\"c\": 1e0, \"d\": 5}}");
  EXPECT_EQ(set(text, "b", parse_json(R"({"c": 1, "e": 6})")),
            "{\"a\": [1.0, /* two */ 2.0, 3.0], \"b\": {\"c\": 1e0, \"e\": 6}}");
}

TEST(TextEdit, KeepsByteOrderMarkAndLinesEnds) {
  const std::string text = "\xEF\xBB\xBF{\r\n\t\"a\": 1,\r\n\t\"b\": 2 \r\n}\r\n";
  EXPECT_EQ(set(text, "c", 3), "\xEF\xBB\xBF{\r\n\t\"a\": 1,\r\n\t\"b\": 2,\r\n\t\"c\": 3 \r\n}\r\n");
  EXPECT_EQ(remove(text, "a"), "\xEF\xBB\xBF{\r\n\t\"b\": 2 \r\n}\r\n");
  EXPECT_EQ(remove(text, "b"), "\xEF\xBB\xBF{\r\n\t\"a\": 1\r\n}\r\n");
}

TEST(TextEdit, FindsNamesWithDotsInThem) {
  const std::string text = R"({"profiles": {"22.5": [0], "22": {"5": 1}, "a[0]": 2}})";
  EXPECT_EQ(set(text, "profiles.22.5[0]", 4), R"({"profiles": {"22.5": [4], "22": {"5": 1}, "a[0]": 2}})");
  EXPECT_EQ(set(text, "profiles.a[0]", 4), R"({"profiles": {"22.5": [0], "22": {"5": 1}, "a[0]": 4}})");
  EXPECT_EQ(set(R"({"profiles": {}})", "profiles[\"67.5\"]", 1), R"({"profiles": {"67.5": 1}})");
}

TEST(TextEdit, SaysWhereAPathEnds) {
  const Diagnostic unknown = error_of([] { remove(kLeaf, "components.leef"); });
  EXPECT_EQ(unknown.message, "there is no 'leef'");
  EXPECT_EQ(unknown.nearest, "leaf");
  EXPECT_EQ(unknown.path, "components.leef");
  EXPECT_EQ(error_of([] { set(kLeaf, "links[3][0]", "x"); }).expected, "[0] to [0]");
  EXPECT_EQ(error_of([] { set(kLeaf, "meristem.x", 1); }).message, "the number 1 has no member 'x'");
  EXPECT_EQ(error_of([] { set(kLeaf, "links[x]", 1); }).message, "'links[x]' is not a path");
  EXPECT_EQ(error_of([] { set(kLeaf, "", 1); }).message, "'' is not a path");
  EXPECT_EQ(error_of([] { insert(kLeaf, "components.leaf", 1); }).message, "'components.leaf' exists already");
  EXPECT_EQ(error_of([] { insert(kLeaf, "links[2]", 1); }).message, "there is no element [2] in a list of 1");
}

TEST(TextEdit, RefusesValuesThatTextCannotSay) {
  EXPECT_EQ(error_of([] { set(kLeaf, "name", 1.0 / 0.0); }).expected, "finite numbers");
  EXPECT_NE(error_of([] { set(kLeaf, "name", "\xFF"); }).message.find("cannot be written"), std::string::npos);
  EXPECT_NE(error_of([] {
              set(kLeaf, "name", Value::Object{{"a", 1}, {"a", 2}});
            }).message.find("given twice"),
            std::string::npos);
}

}  // namespace meristem::text_edit_test
