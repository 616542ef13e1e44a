// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/crown_cloud.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/graph/expand.h"
#include "tests/support/build_graph.h"

namespace meristem::crown_cloud_test {

Value::Object filled(Value::Object more = {}) {
  const auto at = [](double radius, double height) { return Value(Value::List{radius, height}); };
  Value::Object crown{{"crown", Value::Object{{"profile", Value::List{at(0.2, 1), at(0.9, 2), at(0, 3)}}}},
                      {"points", 200}};
  crown.insert(crown.end(), more.begin(), more.end());
  return crown;
}

GraphBuilder grove(const std::string& type, const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("crown", type, parameters).link("view", "crown");
  return builder;
}

std::optional<std::vector<Vec3>> points_of(const Graph& graph, const std::string& id = "crown") {
  Progress progress;
  return crown_cloud(graph, Scene(), id, 0, progress);
}

TEST(CrownCloud, HasThePointsThatACloudShows) {
  const GraphBuilder builder = grove("cloud", filled({{"points", "40*5"}}));
  const auto points = points_of(builder.sound_graph());
  ASSERT_TRUE(points);
  const Plant plant = builder.grow();
  ASSERT_EQ(points->size(), plant.organs.size());
  for (std::size_t k = 0; k < points->size(); ++k) EXPECT_EQ((*points)[k], plant.organs[k].frame.origin);
}

TEST(CrownCloud, HasThePointsThatATreeGrowsInto) {
  const GraphBuilder builder = grove("colonize", filled({{"step", 0.1}, {"influence", 0.8}, {"kill", 0.2}}));
  const Graph graph = builder.sound_graph();
  const auto points = points_of(graph);
  ASSERT_TRUE(points);
  Progress progress;
  GrowthTraces traces;
  expand(graph, Scene(), 0, progress, {.view = {0, {TracePart::points}}, .traces = &traces});
  std::vector<TracedPlace> before = traces.marks(0, {TracePart::points}, progress).points;
  ASSERT_EQ(points->size(), before.size());
  const auto rank = [](Vec3 point) { return std::array{point.x, point.y, point.z}; };
  std::ranges::sort(before, {}, [&](const TracedPlace& place) { return rank(place.position); });
  std::vector<Vec3> sorted = *points;
  std::ranges::sort(sorted, {}, rank);
  for (std::size_t k = 0; k < sorted.size(); ++k) EXPECT_EQ(sorted[k], before[k].position);
}

// The component's frame and the positions of its roots move the crown, but not the points within it.
TEST(CrownCloud, TellsPointsAboutTheirRoots) {
  const Value::List roots{Value::List{4, 0, 0}, Value::List{-3, 1, 5}};
  const Value::Object away{{"translate", Value::List{3, 0, 0}}, {"scale", Value::List{2, 2, 2}}};
  const auto points = points_of(grove("cloud", filled({{"roots", roots}, {"frame", away}})).sound_graph());
  ASSERT_TRUE(points);
  EXPECT_EQ(points->size(), 400U);
  for (const Vec3 point : *points) {
    EXPECT_LT(glm::length(Vec2(point.x, point.z)), 1.0F);
    EXPECT_GE(point.y, 1);
    EXPECT_LE(point.y, 3);
  }
}

TEST(CrownCloud, IsNothingOfWhatFillsNoCrown) {
  const Graph graph = grove("organize", {{"iterations", 2}}).sound_graph();
  EXPECT_FALSE(points_of(graph));
  EXPECT_FALSE(points_of(graph, "view"));
  EXPECT_FALSE(points_of(graph, "nobody"));
}

}  // namespace meristem::crown_cloud_test
