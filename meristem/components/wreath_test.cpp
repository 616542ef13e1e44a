// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/wreath.h"

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"

namespace meristem::wreath_test {

std::vector<Organ> posts(const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("ring", "wreath", parameters).component("post", "simple");
  return organs_of(builder.link("view", "ring").link("ring", "post").grow(), "post");
}

TEST(Wreath, SetsItsChildrenEvenlyOnARing) {
  for (const double angle : {0.0, 60.0, 90.0, 140.0}) {
    const std::vector<Organ> organs = posts({{"number", 8}, {"diameter", 3}, {"angle", angle}});
    ASSERT_EQ(organs.size(), 8U);
    for (std::size_t k = 0; k < 8; ++k) {
      const Frame& frame = organs[k].frame;
      EXPECT_NEAR(frame.origin.y, 0, 1e-6F);
      EXPECT_NEAR(glm::length(frame.origin), 1.5F, 1e-5F);
      EXPECT_NEAR(glm::distance(frame.origin, organs[(k + 1) % 8].frame.origin), 3 * std::sin(kPi / 8), 1e-5);
      const Vec3 heading = glm::normalize(frame.heading());
      EXPECT_NEAR(heading.y, std::cos(radians(angle)), 1e-5);
      EXPECT_NEAR(glm::dot(heading, frame.origin) / 1.5F, std::sin(radians(angle)), 1e-5);
    }
  }
}

TEST(Wreath, NumbersDifferPerChildAndAnArcIsAPartOfTheRing) {
  const std::vector<Organ> organs =
      posts({{"number", 3}, {"diameter", 2}, {"arc", 180}, {"size", Value(Value::List{1, 3})}});
  ASSERT_EQ(organs.size(), 3U);
  EXPECT_LT(glm::distance(organs[0].frame.origin, -organs[2].frame.origin), 1e-5F);
  const float scale = glm::length(organs[0].frame.heading());
  EXPECT_NEAR(glm::length(organs[1].frame.heading()) / scale, 2, 1e-5);
  EXPECT_NEAR(glm::length(organs[2].frame.heading()) / scale, 3, 1e-5);
}

TEST(Wreath, WithoutANumberHasNoChildren) { EXPECT_TRUE(posts({{"number", 0}}).empty()); }

}  // namespace meristem::wreath_test
