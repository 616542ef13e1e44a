// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/lsystem/word.h"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace meristem {
namespace {

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

}  // namespace
}  // namespace meristem
