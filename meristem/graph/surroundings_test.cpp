// SPDX-License-Identifier: Apache-2.0
// A component sets the surroundings of all its descendants, until one of them sets its own.
#include "meristem/graph/table/surroundings.h"

#include <gtest/gtest.h>

#include "meristem/graph/batch.h"
#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::surroundings_test {

const Value kSideways = Value::List{1, 0, 0};
const Value kStraightDown = Value::List{0, -1, 0};

/// Parameters of a stick that turns its heading to where gravity pulls.
Value::Object hanging(Value::Object more = {}) {
  more.emplace_back("gravitropism", 1);
  return more;
}

/// A camera, a space with these parameters, and below it a pole.
GraphBuilder pole_in_space(const Value::Object& space) {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("space", "space", space).component("pole", "pole", {{"nodes", 3}});
  return builder.link("view", "space").link("space", "pole");
}

std::vector<Vec3> headings_of(const Plant& plant, std::string_view component) {
  std::vector<Vec3> headings;
  for (const Organ& organ : organs_of(plant, component)) headings.push_back(organ.frame.heading());
  return headings;
}

void expect_all_head(const Plant& plant, std::string_view component, Vec3 heading) {
  const std::vector<Vec3> headings = headings_of(plant, component);
  EXPECT_FALSE(headings.empty()) << component;
  for (const Vec3 found : headings) EXPECT_LT(glm::distance(found, heading), 1e-5F) << component;
}

TEST(Surroundings, AllThatHangsBelowHearsThem) {
  auto builder = pole_in_space({{"down", kSideways}});
  for (const char* id : {"side", "tip", "on_side", "beside"}) builder.component(id, "stick", hanging());
  builder.component("drooping", "stick").component("star", "star", {{"number", 5}});
  builder.link("pole", "side", LinkKind::branch, {{"count", 4}}).link("pole", "tip", LinkKind::leaf);
  builder.link("pole", "drooping", LinkKind::branch, {{"count", 4}, {"droop", 1}});
  builder.link("side", "on_side").link("view", "beside");
  builder.link("pole", "star", LinkKind::leaf);
  const Plant plant = builder.grow();
  for (const char* id : {"side", "tip", "on_side", "drooping"}) expect_all_head(plant, id, {1, 0, 0});
  expect_all_head(plant, "beside", {0, -1, 0});
}

TEST(Surroundings, TheNearestSpaceIsHeardAndAnEmptyOneEndsThem) {
  auto builder = pole_in_space({{"down", kSideways}});
  builder.component("other", "space", {{"down", Value::List{0, 0, 1}}}).component("end", "space");
  builder.component("in_other", "stick", hanging()).component("in_none", "stick", hanging());
  builder.link("pole", "other", LinkKind::leaf).link("other", "in_other");
  builder.link("pole", "end", LinkKind::leaf).link("end", "in_none");
  const Plant plant = builder.grow();
  expect_all_head(plant, "in_other", {0, 0, 1});
  expect_all_head(plant, "in_none", {0, -1, 0});
}

TEST(Surroundings, EachInstanceSaysItsOwn) {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("star", "star", {{"number", 3}});
  builder.component("space", "space", {{"down", Value::List{"i == 0", "i == 1", "i == 2"}}});
  builder.component("stick", "stick", hanging());
  builder.link("view", "star").link("star", "space").link("space", "stick");
  const std::vector<Vec3> headings = headings_of(builder.grow(), "stick");
  ASSERT_EQ(headings.size(), 3U);
  for (int k = 0; k < 3; ++k) EXPECT_LT(glm::distance(headings[k], Mat3(1)[k]), 1e-5F);
}

TEST(Surroundings, AnEditOfThemMakesWhatIsBelowAnewAndNothingElse) {
  Scene scene;
  scene.fingerprint = 1;
  const auto builder = [](const Value& down) {
    auto graph = pole_in_space({{"down", down}});
    graph.component("side", "stick", hanging()).component("beside", "stick").component("star", "star", {{"number", 7}});
    graph.link("pole", "side", LinkKind::branch, {{"count", 4}}).link("view", "star").link("star", "beside");
    return graph;
  };
  Cache cache;
  builder(kSideways).grow(0, scene, &cache);
  const Plant edited = builder(kStraightDown).grow(0, scene, &cache);
  EXPECT_EQ(hash_of(edited), hash_of(builder(kStraightDown).grow(0, scene)));
  EXPECT_EQ(cache.reuse<BatchResult>().made, 1U + 1U + 4U);    // the space, the pole, its sticks
  EXPECT_EQ(cache.reuse<BatchResult>().reused, 1U + 1U + 7U);  // the camera, the star, its sticks
}

TEST(Surroundings, OfUnknownOriginMakeSitesUnknown) {
  Site site;
  EXPECT_TRUE(hash_of(site).has_value());
  site.surroundings = std::make_shared<const Surroundings>();
  EXPECT_FALSE(hash_of(site).has_value());
  SiteList sites;
  sites.add(Site());
  EXPECT_TRUE(hash_of(sites).has_value());
  sites.add(site);
  EXPECT_FALSE(hash_of(sites).has_value());
  Surroundings said;
  said.hash = 1;
  Site one;
  one.surroundings = std::make_shared<const Surroundings>(said);
  said.hash = 2;
  site.surroundings = std::make_shared<const Surroundings>(said);
  EXPECT_NE(hash_of(one), hash_of(site));
}

}  // namespace meristem::surroundings_test
