// SPDX-License-Identifier: Apache-2.0
#include "addresses.h"

#include <set>

#include <gtest/gtest.h>

namespace meristem::studio::addresses_test {

const std::string kToken = "0123456789abcdef0123456789abcdef";

TEST(Addresses, DrawTokensOf128Bits) {
  std::set<std::string> tokens;
  for (int k = 0; k < 100; ++k) tokens.insert(secret_token());
  EXPECT_EQ(tokens.size(), 100U);
  EXPECT_EQ(tokens.begin()->size(), 32U);
  EXPECT_EQ(tokens.begin()->find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST(Addresses, KnowTheirHost) {
  for (const char* host : {"127.0.0.1:8413", "localhost:8413", "[::1]:8413"}) {
    EXPECT_TRUE(is_own_host(host, 8413));
    EXPECT_TRUE(is_own_origin(std::string("http://") + host, 8413));
    EXPECT_FALSE(is_own_origin(std::string("https://") + host, 8413));
    EXPECT_FALSE(is_own_host(host, 8414));
  }
  for (const char* host : {"", "127.0.0.1", "evil.example:8413", "127.0.0.1:8413.evil.example", "localhost:84130",
                           "LOCALHOST:8413", "127.0.0.2:8413", "a@localhost:8413"}) {
    EXPECT_FALSE(is_own_host(host, 8413)) << host;
  }
  EXPECT_FALSE(is_own_origin("null", 8413));
  EXPECT_FALSE(is_own_origin("", 8413));
}

TEST(Addresses, GiveNothingWithoutTheToken) {
  EXPECT_EQ(name_below_token("/" + kToken + "/", kToken), "");
  EXPECT_EQ(name_below_token("/" + kToken + "/a/b-1.js?x=1", kToken), "a/b-1.js");
  std::string other = kToken;
  other.back() = '0';
  for (const std::string& target : {std::string("/"), std::string(""), "/" + kToken, "/" + other + "/", kToken + "/",
                                    "//" + kToken + "/", "/" + kToken.substr(1) + "/", "/x/" + kToken + "/"}) {
    EXPECT_FALSE(name_below_token(target, kToken)) << target;
  }
}

TEST(Addresses, HaveNoWayUp) {
  for (const char* name : {"../x", "a/../b", ".git", "a/.b", "a%2e", "a\\b", "//", "a//b", "a/b c", "/etc/passwd"}) {
    EXPECT_FALSE(name_below_token("/" + kToken + "/" + name, kToken)) << name;
  }
}

TEST(Addresses, AllowNoScriptInPages) {
  const std::string policy = security_policy("127.0.0.1:1");
  EXPECT_NE(policy.find("default-src 'none'"), std::string::npos);
  EXPECT_NE(policy.find("script-src 'self';"), std::string::npos);
  EXPECT_NE(policy.find("frame-ancestors 'none'"), std::string::npos);
}

}  // namespace meristem::studio::addresses_test
