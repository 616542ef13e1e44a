// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/edit/note.h"

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"

namespace meristem::note_test {

const std::string kPlant = R"json({
  "meristem": 1,
  "components": {
    // The trunk,
    // and what it bears.
    "trunk": {"type": "tree"}, // not short
    "twig": {"type": "tree"}, // like the trunk

    // A heading of its own.

    "leaf": {
      "type": "leaf" // within
    }, "petal": {"type": "leaf"}
    /* The
     * last. */
  }
})json";

std::string noted(const std::string& text, const std::string& path, const std::string& note) {
  const LocatedTree tree(text);
  return apply_patch(text, set_note(tree, path, note));
}

using Notes = std::vector<std::pair<std::string, std::string>>;

TEST(Note, IsTheCommentAboveAMemberOrBehindIt) {
  EXPECT_EQ(notes_on_members(LocatedTree(kPlant), "components"),
            (Notes{{"trunk", "The trunk,\nand what it bears."}, {"twig", "like the trunk"}}));
}

TEST(Note, ChangesWhereItStandsAndNowhereElse) {
  const auto with = [](std::string before, std::string after) {
    std::string text = kPlant;
    return text.replace(text.find(before), before.size(), after);
  };
  EXPECT_EQ(noted(kPlant, "components.trunk", "Oak."), with("// The trunk,\n    // and what it bears.", "// Oak."));
  EXPECT_EQ(noted(kPlant, "components.twig", "thin"), with("// like the trunk", "// thin"));
  EXPECT_EQ(noted(kPlant, "components.leaf", "One\ntwo"), with("    \"leaf\"", "    // One\n    // two\n    \"leaf\""));
  EXPECT_EQ(noted(kPlant, "components.trunk", ""), with("    // The trunk,\n    // and what it bears.\n", ""));
  EXPECT_EQ(noted(kPlant, "components.twig", " "), with(" // like the trunk", ""));
}

TEST(Note, OnAMemberWithinALineGivesItALine) {
  const std::string changed = noted(kPlant, "components.petal", "White.");
  EXPECT_NE(changed.find("    },\n    // White.\n    \"petal\""), std::string::npos) << changed;
  const LocatedTree tree(changed);
  EXPECT_EQ(notes_on_members(tree, "components").back(), (std::pair<std::string, std::string>{"petal", "White."}));
}

TEST(Note, ReadsBackAsItWasSet) {
  for (const std::string note : {"One line.", "Two\nlines", "With an empty\n\nline", "// signs */ of comments", "ä"}) {
    for (const std::string path : {"trunk", "twig", "leaf", "petal"}) {
      const std::string changed = noted(kPlant, "components." + path, note);
      bool is_there = false;
      for (const auto& [name, said] : notes_on_members(LocatedTree(changed), "components")) {
        is_there = is_there || (name == path && said == note);
      }
      EXPECT_TRUE(is_there) << changed;
      EXPECT_EQ(noted(changed, "components." + path, note), changed);
    }
  }
}

TEST(Note, KeepsTheEndsOfLines) {
  const std::string text = "{\r\n\t\"components\": {\r\n\t\t\"a\": {}\r\n\t}\r\n}";
  EXPECT_EQ(noted(text, "components.a", "x\ny"),
            "{\r\n\t\"components\": {\r\n\t\t// x\r\n\t\t// y\r\n\t\t\"a\": {}\r\n\t}\r\n}");
}

TEST(Note, IsRefusedWhereThereIsNothing) { EXPECT_THROW(noted(kPlant, "components.root", "x"), InputError); }

}  // namespace meristem::note_test
