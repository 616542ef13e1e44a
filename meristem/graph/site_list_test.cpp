// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/site_list.h"

#include <limits>

#include <gtest/gtest.h>

#include "meristem/graph/batch.h"
#include "meristem/graph/organ_list.h"

namespace meristem::site_list_test {

/// A site whose fields are all different from a plain site's.
Site other_site() {
  Site site;
  site.frame = {.axes = Mat3(2, 3, 4, 5, 6, 7, 8, 9, 10), .origin = {11, 12, -0.0F}};
  site.key = RandomKey(13);
  site.i = 14;
  site.n = 15;
  site.u = 0.16F;
  site.length = 17;
  site.radius = 18;
  site.birth = 19;
  site.order = 65'535;
  site.depth = 21;
  site.stem = 22ULL << 40;
  site.node = 23;
  site.along = 0.24F;
  site.section = 25ULL << 40;
  site.surface = RandomKey(26);
  site.individual = 27ULL << 40;
  site.row = 28;
  site.depths = {1, 2, 3, 4};
  site.clock = {.start = 29, .speed = 30, .is_local = true};
  site.appeared = std::numeric_limits<double>::infinity();
  site.part = 0.31F;
  site.values = std::make_shared<const SiteValues>(SiteValues{32, {33, 34}});
  Surroundings said;
  said.hash = 35;
  site.surroundings = std::make_shared<const Surroundings>(said);
  return site;
}

TEST(SiteList, KeepsEveryFieldOfASite) {
  const Site other = other_site();
  SiteList sites;
  for (int k = 0; k < 1000; ++k) sites.add(k % 3 == 0 ? Site() : other);
  sites.pack();
  for (std::size_t k = 0; k < 1000; ++k) {
    const Site site = sites.at(k);
    EXPECT_EQ(hash_of(site), hash_of(k % 3 == 0 ? Site() : other)) << "the hash covers every field";
    EXPECT_EQ(site.values, k % 3 == 0 ? nullptr : other.values);
    EXPECT_EQ(site.surroundings, k % 3 == 0 ? nullptr : other.surroundings);
  }
}

TEST(SiteList, NeighboursThatDifferInFrameAndKeyTakeAThirdOfTheirSize) {
  SiteList sites;
  for (std::uint32_t k = 0; k < 100'000; ++k) {
    Site site = other_site();
    site.values = nullptr;
    site.surroundings = nullptr;
    site.frame.axes *= static_cast<float>(k + 1);
    site.frame.origin = {k, k, k};
    site.key = RandomKey(k);
    site.i = k;
    sites.add(site);
  }
  sites.pack();
  EXPECT_LT(static_cast<double>(sites.bytes()) / 100'000, 62);
}

TEST(OrganList, KeepsEveryFieldOfAnOrgan) {
  const Organ organ{.frame = {.axes = Mat3(2, 3, 4, 5, 6, 7, 8, 9, 10), .origin = {11, 12, 13}},
                    .prototype = 14,
                    .tint = {15, 16, 17},
                    .birth = 18,
                    .individual = 19,
                    .name = 20ULL << 40};
  OrganList organs;
  organs.add(Organ());
  organs.add(organ);
  organs.pack();
  const Organ kept = organs.at(1);
  EXPECT_EQ(kept.frame.axes, organ.frame.axes);
  EXPECT_EQ(kept.frame.origin, organ.frame.origin);
  EXPECT_EQ(kept.prototype, organ.prototype);
  EXPECT_EQ(kept.tint, organ.tint);
  EXPECT_EQ(kept.birth, organ.birth);
  EXPECT_EQ(kept.individual, organ.individual);
  EXPECT_EQ(kept.name, organ.name);
}

}  // namespace meristem::site_list_test
