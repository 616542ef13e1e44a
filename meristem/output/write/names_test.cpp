// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/write/names.h"

#include <gtest/gtest.h>

#include "meristem/output/write/provenance.h"

namespace meristem::names_test {

TEST(Names, ALineHasNoControlCharacters) {
  EXPECT_EQ(single_line("two\nlines\r\tand\x7f more \xC3\xA9"), "two lines  and  more \xC3\xA9");
}

TEST(Names, ALongLineIsCutBetweenCharacters) {
  std::string text(199, 'x');
  EXPECT_EQ(single_line(text + "yz"), text + "y");
  EXPECT_EQ(single_line(text + "\xC3\xA9"), text);
}

TEST(Names, AWordHasNothingThatEndsIt) {
  EXPECT_EQ(single_word("leaf of\toak\n#2\\"), "leaf_of_oak__2_");
  EXPECT_EQ(single_word("Bl\xC3\xA4tter"), "Bl\xC3\xA4tter");
  EXPECT_EQ(single_word(""), "_");
}

TEST(Names, WordsThatWouldBeAlikeAreNumbered) {
  const std::vector<std::string> names{"a b", "a_b", "a_b_2", "c", "a b"};
  EXPECT_EQ(distinct_words(names), (std::vector<std::string>{"a_b", "a_b_2", "a_b_2_2", "c", "a_b_3"}));
}

TEST(Names, ProvenanceTellsHowToGrowAgain) {
  const Provenance provenance{"Oak\nof mine", "", "CC0-1.0", 18446744073709551615U, "1.2.3"};
  EXPECT_EQ(
      provenance_lines(provenance),
      (std::vector<std::string>{"Meristem 1.2.3", "name: Oak of mine", "licence: CC0-1.0", "seed: 18446744073709551615",
                                "to grow it again: meristem grow DOCUMENT -o FILE --seed 18446744073709551615",
                                "units: metres, y up"}));
}

TEST(Names, ProvenanceTellsTheValuesThatWereSetAsAShellTakesThem) {
  const Provenance provenance{"", "", "", 7, "1", {"age=20", "leaf.colour=\"#aabbcc\"", "name=\"it's\""}};
  EXPECT_EQ(provenance_lines(provenance)[2],
            "to grow it again: meristem grow DOCUMENT -o FILE --seed 7 --set age=20 --set "
            "'leaf.colour=\"#aabbcc\"' --set 'name=\"it'\\''s\"'");
}

TEST(Names, FileWordsHaveNoSlash) {
  EXPECT_EQ(file_word("a/b c"), "a_b_c");
  EXPECT_EQ(file_word(""), "_");
}

}  // namespace meristem::names_test
