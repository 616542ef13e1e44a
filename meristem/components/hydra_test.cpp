// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/hydra.h"

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"

namespace meristem {
namespace {

std::vector<Organ> rays(const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("star", "hydra", parameters).component("ray", "simple");
  return organs_of(builder.link("view", "star").link("star", "ray").grow(), "ray");
}

TEST(Hydra, SpreadsItsChildrenEvenlyAboutItsHeading) {
  const std::vector<Organ> organs = rays({{"number", 5}, {"angle", 60}, {"radius", 0.5}});
  ASSERT_EQ(organs.size(), 5U);
  Vec3 sum(0);
  for (std::size_t k = 0; k < organs.size(); ++k) {
    const Vec3 heading = glm::normalize(organs[k].frame.heading());
    EXPECT_NEAR(heading.y, 0.5F, 1e-5F);
    EXPECT_LT(glm::distance(organs[k].frame.origin, 0.5F * heading), 1e-5F);
    EXPECT_GT(organs[k].frame.upper().y, 0);  // upper faces look to the star's heading
    const Vec3 next = glm::normalize(organs[(k + 1) % 5].frame.heading());
    EXPECT_NEAR(glm::dot(heading - Vec3(0, 0.5F, 0), next - Vec3(0, 0.5F, 0)), 0.75F * std::cos(radians(72)), 1e-5F);
    sum += heading;
  }
  EXPECT_LT(glm::distance(sum, Vec3(0, 2.5F, 0)), 1e-5F);
}

TEST(Hydra, AnArcBelowAFullTurnIsAFanWithChildrenAtBothEnds) {
  const std::vector<Organ> organs = rays({{"number", 3}, {"arc", 180}});
  ASSERT_EQ(organs.size(), 3U);
  EXPECT_LT(glm::distance(glm::normalize(organs[0].frame.heading()), -glm::normalize(organs[2].frame.heading())),
            1e-5F);
  EXPECT_LT(glm::distance(glm::normalize(organs[1].frame.heading()), Vec3(0, 0, -1)), 1e-5F);
}

TEST(Hydra, WithoutANumberHasNoChildren) { EXPECT_TRUE(rays({{"number", 0}}).empty()); }

}  // namespace
}  // namespace meristem
