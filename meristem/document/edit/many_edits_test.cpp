// SPDX-License-Identifier: Apache-2.0
// Many edits at once: they equal the same edits one after another, and the text is parsed once.
#include <array>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/edit/edits.h"
#include "meristem/document/edit/located_tree.h"
#include "meristem/document/edit/session.h"
#include "meristem/document/edit/tree_edit.h"
#include "meristem/document/json.h"

namespace meristem::many_edits_test {

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : engine_(seed) {}
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

 private:
  std::mt19937_64 engine_;
};

/// A document of leaves. Some stand on lines of their own with notes, others share a line.
std::string leaves(std::size_t count, std::size_t links, Draws& draw) {
  const bool in_lines = draw.below(3) > 0;
  const std::string break_ = in_lines ? "\n    " : " ";
  std::string text = R"({"meristem": 1, "variables": {"size": 0.1, "wide": {"value": 0.2}},)";
  text += in_lines ? "\n  \"components\": {" : " \"components\": {";
  for (std::size_t k = 0; k < count; ++k) {
    if (in_lines && draw.below(4) == 0) text += fmt::format("{}// the leaf {}", break_, k);
    text += fmt::format(R"({}"c{}": {{"type": "leaf", "length": {}}}{})", break_, k, draw.below(2) ? "0.1" : "\"size\"",
                        k + 1 < count ? "," : "");
    if (in_lines && draw.below(6) == 0) text += "  // behind it";
  }
  text += in_lines ? "\n  }" : "}";
  text += R"(, "links": [)";
  for (std::size_t k = 0; k < links; ++k) {
    text += fmt::format(R"({}["c{}", "c{}"]{})", draw.below(2) ? break_ : " ", draw.below(count), draw.below(count),
                        k + 1 < links ? "," : "");
  }
  return text + (draw.below(2) ? "\n]}\n" : "]}");
}

SessionEdit drawn_edit(Draws& draw, std::size_t count, int number) {
  const std::string component = fmt::format("c{}", draw.below(count + 2));
  const std::size_t place = draw.below(3);
  switch (draw.below(11)) {
    case 0:
      return SetValue{component + ".length", 0.01 * static_cast<double>(draw.below(50))};
    case 1:
      return SetValue{component + ".width", "wide"};
    case 2:
      return UnsetValue{component + ".width"};
    case 3:
      return InsertValue{fmt::format("components.n{}", number), Value(Value::Object{{"type", "leaf"}}), place};
    case 4:
      return InsertValue{draw.below(2) ? "links[]" : fmt::format("links[{}]", place),
                         Value(Value::List{component, "c1"})};
    case 5:
      return RemoveValue{"components." + component};
    case 6:
      return RemoveValue{fmt::format("links[{}]", place)};
    case 7:
      return RenameValue{"components." + component, fmt::format("r{}", number)};
    case 8:
      return MoveValue{"components." + component, place};
    case 9:
      return SetNote{"components." + component, draw.below(3) ? fmt::format("note {}\nof two lines", number) : ""};
    default: {
      InsertPart part{.text = R"({"meristem": 1, "variables": {"size": 0.3, "other": 2}, "components": {
  // the first
  "a": {"type": "leaf", "length": "size"},
  "b": {"type": "leaf", "length": "0.1*other"}, "c": {"type": "leaf"}},
  "links": [["a", "b"], ["a", "c"]]})"};
      for (const char* const name : {"a", "b", "c"})
        part.names.emplace_back(name, fmt::format("{}{}", name, number) + "x");
      if (draw.below(2)) part.index = place;
      if (draw.below(2)) part.link_index = place;
      return part;
    }
  }
}

TEST(ManyEdits, EqualTheSameEditsOneAfterAnother) {
  int made = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    Draws draw(seed);
    const std::size_t count = draw.below(2) ? 5 : 40;
    const std::string text = leaves(count, 6, draw);
    Session alone(text, "d.json", builtin_components());
    std::vector<SessionEdit> edits;
    for (int number = 0; number < 12; ++number) {
      SessionEdit edit = drawn_edit(draw, count, number);
      try {
        alone.edit({edit});
        edits.push_back(std::move(edit));
        ++made;
      } catch (const InputError&) {
        // The edit is impossible: it must not be in the list.
      }
    }
    Session together(text, "d.json", builtin_components());
    const Change change = together.edit(edits);
    ASSERT_EQ(together.text(), alone.text()) << text;
    EXPECT_EQ(apply_patch(text, change.patch), alone.text());
    EXPECT_EQ(apply_patch(alone.text(), change.inverse), text);
  }
  EXPECT_GT(made, 1000);
}

/// An edit that fails after others has changed nothing.
TEST(ManyEdits, ChangeNothingIfOneOfThemIsImpossible) {
  Draws draw(1);
  const std::string text = leaves(50, 5, draw);
  Session session(text, "d.json", builtin_components());
  EXPECT_THROW(session.edit({SetValue{"c1.length", 0.2}, RemoveValue{"components.c2"}, RemoveValue{"components.c2"}}),
               InputError);
  EXPECT_EQ(session.text(), text);
  EXPECT_EQ(session.undo_count(), 0U);
}

std::string tidy_leaves(std::size_t count) {
  std::string text = "{\n  \"meristem\": 1,\n  \"components\": {\n";
  for (std::size_t k = 0; k < count; ++k) {
    text += fmt::format("    // note {0}\n    \"c{0}\": {{\"type\": \"leaf\", \"length\": 0.1}}{1}\n", k,
                        k + 1 < count ? "," : "");
  }
  text += "  },\n  \"links\": [\n";
  for (std::size_t k = 1; k < count; ++k) {
    text += fmt::format("    [\"c{}\", \"c{}\"]{}\n", (k - 1) / 2, k, k + 1 < count ? "," : "");
  }
  return text + "  ]\n}\n";
}

/// Returns the bytes that edits parse after the first parse of the text, per edit.
double parsed_per_edit(const std::string& text, const std::vector<SessionEdit>& edits, std::size_t parts) {
  LocatedTree tree(text);
  TreeEdit document(&tree);
  const EditContext context{"d.json", builtin_components(), nullptr, {}};
  for (const SessionEdit& edit : edits) make_edit(edit, document, context);
  return static_cast<double>(document.tree().parsed_bytes() - text.size()) / static_cast<double>(parts);
}

TEST(ManyEdits, ParseOnlyTheirOwnParts) {
  const auto expect_little = [](const char* what, double bytes) { EXPECT_LT(bytes, 600) << what; };
  for (const std::size_t count : {100U, 600U}) {
    const std::string text = tidy_leaves(count);
    std::vector<SessionEdit> sets, removals, notes, insertions, moves;
    for (std::size_t k = 0; k < count; ++k) {
      const std::string path = fmt::format("components.c{}", k);
      sets.push_back(SetValue{path + ".length", 0.2});
      notes.push_back(SetNote{path, "other"});
      moves.push_back(MoveValue{path, (7 * k) % count});
      insertions.push_back(InsertValue{fmt::format("components.n{}", k), Value(Value::Object{{"type", "leaf"}}), k});
    }
    // The studio removes components in this way. Otherwise their notes would stay, and be read again and again.
    for (std::size_t k = count; k-- > 1;) {
      removals.push_back(SetNote{fmt::format("components.c{}", k), ""});
      removals.push_back(RemoveValue{fmt::format("components.c{}", k)});
    }
    expect_little("sets", parsed_per_edit(text, sets, count));
    expect_little("notes", parsed_per_edit(text, notes, count));
    expect_little("moves", parsed_per_edit(text, moves, count));
    expect_little("insertions", parsed_per_edit(text, insertions, count));
    expect_little("removals", parsed_per_edit(text, removals, 3 * count));  // a note, a component and a link each
    InsertPart part{.text = text};
    for (std::size_t k = 0; k < count; ++k) part.names.emplace_back(fmt::format("c{}", k), fmt::format("d{}", k));
    expect_little("a part", parsed_per_edit(text, {part}, 2 * count));
    part.index = 3;
    part.link_index = 3;
    expect_little("a part in the middle", parsed_per_edit(text, {part}, 2 * count));
  }
}

}  // namespace meristem::many_edits_test
