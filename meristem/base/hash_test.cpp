// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/hash.h"

#include <gtest/gtest.h>

namespace meristem::hash_test {

std::string hex_of(std::string_view text) { return hash128_hex(std::as_bytes(std::span(text))); }

TEST(Hash, MatchesTheReferenceValuesOfXxh3) {
  EXPECT_EQ(hash64(""), 0x2d06800538d394c2U);
  EXPECT_EQ(hash64("abc"), 0x78af5f94892f3950U);
  EXPECT_EQ(hex_of(""), "99aa06d3014798d86001c324468d497f");
  EXPECT_EQ(hex_of("abc"), "06b05ab6733a618578af5f94892f3950");
}

TEST(Hash, ChangesWithEveryByte) {
  const std::string text(1000, 'x');
  for (std::size_t k = 0; k < text.size(); ++k) {
    std::string other = text;
    other[k] = 'y';
    EXPECT_NE(hex_of(other), hex_of(text));
    EXPECT_NE(hash64(other), hash64(text));
  }
}

}  // namespace meristem::hash_test
