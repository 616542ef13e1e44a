// SPDX-License-Identifier: Apache-2.0
#include "redirect_page.h"

#include <filesystem>
#include <optional>
#include <string>

#include <gtest/gtest.h>

namespace meristem::studio::redirect_page_test {

namespace fs = std::filesystem;

constexpr const char* kAddress = "http://127.0.0.1:8413/00112233445566778899aabbccddeeff/";

TEST(RedirectPage, LeadsToTheAddress) {
  const RedirectPage page(kAddress);
  const std::string text = whole_file(page.path()).value_or("");
  EXPECT_NE(text.find(std::string("content=\"0; url=") + kAddress + "\""), std::string::npos) << text;
  EXPECT_NE(text.find("no-referrer"), std::string::npos) << text;
  EXPECT_EQ(page.path().find("00112233"), std::string::npos);
}

TEST(RedirectPage, IsForTheUserAlone) {
  const RedirectPage page(kAddress);
  EXPECT_EQ(fs::status(page.path()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(fs::status(fs::path(page.path()).parent_path()).permissions(), fs::perms::owner_all);
}

TEST(RedirectPage, IsRemovedWithItsOwner) {
  std::optional<RedirectPage> page(kAddress);
  const fs::path folder = fs::path(page->path()).parent_path();
  EXPECT_TRUE(fs::exists(folder));
  page.reset();
  EXPECT_FALSE(fs::exists(folder));
}

}  // namespace meristem::studio::redirect_page_test
