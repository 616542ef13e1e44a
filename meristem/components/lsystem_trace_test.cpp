// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/lsystem_trace.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"

namespace meristem::lsystem_trace_test {

using testing::HasSubstr;

GraphBuilder traced_plant(const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("plant", "lsystem", parameters).link("view", "plant");
  return builder;
}

std::optional<LsystemTrace> trace_of(const GraphBuilder& builder, std::optional<int> steps = {},
                                     const std::string& id = "plant") {
  Progress progress;
  return trace_lsystem(builder.sound_graph(), Scene(), id, {.steps = steps}, 0, progress);
}

// Returns the segments of the only stem as pairs of ends, in unspecified order.
std::vector<std::array<float, 6>> segments_of(const Plant& plant) {
  std::vector<std::array<float, 6>> segments;
  const Skeleton& skeleton = plant.stems.at(0).skeleton;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.is_root(node)) continue;
    const Vec3 from = skeleton.position[skeleton.parent[node]];
    const Vec3 to = skeleton.position[node];
    segments.push_back({from.x, from.y, from.z, to.x, to.y, to.z});
  }
  std::ranges::sort(segments);
  return segments;
}

TEST(LsystemTrace, HasTheWordOfEachStep) {
  const GraphBuilder builder = traced_plant({{"grammar", "F\n#rules\nF -> F[+F]F"}, {"steps", 3}});
  const auto now = trace_of(builder);
  ASSERT_TRUE(now);
  EXPECT_EQ(now->steps, 3);
  EXPECT_EQ(now->text, "F\n#rules\nF -> F[+F]F");
  EXPECT_FALSE(now->is_interpreted);
  const auto first = trace_of(builder, 1);
  EXPECT_EQ(word_text(first->derived, first->alphabet), "F[+F]F");
  EXPECT_EQ(first->places.size(), 3U);
  EXPECT_EQ(first->places[1].module, 3U);
}

TEST(LsystemTrace, DrawsWhatThePlantIsMadeOf) {
  // With random rules, and moved by the component's frame.
  const GraphBuilder builder = traced_plant({{"grammar", "F\n#rules\nF : 1 -> F[+F]F\nF : 1 -> F[-F]FF"},
                                             {"steps", 4},
                                             {"frame", Value::Object{{"translate", Value::List{1, 2, 3}}}}});
  const auto trace = trace_of(builder);
  ASSERT_TRUE(trace);
  std::vector<std::array<float, 6>> drawn;
  for (const DrawnModule& place : trace->places) {
    EXPECT_EQ(trace->alphabet[trace->drawn.letters[place.module]].symbol, "F");
    drawn.push_back({place.from.x, place.from.y, place.from.z, place.to.x, place.to.y, place.to.z});
  }
  EXPECT_TRUE(std::ranges::is_sorted(trace->places, {}, &DrawnModule::module));
  std::ranges::sort(drawn);
  EXPECT_EQ(drawn, segments_of(builder.grow()));
}

TEST(LsystemTrace, TellsTheDerivedWordFromTheDrawnOne) {
  const auto trace = trace_of(traced_plant({{"grammar", "A\n#rules\nA -> A A\n#interpret\nA -> F"}, {"steps", 2}}));
  ASSERT_TRUE(trace);
  EXPECT_TRUE(trace->is_interpreted);
  EXPECT_EQ(word_text(trace->derived, trace->alphabet), "AAAA");
  EXPECT_EQ(word_text(trace->drawn, trace->alphabet), "FFFF");
}

TEST(LsystemTrace, FindsAnInstanceByItsKeyAndByItsNumber) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("ring", "hydra", {{"number", 4}, {"radius", 1}});
  builder.component("plant", "lsystem", {{"grammar", "F\n#rules\nF : 1 -> F[+F]F\nF : 1 -> F[-F]FF"}, {"steps", 4}});
  builder.link("view", "ring").link("ring", "plant");
  const auto trace = [&](const LsystemTraceRequest& request) {
    Progress progress;
    return *trace_lsystem(builder.sound_graph(), Scene(), "plant", request, 0, progress);
  };
  const LsystemTrace first = trace({});
  EXPECT_EQ(first.number, 0U);
  EXPECT_EQ(first.count, 4U);
  const LsystemTrace third = trace({.number = 2});
  EXPECT_EQ(third.site.i, 2U);
  EXPECT_NE(word_text(third.derived, third.alphabet), word_text(first.derived, first.alphabet));
  const LsystemTrace again = trace({.key = third.site.key.bits()});
  EXPECT_EQ(again.number, 2U);
  EXPECT_EQ(again.places, third.places);
  EXPECT_EQ(trace({.key = 1}).number, 0U);      // of no instance
  EXPECT_EQ(trace({.number = 99}).number, 3U);  // beyond the last
}

TEST(LsystemTrace, IsNothingForOtherComponents) {
  GraphBuilder builder = traced_plant({{"grammar", "F"}, {"steps", 0}});
  EXPECT_FALSE(trace_of(builder, {}, "view"));
  EXPECT_FALSE(trace_of(builder, {}, "nobody"));
}

TEST(LsystemTrace, SaysTheLineOfAFault) {
  const GraphBuilder builder = traced_plant({{"grammar", "F(1)\n#rules\nF(x) -> F(1/(x-1))"}, {"steps", 0}});
  const auto errors = errors_of([&] { trace_of(builder, 2); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "components.plant.grammar");
  EXPECT_THAT(errors[0].message, HasSubstr("line 3"));
}

}  // namespace meristem::lsystem_trace_test
