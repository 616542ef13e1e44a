// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/lsystem/word.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace meristem::word_test {

TEST(Alphabet, TellsSymbolsApartByTheirNumberOfParameters) {
  Alphabet alphabet;
  const LetterIndex plain = alphabet.add("F", 0);
  const LetterIndex longer = alphabet.add("F", 1);
  EXPECT_NE(plain, longer);
  EXPECT_EQ(alphabet.add("F", 1), longer);
  EXPECT_EQ(alphabet.find("F", 0), plain);
  EXPECT_EQ(alphabet.find("F", 2), kNoLetter);
  EXPECT_EQ(alphabet.find("F1", 0), kNoLetter);
  EXPECT_EQ(alphabet[longer], (Letter{"F", 1}));
  EXPECT_EQ(alphabet.size(), 2U);
}

TEST(Alphabet, HoldsAsManyLettersAsHaveAnIndex) {
  Alphabet alphabet;
  for (int k = 0; k < 65534; ++k) alphabet.add("F", static_cast<std::uint16_t>(k));
  EXPECT_EQ(alphabet.find("F", 65533), 65533);
  EXPECT_EQ(alphabet.add("F", 7), 7);
  EXPECT_THROW(alphabet.add("G", 0), std::length_error);
}

TEST(WordText, WritesNumbersWithTheFewestDigits) {
  Alphabet alphabet;
  const Word word{{alphabet.add("A", 2), alphabet.add("[", 0), alphabet.add("+", 1), alphabet.add("]", 0)},
                  {1, 0.1, -1e22}};
  EXPECT_EQ(word_text(word, alphabet), "A(1,0.1)[+(-1e+22)]");
}

TEST(WordText, KeepsNamesApartOnlyWhereTheyWouldRunTogether) {
  Alphabet alphabet;
  const LetterIndex a = alphabet.add("A", 0);
  const Word pair{{a, a}, {}};
  EXPECT_EQ(word_text(pair, alphabet), "AA");
  const LetterIndex leaf = alphabet.add("Leaf", 1);
  const LetterIndex turn = alphabet.add("+", 0);
  EXPECT_EQ(word_text({{a, leaf, a, turn, a, a}, {3}}, alphabet), "A Leaf(3)A+A A");
}

TEST(WordText, ComesInPiecesOfWholeModulesWithTheSameText) {
  Alphabet alphabet;
  const LetterIndex leaf = alphabet.add("Leaf", 0);
  const LetterIndex f = alphabet.add("F", 1);
  Word word;
  for (int k = 0; k < 30'000; ++k) {
    word.letters.push_back(leaf);
    word.letters.push_back(leaf);
    word.letters.push_back(f);
    word.parameters.push_back(k);
  }
  std::string text;
  std::size_t modules = 0;
  std::size_t pieces = 0;
  write_word_text(word, alphabet, [&](std::string_view piece, std::size_t count) {
    // Each of the three repeated modules begins with one capital letter.
    EXPECT_EQ(std::count_if(piece.begin(), piece.end(), [](char c) { return c == 'L' || c == 'F'; }),
              static_cast<std::ptrdiff_t>(count));
    EXPECT_LT(piece.size(), 70'000U);
    text += piece;
    modules += count;
    ++pieces;
  });
  EXPECT_GT(pieces, 5U);
  EXPECT_EQ(modules, word.module_count());
  EXPECT_EQ(text, word_text(word, alphabet));
  std::string expected;
  for (int k = 0; k < 30'000; ++k) expected += "Leaf Leaf F(" + std::to_string(k) + ")";
  EXPECT_EQ(text, expected);
}

TEST(WordText, OfNoModulesIsEmpty) {
  write_word_text({}, {}, [](std::string_view, std::size_t) { ADD_FAILURE() << "there is nothing to write"; });
  EXPECT_EQ(word_text({}, {}), "");
}

TEST(SymbolCounts, AddsUpLettersOfASymbolInTheOrderOfTheAlphabet) {
  Alphabet alphabet;
  const LetterIndex open = alphabet.add("[", 0);
  const LetterIndex b = alphabet.add("B", 0);
  const LetterIndex a = alphabet.add("A", 0);
  alphabet.add("C", 0);
  const LetterIndex longer = alphabet.add("B", 2);
  const Word word{{a, longer, b, longer, open}, {1, 2, 3, 4}};
  EXPECT_EQ(symbol_counts(word, alphabet), (std::vector<SymbolCount>{{"[", 1}, {"B", 3}, {"A", 1}}));
  EXPECT_TRUE(symbol_counts({}, alphabet).empty());
}

}  // namespace meristem::word_test
