// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/name_index.h"

#include <string>
#include <unordered_map>
#include <vector>

#include <gtest/gtest.h>

namespace meristem::name_index_test {

TEST(NameIndex, FindsTheFirstOfEqualNamesAndNothingElse) {
  std::vector<std::string> names;
  for (int k = 0; k < 5000; ++k) names.push_back("n" + std::to_string(k * k % 3000));
  const auto name_at = [&](std::size_t k) -> std::string_view { return names[k]; };
  NameIndex index(names.size());
  std::unordered_map<std::string, std::size_t> first;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto [known, is_new] = first.try_emplace(names[k], k);
    const auto before = index.enter(names[k], k, name_at);
    EXPECT_EQ(before, is_new ? std::nullopt : std::optional(known->second));
  }
  for (const auto& [name, position] : first) EXPECT_EQ(index.find(name, name_at), position);
  for (int k = 3000; k < 6000; ++k) EXPECT_EQ(index.find("n" + std::to_string(k), name_at), std::nullopt);
  EXPECT_EQ(index.find("", name_at), std::nullopt);
  EXPECT_EQ(NameIndex().find("n", name_at), std::nullopt);
}

}  // namespace meristem::name_index_test
