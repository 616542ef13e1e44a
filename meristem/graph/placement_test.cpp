// SPDX-License-Identifier: Apache-2.0
// Where children stand along axes: numbers, angles, light, bark.
#include "meristem/graph/placement.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/graph/batch.h"
#include "meristem/graph/placement_parts.h"
#include "meristem/graph/table/reader.h"

namespace meristem::placement_test {

constexpr float kRadius = 0.02F;

// Adds a straight axis of `segments` from `parent` (or a root at the origin) toward the unit vector `direction`.
void add_axis(Skeleton& skeleton, NodeIndex parent, Vec3 direction, float length, int segments) {
  const auto axis = skeleton.axis.empty() ? 0 : static_cast<AxisIndex>(skeleton.axis.back() + 1);
  const Vec3 base = parent == kNoNode ? Vec3(0) : skeleton.position[parent];
  const auto add = [&](NodeIndex from, float along, std::uint16_t order) {
    const NodeIndex node = skeleton.add_node(from, base + along * direction, static_cast<float>(skeleton.node_count()));
    skeleton.axis[node] = axis;
    skeleton.order[node] = order;
    skeleton.radius[node] = kRadius / static_cast<float>(order + 1);
    return node;
  };
  const auto order = static_cast<std::uint16_t>(parent == kNoNode ? 0 : skeleton.order[parent] + 1);
  NodeIndex last = parent == kNoNode ? add(kNoNode, 0, 0) : parent;
  for (int k = 1; k <= segments; ++k) {
    last = add(last, length * static_cast<float>(k) / static_cast<float>(segments), order);
  }
}

Skeleton pole(float length = 2, Vec3 direction = kUp) {
  Skeleton skeleton;
  add_axis(skeleton, kNoNode, direction, length, 20);
  return skeleton;
}

// A trunk of 20 m with 1000 twigs of `length` at its nodes.
Skeleton twigs(float length) {
  Skeleton skeleton;
  add_axis(skeleton, kNoNode, kUp, 20, 1000);
  for (NodeIndex node = 1; node <= 1000; ++node) {
    const float azimuth = 2.4F * static_cast<float>(node);
    add_axis(skeleton, node, {std::cos(azimuth), 0, std::sin(azimuth)}, length, 2);
  }
  return skeleton;
}

GivenRows read(const Value::Object& keys, BranchPlacement& placement) {
  ParameterReader reader({}, SizeLimits{});
  const DocumentPath top;
  const GivenRows given = reader.read(placement_table(), &placement, Value(keys), DocumentPath(top, "link"));
  EXPECT_EQ(reader.error_count(), 0U) << reader.diagnostics()[0].text();
  return given;
}

BranchPlacement placement(const Value::Object& keys) {
  BranchPlacement result;
  read(keys, result);
  return result;
}

// As a link with these keys makes it.
BranchPlacement overridden_by(const Value::Object& keys, const BranchPlacement& own) {
  BranchPlacement link;
  const GivenRows given = read(keys, link);
  return overridden(own, link, given);
}

// Along the whole stem unless `keys` say otherwise.
BranchPlacement everywhere(Value::Object keys) {
  keys.emplace_back("where", "1");
  return placement(keys);
}

std::vector<Site> places(const Skeleton& skeleton, const BranchPlacement& placement, Vec3 light = kUp,
                         std::uint64_t seed = 3) {
  const SizeLimits limits;
  PlacementContext context{.directions = Directions(light), .parent = {}, .limits = &limits, .path = "links[0]"};
  context.parent.key = RandomKey(seed);
  return place_along(skeleton, placement, context);
}

double angle_between(Vec3 a, Vec3 b) { return degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b))); }

// The direction of a site on an upright pole, seen from the axis, as an angle about it (degrees).
double azimuth(const Site& site) { return degrees(std::atan2(-site.frame.origin.z, site.frame.origin.x)); }

TEST(Placement, DensityIsTheExpectedNumberPerMetreOverManyAxes) {
  // Twigs of 0.1 m less the trunk's radius carry 1.2 sites each: 1 or 2 by chance. The deviation of the sum of 1000
  // is sqrt(1000 * 0.2 * 0.8) = 12.6; five of them are passed once in two million seeds.
  const auto sites = places(twigs(0.12F), placement({{"density", 12}, {"where", "order == 1"}}));
  EXPECT_NEAR(static_cast<double>(sites.size()), 1200, 5 * 12.65);
  for (const Site& site : sites) EXPECT_TRUE(site.n == 1 || site.n == 2);
}

TEST(Placement, CountIsExact) {
  for (const int count : {0, 1, 7, 999, 1000, 2345}) {
    EXPECT_EQ(places(twigs(0.12F), everywhere({{"count", count}})).size(), static_cast<std::size_t>(count));
  }
  EXPECT_EQ(places(pole(), everywhere({{"count", 5}, {"whorl", 3}})).size(), 15U);
}

float size_of(const Site& site) { return glm::length(site.frame.axes[1]); }

TEST(Placement, OfACountWithAFractionTheLastChildHasComeToBeInPart) {
  const auto sites = places(pole(), everywhere({{"count", 3.25}, {"whorl", 2}}));
  ASSERT_EQ(sites.size(), 8U);
  for (const Site& site : sites) EXPECT_NEAR(size_of(site), site.i < 6 ? 1 : 0.25, 1e-6) << site.i;
  // 2 m for 3.25 places; the fourth would stand past the tip.
  EXPECT_NEAR(sites[4].frame.origin.y, 2 * 2.5 / 3.25, 1e-6);
  EXPECT_NEAR(sites[6].frame.origin.y, 2, 1e-6);
  EXPECT_EQ(sites[0].n, 8U);
  EXPECT_EQ(sites[0].part, 1 - 2 * 0.75F);
}

TEST(Placement, WhileACountRisesNothingJumps) {
  Skeleton skeleton;
  add_axis(skeleton, kNoNode, kUp, 3, 3);
  for (const float length : {0.5F, 0.7F, 1.1F}) add_axis(skeleton, kNoNode, {1, 0, 0}, length, 5);
  std::map<std::pair<float, std::uint32_t>, std::pair<float, float>> before;  // u and size by axis and place
  constexpr double kStep = 1.0 / 64;
  for (double count = 0; count <= 12; count += kStep) {
    std::map<std::pair<float, std::uint32_t>, std::pair<float, float>> now;
    double all = 0;
    for (const Site& site : places(skeleton, everywhere({{"count", count}}))) {
      now[{site.length, site.i}] = {site.u, size_of(site)};
      all += static_cast<double>(size_of(site));
    }
    EXPECT_NEAR(all, count, 1e-5);
    for (const auto& [place, state] : now) {
      const auto found = before.find(place);
      // A share of an axis's places is at most one for each that the whole count gains.
      EXPECT_LE(std::abs(state.second - (found == before.end() ? 0 : found->second.second)), kStep + 1e-6) << count;
      if (found == before.end()) continue;
      EXPECT_LE(std::abs(state.first - found->second.first), 2 * kStep) << count;
    }
    for (const auto& [place, state] : before) {
      if (now.contains(place)) continue;
      EXPECT_LE(state.second, kStep + 1e-6) << count;
    }
    before = std::move(now);
  }
}

TEST(Placement, ARangeOverACountThatRisesIsWholeAtWholeCounts) {
  for (const double count : {2.0, 2.5, 3.0}) {
    Varying range{.min = 0, .max = 90, .scale = 1};
    range.last = 90;
    const auto sites = places(pole(), everywhere({{"count", count}}));
    const VaryingValues values(std::span(&range, 1), sites, 0);
    EXPECT_NEAR(values.value(0, 1), std::min(1.0, 1 / (count - 1)) * 90, 1e-5) << count;
  }
}

TEST(Placement, CountIsSharedOutByLength) {
  Skeleton skeleton;
  add_axis(skeleton, kNoNode, kUp, 3, 3);
  add_axis(skeleton, kNoNode, {1, 0, 0}, 1, 5);
  const auto sites = places(skeleton, everywhere({{"count", 400}}));
  const auto on_first = std::count_if(sites.begin(), sites.end(), [](const Site& site) { return site.length == 3; });
  EXPECT_EQ(on_first, 300);
}

TEST(Placement, PlacesStandEvenlyAndCountAlongTheirAxis) {
  const auto sites = places(pole(), everywhere({{"count", 10}}));
  for (std::uint32_t k = 0; k < 10; ++k) {
    EXPECT_EQ(sites[k].i, k);
    EXPECT_EQ(sites[k].n, 10U);
    EXPECT_NEAR(sites[k].u, (k + 0.5F) / 10, 1e-6F);
    EXPECT_NEAR(sites[k].frame.origin.y, 2 * (k + 0.5F) / 10, 1e-6F);
    EXPECT_EQ(sites[k].length, 2);
    EXPECT_EQ(sites[k].radius, kRadius);
  }
}

TEST(Placement, WithoutAConditionTheTwigsCarryTheChildren) {
  for (const Site& site : places(pole(), placement({{"count", 50}}))) {
    EXPECT_GE(site.frame.origin.y, 2 - 0.4F - 0.1F);  // nodes stand 0.1 m apart
  }
}

TEST(Placement, ConditionsSeeTheNodesOfTheStems) {
  const Skeleton skeleton = twigs(0.12F);
  const auto all = [&](const char* where, auto holds) {
    const auto sites = places(skeleton, placement({{"count", 500}, {"where", where}}));
    EXPECT_EQ(sites.size(), 500U) << where;
    return std::all_of(sites.begin(), sites.end(), holds);
  };
  EXPECT_TRUE(all("order == 1", [](const Site& s) { return s.order == 1; }));
  EXPECT_TRUE(all("radius > 0.015", [](const Site& s) { return s.order == 0; }));
  EXPECT_TRUE(all("height > 10", [](const Site& s) { return s.frame.origin.y > 9.9F; }));
  EXPECT_TRUE(all("birth < 500", [](const Site& s) { return s.birth < 500; }));
  EXPECT_TRUE(all("order == 0 && u > 0.5", [](const Site& s) { return s.u > 0.499F && s.order == 0; }));
  EXPECT_TRUE(all("order == 0 && tip_distance < 1", [](const Site& s) { return s.frame.origin.y > 18.9F; }));
  EXPECT_TRUE(places(skeleton, placement({{"count", 500}, {"where", "0"}})).empty());
}

TEST(Placement, ARandomConditionTakesItsShareOfTheNodes) {
  // Twigs carry children where both, one or none of their two nodes were drawn: about 3/4 of them.
  const auto sites = places(twigs(0.5F), placement({{"density", 1000}, {"where", "order == 1 && rand() < 0.5"}}));
  // 0.48 m times 1000 sites times 1000 twigs, a half of them; the deviation is about 250 / sqrt(1000) of 240 per twig.
  EXPECT_NEAR(static_cast<double>(sites.size()), 240e3, 240e3 * 0.12);
}

TEST(Placement, StartAndEndAreSharesOfEachAxis) {
  for (const Site& site : places(pole(), everywhere({{"count", 40}, {"start", 0.25}, {"end", 0.5}}))) {
    EXPECT_GE(site.frame.origin.y, 0.5F);
    EXPECT_LE(site.frame.origin.y, 1);
  }
  EXPECT_TRUE(places(pole(), everywhere({{"density", 40}, {"start", 0.5}, {"end", 0.5}})).empty());
}

TEST(Placement, SuccessivePlacesTurnByTheDivergence) {
  for (const double divergence : {137.508, 180.0, -90.0}) {
    const auto sites = places(pole(), everywhere({{"count", 30}, {"divergence", divergence}}));
    for (std::size_t k = 1; k < sites.size(); ++k) {
      EXPECT_NEAR(std::remainder(azimuth(sites[k]) - azimuth(sites[k - 1]) - divergence, 360), 0, 1e-3);
    }
  }
}

TEST(Placement, TheDivergenceHoldsAlongABentAxis) {
  // Without twist: on a quarter circle in the x-y plane, sites keep their side of that plane.
  Skeleton skeleton;
  for (int k = 0; k <= 30; ++k) {
    const float a = static_cast<float>(kPi) / 60 * static_cast<float>(k);
    skeleton.add_node(k == 0 ? kNoNode : static_cast<NodeIndex>(k - 1), {1 - std::cos(a), std::sin(a), 0}, 0);
    skeleton.radius.back() = kRadius;
  }
  const auto sites = places(skeleton, everywhere({{"count", 20}, {"divergence", 0}, {"angle", 90}}));
  for (const Site& site : sites) EXPECT_NEAR(site.frame.heading().z, sites[0].frame.heading().z, 1e-5F);
}

TEST(Placement, AWhorlStandsEvenlyAroundOnePlace) {
  const auto sites = places(pole(), everywhere({{"count", 4}, {"whorl", 3}, {"divergence", 60}}));
  ASSERT_EQ(sites.size(), 12U);
  for (std::size_t k = 0; k < 12; k += 3) {
    for (std::size_t w = 1; w < 3; ++w) {
      EXPECT_EQ(sites[k + w].frame.origin.y, sites[k].frame.origin.y);
      EXPECT_NEAR(std::remainder(azimuth(sites[k + w]) - azimuth(sites[k + w - 1]) - 120, 360), 0, 1e-3);
    }
  }
  EXPECT_EQ(sites[11].i, 11U);
  EXPECT_EQ(sites[11].n, 12U);
}

TEST(Placement, ChildrenStandOffByTheAngle) {
  const Vec3 direction = glm::normalize(Vec3(1, 2, -0.5F));
  for (const double angle : {0.0, 30.0, 90.0, 150.0, 180.0}) {
    for (const Site& site : places(pole(2, direction), everywhere({{"count", 20}, {"angle", angle}}))) {
      EXPECT_NEAR(angle_between(site.frame.heading(), direction), angle, 1e-3);
    }
  }
}

TEST(Placement, TheUpperFaceTurnsToTheTip) {
  for (const Site& site : places(pole(), everywhere({{"count", 20}, {"angle", 60}}))) {
    EXPECT_NEAR(angle_between(site.frame.upper(), kUp), 30, 1e-3);
  }
}

TEST(Placement, TheAngleVariesEvenlyWithinItsSpread) {
  double min = 180, max = 0, sum = 0;
  const auto sites = places(pole(), everywhere({{"count", 4000}, {"angle", 60}, {"angle_spread", 20}}));
  for (const Site& site : sites) {
    const double angle = angle_between(site.frame.heading(), kUp);
    min = std::min(min, angle);
    max = std::max(max, angle);
    sum += angle;
  }
  EXPECT_GE(min, 40 - 1e-3);
  EXPECT_LE(max, 80 + 1e-3);
  EXPECT_LT(min, 40.1);  // missed by all 4000 once in e^10
  EXPECT_GT(max, 79.9);
  EXPECT_NEAR(sum / 4000, 60, 5 * 40 / std::sqrt(12.0 * 4000));
}

TEST(Placement, SizeIsACurveOverTheAxis) {
  const Value curve = Value::Object{{"curve", Value::List{Value::List{0, 1}, Value::List{1, -1}}}, {"kind", "linear"}};
  for (const Site& site : places(pole(), everywhere({{"count", 20}, {"size", curve}}))) {
    EXPECT_NEAR(glm::length(site.frame.heading()), std::max(0.0F, 1 - 2 * site.u), 1e-6F);
  }
}

TEST(Placement, FaceLightTurnsTheUpperFaceByItsShare) {
  const Vec3 light = glm::normalize(Vec3(1, 1, 1));
  const auto none = places(pole(), everywhere({{"count", 30}, {"face_light", 0}}), light);
  const auto half = places(pole(), everywhere({{"count", 30}, {"face_light", 0.5}}), light);
  const auto whole = places(pole(), everywhere({{"count", 30}, {"face_light", 1}}), light);
  for (std::size_t k = 0; k < 30; ++k) {
    EXPECT_NEAR(angle_between(whole[k].frame.upper(), light), 0, 0.1);
    EXPECT_NEAR(angle_between(half[k].frame.upper(), light), 0.5 * angle_between(none[k].frame.upper(), light), 0.1);
    EXPECT_EQ(whole[k].frame.origin, none[k].frame.origin);
  }
}

std::vector<Site> places_beside(const Skeleton& skeleton, const Value::Object& keys, const Obstacles& obstacles) {
  const SizeLimits limits;
  const PlacementContext context{.parent = {}, .limits = &limits, .obstacles = &obstacles, .path = "links[0]"};
  return place_along(skeleton, everywhere(keys), context);
}

TEST(Placement, FaceTurnsTheUpperFaceToADirectionWhateverTheLight) {
  const Value::List north_and_up{0, 2, -2};
  const Vec3 wanted = glm::normalize(Vec3(0, 1, -1));
  const auto with = [&](double share, Vec3 light) {
    return places(pole(), everywhere({{"count", 30}, {"face", north_and_up}, {"face_share", share}}), light);
  };
  const auto none = with(0, kUp), half = with(0.5, kUp), whole = with(1, kUp), lit = with(1, Vec3(1, 0, 0));
  for (std::size_t k = 0; k < 30; ++k) {
    EXPECT_LT(glm::distance(whole[k].frame.upper(), wanted), 1e-5F);
    EXPECT_NEAR(angle_between(half[k].frame.upper(), wanted), 0.5 * angle_between(none[k].frame.upper(), wanted), 0.1);
    EXPECT_EQ(lit[k].frame.axes, whole[k].frame.axes);
  }
}

TEST(Placement, FaceTurnsTheUpperFaceAwayFromTheSurfaceThatTheChildStandsAt) {
  std::vector<Obstacle> walls(2);
  walls[0].mesh = box_mesh({0.1, -1, -5}, {0.5, 4, 5});  // east of the pole
  walls[1].mesh = box_mesh({-9, -1, -5}, {-8, 4, 5});    // farther, in the west
  const Obstacles obstacles(std::move(walls));
  for (const Site& site : places_beside(pole(), {{"count", 30}, {"face", "surface"}}, obstacles)) {
    EXPECT_LT(glm::distance(site.frame.upper(), Vec3(-1, 0, 0)), 1e-5F);
    EXPECT_NEAR(site.frame.heading().x, 0, 1e-5F) << "the heading lies in the wall's plane";
  }
  EXPECT_THROW(places_beside(pole(), {{"face", "surface"}}, Obstacles()), InputError);
}

TEST(Placement, AnglesOfALinkMayDifferFromChildToChild) {
  const auto angles = [](const Value& angle) {
    std::vector<double> found;
    for (const Site& site : places(pole(), everywhere({{"count", 5}, {"angle", angle}}))) {
      found.push_back(angle_between(site.frame.heading(), kUp));
    }
    return found;
  };
  const std::vector<double> range = angles(Value::List{20, 60});
  const std::vector<double> told = angles("30 + 5*i");
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(range[k], 20 + 10.0 * static_cast<double>(k), 0.01);
    EXPECT_NEAR(told[k], 30 + 5.0 * static_cast<double>(k), 0.01);
  }
  for (const double angle : angles(Value::Object{{"sample", Value::List{25, 70}}})) {
    EXPECT_LT(std::min(std::abs(angle - 25), std::abs(angle - 70)), 0.01);
  }
}

TEST(Placement, ChildrenStandOnTheBark) {
  for (const Site& site : places(pole(), everywhere({{"count", 20}}))) {
    const Vec3 foot = site.frame.origin;
    EXPECT_NEAR(std::sqrt(foot.x * foot.x + foot.z * foot.z), kRadius, 1e-6F);
    EXPECT_EQ(site.radius, kRadius);
  }
}

TEST(Placement, LateralAxesBeginAtTheirParentsBark) {
  // A twig whose first segments lie inside a thick trunk.
  Skeleton skeleton;
  add_axis(skeleton, kNoNode, kUp, 2, 2);
  add_axis(skeleton, 1, {1, 0, 0}, 1, 20);
  std::fill(skeleton.radius.begin(), skeleton.radius.begin() + 3, 0.22F);
  const auto sites = places(skeleton, placement({{"count", 200}, {"where", "order == 1"}}));
  ASSERT_EQ(sites.size(), 200U);
  for (const Site& site : sites) EXPECT_GE(site.frame.origin.x, 0.22F);
  EXPECT_LT(sites[0].frame.origin.x, 0.23F);
}

TEST(Placement, AScaledSkeletonCarriesScaledPlaces) {
  Skeleton large = twigs(0.12F);
  for (Vec3& position : large.position) position *= 2.0F;
  for (float& radius : large.radius) radius *= 2;
  const auto one = places(twigs(0.12F), everywhere({{"density", 40}}));
  const auto two = places(large, everywhere({{"density", 20}}));
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_LT(glm::distance(2.0F * one[k].frame.origin, two[k].frame.origin), 1e-4F);
    EXPECT_EQ(one[k].key, two[k].key);
    EXPECT_EQ(2 * one[k].radius, two[k].radius);
  }
}

TEST(Placement, TheSamePlacesOnAnyNumberOfThreads) {
  const auto grow = [](int threads) {
    const ThreadLimit limit(threads);
    return places(twigs(0.12F), everywhere({{"density", 40}, {"angle_spread", 20}}));
  };
  const auto one = grow(1);
  for (const int threads : {2, 3, 8}) {
    const auto many = grow(threads);
    ASSERT_EQ(many.size(), one.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
      EXPECT_EQ(many[k].frame.origin, one[k].frame.origin);
      EXPECT_EQ(many[k].frame.axes, one[k].frame.axes);
      EXPECT_EQ(many[k].key, one[k].key);
    }
  }
}

TEST(Placement, ASingleNodeHasNoPlacesButATip) {
  Skeleton skeleton;
  skeleton.add_node(kNoNode, {1, 2, 3}, 0);
  EXPECT_TRUE(places(skeleton, everywhere({{"count", 10}})).empty());
  EXPECT_TRUE(places(skeleton, everywhere({{"density", 1000}})).empty());
  Site parent;
  parent.frame = frame_along({1, 2, 3}, {1, 0, 0}, kUp);
  const auto tips = tip_sites(skeleton, 0, parent);
  ASSERT_EQ(tips.size(), 1U);
  EXPECT_EQ(tips[0].frame.origin, Vec3(1, 2, 3));
  EXPECT_EQ(tips[0].frame.heading(), Vec3(1, 0, 0));
}

TEST(Placement, AnEmptySkeletonHasNoPlaces) {
  EXPECT_TRUE(places({}, everywhere({{"count", 10}})).empty());
  EXPECT_TRUE(tip_sites({}, 0, Site{}).empty());
}

TEST(Placement, EveryAxisHasOneTip) {
  const auto tips = tip_sites(twigs(0.12F), 0, Site{});
  ASSERT_EQ(tips.size(), 1001U);
  EXPECT_EQ(tips[0].frame.origin, Vec3(0, 20, 0));
  for (std::uint32_t k = 0; k < 1001; ++k) {
    EXPECT_EQ(tips[k].i, k);
    EXPECT_EQ(tips[k].n, 1001U);
    EXPECT_NEAR(tips[k].frame.heading().y, k == 0 ? 1 : 0, 1e-4F);
  }
}

TEST(Placement, PlacesPastTheLimitAreCountedInTheMessage) {
  SizeLimits limits;
  limits.instances = 99;
  const PlacementContext context{.parent = {}, .limits = &limits, .path = "links[4]"};
  try {
    place_along(pole(), everywhere({{"count", 50}, {"whorl", 2}}), context);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().at(0).text(),
              "links[4].count: 100 children are too many; expected at most 99 (limits.instances)");
  }
}

TEST(Placement, EqualKeysGiveEqualPlacesWhateverTheirChildrensKeys) {
  const SizeLimits limits;
  const BranchPlacement keys = everywhere({{"density", 31.7}, {"angle_spread", 20}});
  PlacementContext context{.parent = {}, .places = RandomKey(5), .limits = &limits, .path = "links[0]"};
  context.parent.key = RandomKey(1);
  const std::vector<Site> one = place_along(twigs(0.3F), keys, context);
  context.parent.key = RandomKey(2);
  const std::vector<Site> two = place_along(twigs(0.3F), keys, context);
  ASSERT_EQ(one.size(), two.size());
  ASSERT_GT(one.size(), 1000U);
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].frame.axes, two[k].frame.axes);
    EXPECT_EQ(one[k].frame.origin, two[k].frame.origin);
    EXPECT_EQ(one[k].i, two[k].i);
    EXPECT_NE(one[k].key, two[k].key);
  }
}

TEST(Placement, PartsHoldTheSitesOfTheWholeInTheirOrder) {
  const SizeLimits limits;
  const PlacementContext context{.parent = {}, .places = RandomKey(5), .limits = &limits, .path = "links[0]"};
  Skeleton bent = twigs(0.3F);
  add_axis(bent, 0, {0.6F, 0.8F, 0}, 50, 700);
  for (const Value::Object& keys :
       {Value::Object{{"density", 31.7}, {"angle_spread", 20}}, Value::Object{{"count", 150'000.4}},
        Value::Object{{"count", 70'000}, {"whorl", 3}, {"roll", 20}}}) {
    const BranchPlacement placement = everywhere(keys);
    const std::vector<Site> whole = place_along(bent, placement, context);
    std::size_t next = 0;
    place_in_parts(bent, placement, context, [&](std::vector<Site> part) {
      EXPECT_LE(part.size(), 65'536U);
      for (const Site& site : part) ASSERT_EQ(hash_of(site), hash_of(whole[next++]));
    });
    EXPECT_EQ(next, whole.size());
  }
}

TEST(Placement, SpreadIsACurveOfRelativeDensity) {
  // Four times as dense in the upper half as in the lower: 20 and 80 of 100.
  const Value::Object steps{
      {"curve", Value::List{Value::List{0, 1}, Value::List{0.4999, 1}, Value::List{0.5001, 4}, Value::List{1, 4}}},
      {"kind", "linear"}};
  for (const Value::Object& number : {Value::Object{{"count", 100}}, Value::Object{{"density", 20}}}) {
    Value::Object keys = number;
    keys.emplace_back("spread", steps);
    Skeleton fine;
    add_axis(fine, kNoNode, kUp, 2, 2000);
    const std::vector<Site> sites = places(fine, everywhere(keys));
    const auto upper = std::ranges::count_if(sites, [](const Site& site) { return site.frame.origin.y > 1; });
    EXPECT_NEAR(static_cast<double>(upper) / static_cast<double>(sites.size()), 0.8, 0.011);
  }
}

TEST(Placement, ADensityCurveKeepsItsCounts) {
  // Linear from 0 to the tip: the share below u is u squared.
  const Value::Object rising{{"curve", Value::List{Value::List{0, 0}, Value::List{1, 1}}}, {"kind", "linear"}};
  Skeleton fine;
  add_axis(fine, kNoNode, kUp, 2, 1000);
  const std::vector<Site> sites = places(fine, everywhere({{"count", 1000}, {"spread", rising}}));
  ASSERT_EQ(sites.size(), 1000U);
  for (const double u : {0.25, 0.5, 0.75}) {
    const auto below = std::ranges::count_if(sites, [&](const Site& site) { return site.u < u; });
    EXPECT_NEAR(static_cast<double>(below), 1000 * u * u, 2);
  }
}

TEST(Placement, ALinkOverridesWhatItIsGiven) {
  const BranchPlacement own = placement({{"count", 5}, {"angle", 70}, {"angle_tip", 30}, {"roll", 20}, {"whorl", 3}});
  const auto with = [&](const Value::Object& keys) { return overridden_by(keys, own); };
  EXPECT_EQ(with({}), own);
  const BranchPlacement dense = with({{"density", 8}});
  EXPECT_EQ(dense.density, 8);
  EXPECT_FALSE(dense.count);
  EXPECT_EQ(dense.whorl, 3);
  const BranchPlacement steep = with({{"angle", 10}, {"whorl", 1}});
  EXPECT_FLOAT_EQ(static_cast<float>(degrees(steep.angle.plain)), 10);
  EXPECT_FALSE(steep.angle_tip);
  EXPECT_EQ(steep.whorl, 1);
  EXPECT_EQ(steep.count, 5);
  EXPECT_FLOAT_EQ(static_cast<float>(degrees(*with({{"angle_tip", 5}}).angle_tip)), 5);
}

TEST(Placement, EveryKeyCanOverride) {
  const Value::Object curve{{"curve", Value::List{Value(Value::List{0, 3})}}};
  const Value::Object keys{{"density", 3},      {"where", "1"},      {"whorl", 2},     {"divergence", 9},
                           {"roll", 9},         {"angle", 9},        {"angle_tip", 8}, {"angle_spread", 9},
                           {"size", curve},     {"spread", curve},   {"droop", 0.5},   {"face_light", 0.5},
                           {"face", "surface"}, {"face_share", 0.5}, {"start", 0.1},   {"end", 0.9}};
  EXPECT_EQ(overridden_by(keys, BranchPlacement{}), placement(keys));
  // All rows; count stands beside density.
  BranchPlacement read_again;
  EXPECT_EQ(read(keys, read_again).count() + 1, placement_table().parameters.size());
}

TEST(Placement, KeysThatContradictAreRejected) {
  const auto error = [](const Value::Object& keys) {
    BranchPlacement result;
    ParameterReader reader({}, SizeLimits{});
    reader.read(placement_table(), &result, keys, DocumentPath());
    return reader.error_count() == 1 ? reader.diagnostics()[0].path : "not one fault";
  };
  EXPECT_EQ(error({{"density", 1}, {"count", 1}}), "count");
  EXPECT_EQ(error({{"start", 0.6}, {"end", 0.5}}), "start");
  EXPECT_EQ(error({{"where", "depth > 1"}}), "where");
  EXPECT_EQ(error({{"roll", "i"}}), "roll");
  EXPECT_EQ(error({{"whorl", 0}}), "whorl");
}

TEST(Placement, ChildrenDroopToWhereGravityPulls) {
  const SizeLimits limits;
  PlacementContext context{.directions = Directions(kUp, {1, 0, 0}), .limits = &limits, .path = "links[0]"};
  for (const Site& site : place_along(pole(), everywhere({{"count", 5}, {"droop", 1}}), context)) {
    EXPECT_LT(glm::distance(site.frame.heading(), Vec3(1, 0, 0)), 1e-5F);
  }
}

}  // namespace meristem::placement_test
