// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/lsystem/grammar_parts.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/progress.h"
#include "meristem/grow/lsystem/derive.h"
#include "meristem/grow/lsystem/grammar_reader.h"

namespace meristem::grammar_parts_test {

/// Returns the drawn word of a grammar after `steps` steps.
std::string drawn(const std::string& text, int steps = 0) {
  std::vector<Diagnostic> warnings;
  GrammarOptions options;
  options.warnings = &warnings;
  const Grammar grammar = read_grammar(text, options);
  for (const Diagnostic& warning : warnings) ADD_FAILURE() << warning.message;
  Progress progress;
  return word_text(derive_drawn(grammar, steps, RandomKey(1), SizeLimits(), progress), grammar.alphabet);
}

std::size_t count_of(const std::string& text, const std::string& piece) {
  std::size_t count = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++count;
  return count;
}

std::string error_of(const std::string& text) {
  try {
    read_grammar(text);
  } catch (const InputError& error) {
    const Diagnostic& first = error.diagnostics().front();
    return std::to_string(first.line) + ": " + first.message + "; " + first.expected + "; " + first.nearest;
  }
  return "";
}

TEST(GrammarParts, AWhorlSetsItsSidesEvenly) {
  EXPECT_EQ(drawn("#include \"meristem/whorl\"\nF whorl(3, 60, 0.5) F"),
            "F[&(60)F(0.5)]/(120)[&(60)F(0.5)]/(120)[&(60)F(0.5)]/(120)whorl_(0,120,60,0.5)F");
}

TEST(GrammarParts, TheGrammarsOwnRulesComeFirst) {
  EXPECT_EQ(drawn("#include meristem/fork\nfork(30, 1)\n#interpret\nside(x) -> G(x) ~l"),
            "[+(30)G(1)~l][-(30)G(1)~l]/(90)");
  EXPECT_EQ(drawn("fork(30, 1)\n#interpret\nside(x) : x > 2 -> G\nside(x) -> f(x)\n#include meristem/fork"),
            "[+(30)f(1)][-(30)f(1)]/(90)");
}

TEST(GrammarParts, PartsGrowByRulesAndShareTheirSides) {
  const std::string text =
      "#include meristem/whorl\n#include meristem/spiral\n#include meristem/whorl\n#axiom\nwhorl(2, 50, 1) spiral(3, "
      "1, "
      "40, 0.5)\n#rules\nwhorl(n, a, x) -> whorl(n + 1, a, 2*x)\n";
  const std::string word = drawn(text, 2);
  EXPECT_EQ(count_of(word, "[&(50)F(4)]"), 4U);
  EXPECT_EQ(count_of(word, "[&(40)F(0.5)]"), 3U);
}

TEST(GrammarParts, EveryPartReadsAloneAndDrawsSegments) {
  for (const GrammarPart& part : grammar_parts()) {
    const std::string doc(part.doc);
    const std::string name(part.name);
    ASSERT_TRUE(doc.starts_with(name + "(")) << doc;
    const std::size_t parameters = 1 + count_of(doc.substr(0, doc.find(')')), ",");
    std::string module = name + "(4";
    for (std::size_t k = 1; k < parameters; ++k) module += ", 0.5";
    const std::string word = drawn("#include \"meristem/" + name + "\"\n#axiom\n" + module + ")");
    EXPECT_GE(count_of(word, "F("), 2U) << name << ": " << word;
  }
  const auto sorted = [](const GrammarPart& a, const GrammarPart& b) { return a.name < b.name; };
  EXPECT_TRUE(std::ranges::is_sorted(grammar_parts(), sorted));
}

TEST(GrammarParts, TheirWordsAreNotWordsOfTheText) {
  GrammarWords words;
  GrammarOptions options;
  options.words = &words;
  const std::string text = "#include \"meristem/whorl\"\nwhorl(3, 60, 1)";
  read_grammar(text, options);
  ASSERT_FALSE(words.symbols.empty());
  for (const GrammarWord& word : words.symbols) EXPECT_LT(word.offset, text.size()) << word.text;
}

TEST(GrammarParts, AnUnknownPartNamesTheNearest) {
  EXPECT_EQ(error_of("F\n#include \"meristem/whorls\""),
            "2: 'meristem/whorls' is not among the parts of grammars; one of meristem/arch, meristem/fork, "
            "meristem/frond, meristem/spiral, meristem/taper, meristem/whorl; meristem/whorl");
  EXPECT_EQ(error_of("F\n#include fir.txt").substr(0, 2), "2:");
}

}  // namespace meristem::grammar_parts_test
