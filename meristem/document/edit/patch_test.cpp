// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/edit/patch.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace meristem::patch_test {

const TextPatch kPatch = {{1, 2, "XYZ"}, {4, 0, "-"}, {5, 1, ""}};

TEST(Patch, ReplacesItsPieces) { EXPECT_EQ(apply_patch("abcdefg", kPatch), "aXYZd-eg"); }

TEST(Patch, TakenBackGivesTheFirstBytes) {
  const TextPatch inverse = inverse_patch("abcdefg", kPatch);
  EXPECT_EQ(apply_patch("aXYZd-eg", inverse), "abcdefg");
  EXPECT_EQ(inverse_patch("aXYZd-eg", inverse), kPatch);
}

TEST(Patch, JoinedWithTheNextDoesBoth) {
  const TextPatch second = {{0, 3, "a"}, {5, 2, ""}, {8, 0, "!"}};
  const TextPatch both = joined_patches(kPatch, second);
  EXPECT_TRUE(is_sound(both, 7));
  EXPECT_EQ(apply_patch("abcdefg", both), apply_patch(apply_patch("abcdefg", kPatch), second));
  EXPECT_EQ(joined_patches({}, second), second);
  EXPECT_EQ(joined_patches(second, {}), second);
}

TEST(Patch, JoinedWithItsInverseIsAsLongAsWhatItTouched) {
  const TextPatch both = joined_patches(kPatch, inverse_patch("abcdefg", kPatch));
  EXPECT_EQ(apply_patch("abcdefg", both), "abcdefg");
}

TEST(Patch, ThatDoesNotFitIsRefused) {
  EXPECT_FALSE(is_sound({{3, 1, ""}, {2, 1, ""}}, 9));
  EXPECT_FALSE(is_sound({{2, 2, ""}, {3, 1, ""}}, 9));
  EXPECT_FALSE(is_sound({{9, 1, ""}}, 9));
  EXPECT_FALSE(is_sound({{2, static_cast<std::size_t>(-1), ""}}, 9));
  EXPECT_THROW(apply_patch("abc", {{4, 0, "x"}}), std::invalid_argument);
  EXPECT_THROW(inverse_patch("abc", {{2, 2, ""}}), std::invalid_argument);
}

}  // namespace meristem::patch_test
