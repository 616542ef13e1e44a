// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/locate.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace meristem::locate_test {

/// "line:column" of a diagnostic at `path`.
std::string place_of(std::string_view text, const std::string& path, int text_offset = -1) {
  Diagnostic diagnostic{.path = path, .text_offset = text_offset};
  locate_diagnostics(text, std::span(&diagnostic, 1));
  return std::to_string(diagnostic.line) + ":" + std::to_string(diagnostic.column);
}

TEST(Locate, FindsEveryKindOfPath) {
  const std::string text = R"({
  "seed": 1,
  "components": {"leaf": {"size": [1, [2, 3], {"x": 4}]}},
  "links": [["a", "b"], {"density": 5}]
})";
  EXPECT_EQ(place_of(text, ""), "1:1");
  EXPECT_EQ(place_of(text, "seed"), "2:11");
  EXPECT_EQ(place_of(text, "components"), "3:17");
  EXPECT_EQ(place_of(text, "components.leaf.size"), "3:35");
  EXPECT_EQ(place_of(text, "components.leaf.size[0]"), "3:36");
  EXPECT_EQ(place_of(text, "components.leaf.size[1][1]"), "3:43");
  EXPECT_EQ(place_of(text, "components.leaf.size[2].x"), "3:53");
  EXPECT_EQ(place_of(text, "links[1].density"), "4:37");
}

TEST(Locate, TakesThePlaceOfTheLongestPartThatIsThere) {
  const std::string text = "{\"a\":\n {\"b\":\n  [1]}}";
  EXPECT_EQ(place_of(text, "a.b[3].c"), "3:3");
  EXPECT_EQ(place_of(text, "a.x.y"), "2:2");
  EXPECT_EQ(place_of(text, "x"), "1:1");
}

TEST(Locate, FindsNamesInsteadOfValues) {
  const std::string text = "{\"a\":\n 1, \"b\": {\"c\":\n 2}}";
  EXPECT_EQ(place_of(text, "b.c", kAtName), "2:11");
  EXPECT_EQ(place_of(text, "b.c"), "3:2");
  EXPECT_EQ(place_of(text, "b.missing", kAtName), "2:10");
}

TEST(Locate, ReadsEscapesInNames) {
  EXPECT_EQ(place_of(R"({"a\"\\\/b": 1, "x": 2})", "x"), "1:22");
  EXPECT_EQ(place_of(R"({"a\"b": 1})", "a\"b"), "1:10");
  EXPECT_EQ(place_of(R"({"\u0061\u00e4\n": 1})", "a\xC3\xA4\n"), "1:20");
  EXPECT_EQ(place_of(R"({"\ud83c\udf31": 1})", "\xF0\x9F\x8C\xB1"), "1:18");
}

TEST(Locate, PassesOverBracketsInTextsAndComments) {
  EXPECT_EQ(place_of("// {[\"\n{/* } */ \"a\": \"]}\", \"b\": // \"c\":\n 1}", "b"), "3:2");
}

TEST(Locate, CountsColumnsInCharactersWithoutTheByteOrderMark) {
  EXPECT_EQ(place_of("{\"\xC3\xA4\": \"\xE2\x82\xAC\", \"b\": 1}", "b"), "1:17");
  EXPECT_EQ(place_of("\xEF\xBB\xBF{\"b\": 1}", "b"), "1:7");
  EXPECT_EQ(place_of("\xEF\xBB\xBF 1", ""), "1:2");
}

TEST(Locate, PointsIntoATextPastItsEscapes) {
  const std::string text = R"({"curl": "2*\u0078 + \"q"})";  // the value is 2*x + "q
  EXPECT_EQ(place_of(text, "curl", 0), "1:11");
  EXPECT_EQ(place_of(text, "curl", 2), "1:13");
  EXPECT_EQ(place_of(text, "curl", 3), "1:19");
  EXPECT_EQ(place_of(text, "curl", 6), "1:22");
  EXPECT_EQ(place_of(text, "curl", 7), "1:24");
  EXPECT_EQ(place_of(text, "curl", 99), "1:25") << "at most the closing quote";
  EXPECT_EQ(place_of(R"({"curl": "\u00e4x"})", "curl", 2), "1:17") << "the first escape is two bytes of UTF-8";
}

TEST(Locate, PlacesManyDiagnosticsInAnyOrder) {
  std::string text = "[";
  std::vector<Diagnostic> diagnostics;
  for (int k = 0; k < 1000; ++k) {
    text += "\n " + std::to_string(k) + ",";
    diagnostics.insert(diagnostics.begin(), {.path = "[" + std::to_string(k) + "]"});
  }
  text += "0]";
  locate_diagnostics(text, diagnostics);
  for (int k = 0; k < 1000; ++k) EXPECT_EQ(diagnostics[999 - k].line, k + 2);
}

TEST(Locate, LeavesPlacesThatAreKnown) {
  Diagnostic diagnostic{.path = "a", .line = 7, .column = 3};
  locate_diagnostics("{\"a\": 1}", std::span(&diagnostic, 1));
  EXPECT_EQ(diagnostic.line, 7);
  EXPECT_EQ(diagnostic.column, 3);
}

TEST(Locate, StopsAtTheEndOfTextThatIsNotJson) {
  for (const char* text : {"", "{", "{\"a", "{\"a\\", "[1, \"\\u00", "{\"a\": /* ", "]", "{]", ":::", "\xEF\xBB\xBF"}) {
    place_of(text, "a.b[0]", 5);
    place_of(text, "a", kAtName);
  }
  EXPECT_EQ(place_of("", "a"), "0:0");
}

TEST(Locate, CountsOffsetsPastTheEndAsTheEnd) {
  const TextPosition end = text_position("a\nbc", 100);
  EXPECT_EQ(end.line, 2);
  EXPECT_EQ(end.column, 3);
}

/// Writes a random tree with blanks and comments strewn in, and notes where each value begins.
class RandomText {
 public:
  struct Placed {
    std::string path;
    int text_offset = -1;
    int line = 0;
    int column = 0;
  };

  void value(const std::string& path, int depth) {
    blank();
    note(path, -1);
    const int kind = *rc::gen::inRange(0, depth > 0 ? 4 : 2);
    if (kind < 2) return put(kind == 0 ? "-1.5e3" : R"("a\"]}\u00e4,")");
    const int count = *rc::gen::inRange(0, 4);
    put(kind == 2 ? "[" : "{");
    for (int k = 0; k < count; ++k) {
      if (k > 0) put(",");
      if (kind == 2) {
        value(path + "[" + std::to_string(k) + "]", depth - 1);
      } else {
        member(path, k, depth);
      }
      blank();
    }
    put(kind == 2 ? "]" : "}");
  }

  const std::string& text() const { return text_; }
  const std::vector<Placed>& placed() const { return placed_; }

 private:
  void member(const std::string& path, int k, int depth) {
    const std::string name = "k\xC3\xA4" + std::to_string(k);
    const std::string below = path.empty() ? name : path + "." + name;
    blank();
    note(below, kAtName);
    put("\"" + name + "\"");
    blank();
    put(":");
    value(below, depth - 1);
  }

  void blank() { put(*rc::gen::element<std::string>("", " ", "\n", "\t", "/*[\xC3\xA4*/", "//{\"\n")); }
  void note(const std::string& path, int text_offset) { placed_.push_back({path, text_offset, line_, column_}); }
  void put(const std::string& piece) {
    for (const char c : piece) {
      if (c == '\n') {
        ++line_;
        column_ = 1;
      } else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) {
        ++column_;
      }
    }
    text_ += piece;
  }

  std::string text_;
  std::vector<Placed> placed_;
  int line_ = 1;
  int column_ = 1;
};

TEST(Locate, FindsEveryValueWhereItWasWritten) {
  EXPECT_TRUE(rc::check([] {
    RandomText random;
    random.value("", 4);
    std::vector<Diagnostic> diagnostics;
    for (const auto& placed : random.placed()) {
      diagnostics.push_back({.path = placed.path, .text_offset = placed.text_offset});
    }
    locate_diagnostics(random.text(), diagnostics);
    for (std::size_t k = 0; k < diagnostics.size(); ++k) {
      RC_ASSERT(diagnostics[k].line == random.placed()[k].line);
      RC_ASSERT(diagnostics[k].column == random.placed()[k].column);
    }
  }));
}

}  // namespace meristem::locate_test
