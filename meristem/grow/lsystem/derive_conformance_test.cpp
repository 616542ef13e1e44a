// SPDX-License-Identifier: Apache-2.0
// Compares derivations with an independent program (length, counts and digest) and with published derivations.
#include <fstream>
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "meristem/grow/lsystem/derive.h"
#include "meristem/grow/lsystem/grammar_reader.h"
#include "tests/support/build_grammar.h"
#include "tests/support/sha256.h"
#include "tests/support/test_data.h"

namespace meristem::derive_conformance_test {

using Json = nlohmann::json;

/// Converts rules of the reference data: "F": "FF", or with one neighbour on each side "001": "1[+F1F1]".
GrammarText grammar_text(const Json& entry) {
  GrammarText text;
  text.axiom = entry["axiom"];
  text.ignored = entry.value("ignore", "");
  for (const auto& [key, successor] : entry["rules"].items()) {
    const std::string to = successor;
    if (key.size() == 3) {
      text.rules.push_back(key.substr(0, 1) + "<" + key[1] + ">" + key[2] + "->" + to);
    } else {
      text.rules.push_back(key + "->" + to);
    }
  }
  // ABOP, figure 1.31a, exchanges the signs in each step. The data omits these two rules.
  if (!text.ignored.empty()) {
    text.rules.push_back("+ -> -");
    text.rules.push_back("- -> +");
  }
  return text;
}

Grammar read(const GrammarText& text) {
  std::string lines = text.ignored.empty() ? "" : "#ignore " + text.ignored + "\n";
  lines += "#axiom\n" + text.axiom + "\n#rules\n";
  for (const std::string& rule : text.rules) lines += rule + "\n";
  return read_grammar(lines);
}

std::map<std::string, int> counts_of(const Word& word, const Alphabet& alphabet) {
  std::map<std::string, int> counts;
  for (const LetterIndex letter : word.letters) ++counts[alphabet[letter].symbol];
  return counts;
}

/// Compares derivations with a table that another program wrote. Returns the number of grammars.
int compare_words(const std::string& path) {
  std::ifstream file(path);
  const Json entries = Json::parse(file);
  int compared = 0;
  for (const auto& [name, entry] : entries.items()) {
    if (!entry.contains("rules")) continue;
    SCOPED_TRACE(name);
    const Grammar grammar = read(grammar_text(entry));
    Progress progress;
    const std::vector<std::size_t> lengths = entry["lengths"];
    for (std::size_t step = 0; step < lengths.size(); ++step) {
      const Word word = derive(grammar, static_cast<int>(step), RandomKey(), SizeLimits(), progress);
      EXPECT_EQ(word.module_count(), lengths[step]) << "after " << step << " steps";
    }
    const Word last = derive(grammar, entry["n"], RandomKey(), SizeLimits(), progress);
    EXPECT_EQ(counts_of(last, grammar.alphabet), (entry["counts"].get<std::map<std::string, int>>()));
    EXPECT_EQ(sha256(word_text(last, grammar.alphabet)), entry["sha256"]);
    ++compared;
  }
  return compared;
}

TEST(DeriveConformance, AgreesWithOtherProgramsByLengthsCountsAndDigests) {
  for (const auto& [file, grammars] :
       data_sets<int>({{"tests/data/reference/lsystems.json", 11}}, {{"reference/lsystems.json", 11}})) {
    SCOPED_TRACE(file);
    EXPECT_EQ(compare_words(file), grammars);
  }
}

// ABOP, page 42.
TEST(DeriveConformance, AbopsParametricSequence) {
  const GrammarText text{"B(2)A(4,4)",
                         {"A(x,y) : y <= 3 -> A(x*2,x+y)", "A(x,y) : y > 3 -> B(x)A(x/y,0)", "B(x) : x < 1 -> C",
                          "B(x) : x >= 1 -> B(x-1)"}};
  const char* const words[] = {"B(2)A(4,4)", "B(1)B(4)A(1,0)", "B(0)B(3)A(2,1)", "CB(2)A(4,3)", "CB(1)A(8,7)"};
  const Grammar grammar = read(text);
  Progress progress;
  for (int step = 0; step < 5; ++step) {
    EXPECT_EQ(word_text(derive(grammar, step, RandomKey(), SizeLimits(), progress), grammar.alphabet), words[step]);
  }
  const Word fifth = derive(grammar, 5, RandomKey(), SizeLimits(), progress);
  ASSERT_EQ(fifth.parameters.size(), 4u);
  EXPECT_EQ(fifth.parameters[2], 8.0 / 7);
}

// ABOP, figure 1.30: a signal that travels up a branched plant.
TEST(DeriveConformance, AbopsAcropetalSignal) {
  const GrammarText text{"B[+A]A[-A]A[+A]A", {"B < A -> B"}, "+-"};
  const char* const words[] = {"B[+A]A[-A]A[+A]A", "B[+B]B[-A]A[+A]A", "B[+B]B[-B]B[+A]A", "B[+B]B[-B]B[+B]B"};
  const Grammar grammar = read(text);
  Progress progress;
  for (int step = 0; step < 4; ++step) {
    EXPECT_EQ(word_text(derive(grammar, step, RandomKey(), SizeLimits(), progress), grammar.alphabet), words[step]);
  }
}

/// ABOP, figure 2.6: Honda's trees with one axis.
GrammarText monopodial_tree() {
  return {"A(1,10)",
          {"A(l,w) -> !(w)F(l)[&(45)B(l*0.6,w*0.707)]/(137.5)A(l*0.9,w*0.707)",
           "B(l,w) -> !(w)F(l)[-(45)$C(l*0.6,w*0.707)]C(l*0.9,w*0.707)",
           "C(l,w) -> !(w)F(l)[+(45)$B(l*0.6,w*0.707)]B(l*0.9,w*0.707)"}};
}

TEST(DeriveConformance, AbopsMonopodialTree) {
  const Grammar grammar = read(monopodial_tree());
  Progress progress;
  const auto counts = counts_of(derive(grammar, 10, RandomKey(), SizeLimits(), progress), grammar.alphabet);
  const std::map<std::string, int> expected = {{"!", 1023}, {"F", 1023}, {"C", 682},  {"[", 1023},
                                               {"-", 565},  {"$", 1013}, {"]", 1023}, {"+", 448},
                                               {"B", 341},  {"A", 1},    {"&", 10},   {"/", 10}};
  EXPECT_EQ(counts, expected);
}

// ABOP, figure 2.8: 3^n apices, and segments that are lengthened instead of replaced.
TEST(DeriveConformance, AbopsTernaryTree) {
  const GrammarText text{"!(1)F(200)/(45)A",
                         {"A -> !(1.732)F(50)[&(18.95)F(50)A]/(94.74)[&(18.95)F(50)A]/(132.63)[&(18.95)F(50)A]",
                          "F(l) -> F(l*1.109)", "!(w) -> !(w*1.732)"}};
  const Grammar grammar = read(text);
  Progress progress;
  const Word word = derive(grammar, 6, RandomKey(), SizeLimits(), progress);
  const std::map<std::string, int> expected = {{"!", 365},  {"F", 1457}, {"/", 729}, {"[", 1092},
                                               {"&", 1092}, {"]", 1092}, {"A", 729}};
  EXPECT_EQ(counts_of(word, grammar.alphabet), expected);
}

// The worked example of the source.
TEST(DeriveConformance, WordLengthsOfTheSpruceExample) {
  const Grammar grammar = read({"A", {"A -> ^^FB", "B -> C+++C---", "C -> [^F&B]"}});
  Progress progress;
  const std::size_t lengths[] = {1, 4, 11, 21, 35, 55, 83};
  for (int step = 0; step < 7; ++step) {
    EXPECT_EQ(derive(grammar, step, RandomKey(), SizeLimits(), progress).module_count(), lengths[step]);
  }
}

TEST(DeriveConformance, TheDigestIsSha256) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace meristem::derive_conformance_test
