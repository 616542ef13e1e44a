// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include <gtest/gtest.h>

#include "meristem/graph/instances.h"
#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::begun_clocks_test {

/// A star of timers, with a stick on each.
GraphBuilder star_of_timers(int number, const Value::Object& timer) {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("star", "star", {{"number", number}});
  builder.component("timer", "timer", timer).component("stick", "stick");
  return builder.link("view", "star").link("star", "timer").link("timer", "stick");
}

std::vector<BegunClock> clocks_of(const GraphBuilder& builder) {
  Progress progress;
  return begun_clocks(builder.sound_graph(), Scene(), 0, progress);
}

std::vector<double> starts_of(const std::vector<BegunClock>& clocks) {
  std::vector<double> starts;
  for (const BegunClock& begun : clocks) starts.push_back(begun.clock.start);
  return starts;
}

TEST(BegunClocks, EachInstanceBeginsAClock) {
  const std::vector<BegunClock> clocks = clocks_of(star_of_timers(4, {{"delay", "3 - i"}, {"speed", 2}}));
  EXPECT_EQ(starts_of(clocks), (std::vector<double>{0, 1, 2, 3}));
  for (const BegunClock& begun : clocks) {
    EXPECT_EQ(begun.component, 2U);
    EXPECT_EQ(begun.clock.speed, 2);
    EXPECT_TRUE(begun.clock.is_local);
  }
}

TEST(BegunClocks, EqualClocksAreListedOnce) {
  EXPECT_EQ(starts_of(clocks_of(star_of_timers(700, {{"delay", "i % 2"}}))), (std::vector<double>{0, 1}));
  EXPECT_EQ(clocks_of(star_of_timers(700, {{"speed", "1 + i % 3"}})).size(), 3U);
}

TEST(BegunClocks, NestedClocksAreSortedByTheirComponents) {
  auto builder = star_of_timers(2, {{"delay", "5 + i"}});
  builder.component("inner", "timer", {{"delay", 1}}).component("leaf", "stick");
  builder.link("stick", "inner").link("inner", "leaf");
  const std::vector<BegunClock> clocks = clocks_of(builder);
  EXPECT_EQ(starts_of(clocks), (std::vector<double>{5, 6, 6, 7}));
  ASSERT_EQ(clocks.size(), 4U);
  EXPECT_EQ(clocks[1].component, 2U);
  EXPECT_EQ(clocks[2].component, 4U);
}

TEST(BegunClocks, AClockWithoutDescendantsIsLeftOut) {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("timer", "timer").component("stick", "stick");
  builder.link("view", "timer").link("view", "stick");
  EXPECT_TRUE(clocks_of(builder).empty());
}

}  // namespace meristem::begun_clocks_test
