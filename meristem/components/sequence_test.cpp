// SPDX-License-Identifier: Apache-2.0
// Compares clocks with closed forms: the height of a box shows the time of its clock.
#include "meristem/components/sequence.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/graph/instances.h"
#include "tests/support/build_graph.h"

namespace meristem::sequence_test {

const Value::Object kShowsTime{{"frame", Value::Object{{"translate", Value::List{0, "t", 0}}}}};

std::vector<float> heights(const Plant& plant) {
  std::vector<float> all;
  for (const Organ& organ : organs_of(plant, "box")) all.push_back(organ.frame.origin.y);
  return all;
}

GraphBuilder one_sequence(const Value::Object& sequence) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("clock", "sequence", sequence).component("box", "simple", kShowsTime);
  return builder.link("view", "clock").link("clock", "box");
}

TEST(Sequence, RunsFromItsDelayAtItsSpeed) {
  const GraphBuilder builder = one_sequence({{"delay", 2}, {"speed", 3}});
  EXPECT_EQ(heights(builder.grow(1)), (std::vector<float>{0}));
  EXPECT_EQ(heights(builder.grow(2)), (std::vector<float>{0}));
  EXPECT_EQ(heights(builder.grow(3.5)), (std::vector<float>{4.5F}));
}

TEST(Sequence, WhatDoesNotWaitIsNotThereBefore) {
  const GraphBuilder builder = one_sequence({{"delay", 2}, {"waits", false}});
  EXPECT_TRUE(heights(builder.grow(1.9)).empty());
  EXPECT_EQ(heights(builder.grow(2.5)), (std::vector<float>{0.5F}));
}

TEST(Sequence, ClocksNest) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera")
      .component("outer", "sequence", {{"delay", 1}, {"speed", 2}})
      .component("inner", "sequence", {{"delay", 3}, {"speed", 0.5}})
      .component("box", "simple", kShowsTime);
  builder.link("view", "outer").link("outer", "inner").link("inner", "box");
  for (const double time : {0.0, 2.0, 2.5, 4.0, 10.0}) {
    const double outer = std::max(0.0, (time - 1) * 2);
    const double inner = std::max(0.0, (outer - 3) * 0.5);
    EXPECT_NEAR(heights(builder.grow(time))[0], inner, 1e-6) << "at " << time;
  }
}

TEST(Sequence, EachInstanceHasADelayOfItsOwn) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera")
      .component("star", "wreath", {{"number", 4}, {"angle", 0}})
      .component("clock", "sequence", {{"delay", "i"}})
      .component("box", "simple", kShowsTime);
  builder.link("view", "star").link("star", "clock").link("clock", "box");
  const std::vector<float> all = heights(builder.grow(2.5));
  ASSERT_EQ(all.size(), 4U);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(all[static_cast<std::size_t>(i)], std::max(0.0, 2.5 - i), 1e-6);
}

TEST(Sequence, ItsClocksAreToldByTheirStarts) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera")
      .component("star", "wreath", {{"number", 4}, {"angle", 0}})
      .component("clock", "sequence", {{"delay", "floor(i/2)"}, {"speed", 2}, {"waits", false}})
      .component("box", "simple", kShowsTime)
      .component("ball", "simple");
  builder.link("view", "star").link("star", "clock").link("clock", "box").link("clock", "ball");
  const auto clocks_at = [&](double time) {
    Progress progress;
    return begun_clocks(builder.sound_graph(), Scene(), time, progress);
  };
  const std::vector<BegunClock> all = clocks_at(5);
  ASSERT_EQ(all.size(), 2U);  // the clocks of four instances, in two equal pairs
  EXPECT_EQ(builder.sound_graph().components[all[0].component].id, "clock");
  EXPECT_DOUBLE_EQ(all[0].clock.start, 0);
  EXPECT_DOUBLE_EQ(all[1].clock.start, 1);
  EXPECT_DOUBLE_EQ(all[1].clock.speed, 2);
  EXPECT_EQ(clocks_at(0.5).size(), 1U);
}

TEST(Counts, OfACountWithAFractionTheLastPartIsSmaller) {
  for (const char* const type : {"hydra", "wreath", "phiball"}) {
    GraphBuilder builder(builtin_components());
    builder.component("view", "camera").component("star", type, {{"number", 3.25}}).component("box", "simple");
    const std::vector<Organ> all = organs_of(builder.link("view", "star").link("star", "box").grow(), "box");
    ASSERT_EQ(all.size(), 4U) << type;
    const float whole = glm::length(all[0].frame.heading());
    EXPECT_NEAR(glm::length(all[3].frame.heading()) / whole, 0.25F, 1e-6F) << type;
    EXPECT_NEAR(glm::length(all[2].frame.heading()) / whole, 1, 1e-6F) << type;
  }
}

TEST(Counts, ExpressionsGiveWholeNumbers) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("star", "hydra", {{"number", "3 + 0.4*n"}}).component("box", "simple");
  const std::vector<Organ> all = organs_of(builder.link("view", "star").link("star", "box").grow(), "box");
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(glm::length(all[2].frame.heading()), glm::length(all[0].frame.heading()));
}

TEST(Counts, NothingJumpsAsACountRises) {
  const auto organs_at = [](double count, double arc) {
    GraphBuilder builder(builtin_components());
    const Value::List size{1, 0.5};
    builder.component("view", "camera")
        .component("star", "hydra", {{"number", count}, {"arc", arc}, {"radius", 1}, {"size", size}})
        .component("box", "simple");
    return organs_of(builder.link("view", "star").link("star", "box").grow(), "box");
  };
  for (const double arc : {360.0, 120.0}) {
    constexpr double kStep = 1.0 / 512;
    for (double count = 1; count < 5; count += kStep) {
      const std::vector<Organ> before = organs_at(count, arc);
      const std::vector<Organ> after = organs_at(count + kStep, arc);
      for (std::size_t k = 0; k < after.size(); ++k) {
        if (k >= before.size()) {
          EXPECT_LT(glm::length(after[k].frame.heading()), 0.01F) << "a new part begins as nothing";
          continue;
        }
        EXPECT_LT(glm::distance(after[k].frame.heading(), before[k].frame.heading()), 0.02F) << count << ", part " << k;
      }
    }
  }
}

}  // namespace meristem::sequence_test
