// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/crown_placement.h"

#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/shape/implicit/plant_body.h"

namespace meristem::crown_placement_test {

// A ball of 1 m radius about the tip of a stem 3 m high.
Skeleton stem() {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, {0, 0, 0}, 0);
  skeleton.add_node(0, {0, 3, 0}, 1);
  skeleton.radius = {0.1F, 0.05F};
  return skeleton;
}

SurfaceOptions ball() {
  SurfaceOptions surface;
  surface.crown = CrownBody{.diameter = 2};
  return surface;
}

std::vector<Site> sites(const CrownPlacement& placement, const SizeLimits& limits = {}) {
  Progress progress;
  PlacementContext context;
  context.limits = &limits;
  context.path = "links[1]";
  return place_in_crown(stem(), ball(), placement, context, progress);
}

constexpr Vec3 kMiddle{0, 3, 0};

TEST(CrownPlacement, SetsSoManyPerCubicMetreIntoTheBody) {
  const std::vector<Site> found = sites({.density = 500});
  EXPECT_NEAR(static_cast<double>(found.size()), 500 * 4.18879, 60);
  for (const Site& site : found) {
    EXPECT_LE(glm::distance(site.frame.origin, kMiddle), 1.001F);
    EXPECT_EQ(site.n, found.size());
    EXPECT_NEAR(site.u, 0.5 * (site.frame.origin.y - 2), 0.01);
    EXPECT_NEAR(site.length, 2, 1e-3);
    EXPECT_EQ(site.stem, kOnNoStem);
  }
}

TEST(CrownPlacement, HeadsOutwardAndAsideByItsTurn) {
  for (const Site& site : sites({.density = 200})) {
    const Vec3 out = glm::normalize(site.frame.origin - kMiddle);
    if (glm::distance(site.frame.origin, kMiddle) < 0.1F) continue;
    EXPECT_GT(glm::dot(site.frame.heading(), out), 0.995F);
  }
  double min = 1;
  for (const Site& site : sites({.density = 200, .turn = 0.5, .depth = 0.3})) {
    const Vec3 out = glm::normalize(site.frame.origin - kMiddle);
    EXPECT_LT(glm::distance(glm::cross(site.frame.right(), site.frame.heading()), site.frame.upper()), 1e-4F);
    min = std::min(min, static_cast<double>(glm::dot(site.frame.heading(), out)));
  }
  EXPECT_GT(min, std::cos(0.51));
  EXPECT_LT(min, std::cos(0.45));
}

TEST(CrownPlacement, HeadsAnywhereAlike) {
  DVec3 sum{0};
  const std::vector<Site> found = sites({.density = 1000, .orient = CrownPlacement::Orient::random});
  for (const Site& site : found) {
    EXPECT_NEAR(glm::length(site.frame.heading()), 1, 1e-5);
    EXPECT_NEAR(glm::dot(site.frame.heading(), site.frame.upper()), 0, 1e-5);
    sum += DVec3(site.frame.heading());
  }
  // The mean of n unit vectors in all directions is about 1/sqrt(n) long; five times that is once in 10^16.
  EXPECT_LT(glm::length(sum) / found.size(), 5 / std::sqrt(static_cast<double>(found.size())));
}

TEST(CrownPlacement, Droops) {
  for (const Site& site : sites({.density = 100, .droop = 1})) EXPECT_LT(site.frame.heading().y, -0.999F);
  for (const Site& site : sites({.density = 100, .droop = -1})) EXPECT_GT(site.frame.heading().y, 0.999F);
}

TEST(CrownPlacement, StopsAtTheLimitOfInstances) {
  SizeLimits limits;
  limits.instances = 100;
  try {
    sites({.density = 500}, limits);
    FAIL() << "no fault";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics()[0].path, "links[1].density");
  }
}

}  // namespace meristem::crown_placement_test
