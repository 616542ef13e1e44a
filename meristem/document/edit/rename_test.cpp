// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/edit/rename.h"

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/components/registry.h"
#include "meristem/document/edit/session.h"

namespace meristem::rename_test {

const std::string kFern = R"json({
  "meristem": 1,
  "variables": {"size": 0.1, "r": "size/2", "x1e5": 2},
  "components": {
    "plant": {"type": "lsystem", "grammar": [
      "#symbols leaf",
      "#steps 2",
      "#define r = 0.4",
      "A(1)",
      "A(q) : q > r -> F(q*r)[+~leaf]B A(q*size) // leaf size",
      "#interpret",
      "B -> ~K /* K */"]},
    "leaf": {"type": "leaf", "length": "size*x1e5", "width": {"range": ["size", 0.2]}},
    "K": {"type": "simple", "size": ["size", 1e0, "2*size"], "colour": "#b03020"},
    "size": {"type": "simple", "omit": ["i > size"]}
  },
  "links": [["plant", "size"], {"from": "leaf", "to": "size"}]
})json";

std::string renamed(const std::string& text, const std::string& path, const std::string& name) {
  Session session(text, "fern.json", builtin_components());
  EXPECT_TRUE(session.is_good()) << session.errors()[0].text();
  session.edit({RenameValue{path, name}});
  EXPECT_TRUE(session.is_good()) << session.errors()[0].text();
  const std::string changed = session.text();
  session.undo();
  EXPECT_EQ(session.text(), text);
  return changed;
}

std::string replaced(std::string text, const std::vector<std::pair<std::string, std::string>>& pieces) {
  for (const auto& [before, after] : pieces) {
    const std::size_t at = text.find(before);
    EXPECT_NE(at, std::string::npos) << before;
    text.replace(at, before.size(), after);
  }
  return text;
}

Diagnostic error_of(const std::string& path, const std::string& name) {
  Session session(kFern, "fern.json", builtin_components());
  try {
    session.edit({RenameValue{path, name}});
  } catch (const InputError& error) {
    EXPECT_EQ(session.text(), kFern);
    return error.diagnostics()[0];
  }
  return {};
}

TEST(Rename, ComponentsKeepTheirLinksAndTheirPlacesInGrammars) {
  EXPECT_EQ(renamed(kFern, "components.leaf", "frond"),
            replaced(kFern, {{"#symbols leaf", "#symbols frond"},
                             {"~leaf", "~frond"},
                             {"\"leaf\": {", "\"frond\": {"},
                             {"\"from\": \"leaf\"", "\"from\": \"frond\""}}));
  EXPECT_EQ(renamed(kFern, "components.size", "fruit"),
            replaced(kFern, {{"\"size\": {\"type\"", "\"fruit\": {\"type\""},
                             {"[\"plant\", \"size\"]", "[\"plant\", \"fruit\"]"},
                             {"\"to\": \"size\"", "\"to\": \"fruit\""}}));
}

TEST(Rename, ATreeKeepsTheCloudThatShowsItsPoints) {
  const std::string text = R"json({"meristem": 1, "components": {
    "tree": {"type": "colonize", "crown": {"sphere": {"centre": [0, 2, 0], "radius": 1}}},
    "dots": {"type": "cloud", "of": "tree"}}})json";
  EXPECT_EQ(renamed(text, "components.tree", "oak"),
            replaced(text, {{"\"tree\": {", "\"oak\": {"}, {"\"of\": \"tree\"", "\"of\": \"oak\""}}));
}

TEST(Rename, ALongerNameInAGrammarIsDeclared) {
  EXPECT_EQ(renamed(kFern, "components.K", "bud"),
            replaced(kFern, {{"      \"#symbols leaf\"", "      \"#symbols bud\",\n      \"#symbols leaf\""},
                             {"~K", "~bud"},
                             {"\"K\": {", "\"bud\": {"}}));
}

TEST(Rename, AShorterNameInAGrammarIsDeclaredNoMore) {
  EXPECT_EQ(renamed(kFern, "components.leaf", "L"), replaced(kFern, {{"\"#symbols leaf\"", "\"\""},
                                                                     {"~leaf", "~L"},
                                                                     {"\"leaf\": {", "\"L\": {"},
                                                                     {"\"from\": \"leaf\"", "\"from\": \"L\""}}));
}

TEST(Rename, WhatAGrammarCallsAlikeButDoesNotPlaceStays) {
  const std::string text = R"json({"meristem": 1, "components": {
    "plant": {"type": "lsystem", "steps": 1, "grammar": "F F(2)"}, "F": {"type": "simple"}}})json";
  EXPECT_EQ(renamed(text, "components.F", "box"), replaced(text, {{"\"F\": {", "\"box\": {"}}));
}

TEST(Rename, SymbolsThatWouldRunTogetherArePartedByBlanks) {
  const std::string text = R"json({"meristem": 1, "components": {
    "plant": {"type": "lsystem", "steps": 1, "grammar": "F~XF\n"}, "X": {"type": "simple"}}})json";
  EXPECT_EQ(renamed(text, "components.X", "bud"),
            replaced(text, {{"F~XF", "#symbols bud\\nF~bud F"}, {"\"X\": {", "\"bud\": {"}}));
}

TEST(Rename, VariablesKeepTheirNameInAllExpressions) {
  EXPECT_EQ(renamed(kFern, "size", "scale"),
            replaced(kFern, {{"\"size\": 0.1, \"r\": \"size/2\"", "\"scale\": 0.1, \"r\": \"scale/2\""},
                             {"A(q*size)", "A(q*scale)"},
                             {"\"size*x1e5\", \"width\": {\"range\": [\"size\"",
                              "\"scale*x1e5\", \"width\": {\"range\": [\"scale\""},
                             {"[\"size\", 1e0, \"2*size\"]", "[\"scale\", 1e0, \"2*scale\"]"},
                             {"\"i > size\"", "\"i > scale\""}}));
  EXPECT_EQ(renamed(kFern, "variables.r", "ratio"), replaced(kFern, {{"\"r\": \"size", "\"ratio\": \"size"},
                                                                     {"#define r", "#define ratio"},
                                                                     {"q > r", "q > ratio"},
                                                                     {"F(q*r)", "F(q*ratio)"}}));
}

TEST(Rename, RefusesNamesThatMeanSomethingElse) {
  EXPECT_EQ(error_of("components.leaf", "K").message, "there is a 'K' already");
  EXPECT_EQ(error_of("components.leaf", "a b").message, "'a b' cannot name a component");
  EXPECT_EQ(error_of("components.leaf", "F").message, "'F' would have another meaning in the grammar");
  EXPECT_EQ(error_of("components.leaf", "F").path, "components.plant.grammar");
  EXPECT_EQ(error_of("components.leaf", "2nd").message, "'2nd' would have another meaning in the grammar");
  EXPECT_EQ(error_of("size", "q").message, "'q' would have another meaning in the grammar");
  EXPECT_EQ(error_of("size", "u").message, "'u' already has a meaning in expressions");
  EXPECT_EQ(error_of("size", "2").message, "'2' is not a name");
  EXPECT_EQ(error_of("variables.sise", "s").nearest, "size");
}

}  // namespace meristem::rename_test
