// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/emitter.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/build_graph.h"
#include "tests/support/probe_component.h"

namespace meristem::emitter_test {

using namespace meristem::probe;

using testing::ElementsAre;
using testing::HasSubstr;

/// Emits an organ and a site for a child.
void emit_both(const Probe&, const Site&, Emitter& out) {
  out.organs().add(Frame{}, 1, [] { return triangle(); });
  out.sites().add(Frame{});
}

GraphBuilder with_parameters(const Value::Object& parameters) {
  GraphBuilder builder = builder_of("probe");
  builder.component("probe", "probe", parameters);
  return builder;
}

TEST(Emitter, AHiddenInstanceHasChildrenAndNoOrgans) {
  const Plant plant = grow(with_parameters({{"hidden", true}}), emit_both);
  EXPECT_TRUE(organs_of(plant, "probe").empty());
  EXPECT_EQ(seen().size(), 1U);
}

TEST(Emitter, AnInstanceWithoutSizeIsNotExpanded) {
  int expanded = 0;
  GraphBuilder builder(registry());
  builder.component("view", "camera").component("above", "probe").component("probe", "probe");
  builder.component("seer", "seer").link("view", "above").link("above", "probe").link("probe", "seer");
  grow(builder, [&](const Probe&, const Site&, Emitter& out) {
    ++expanded;
    out.sites().add(Frame{.axes = Mat3(0), .origin = Vec3(0)});
  });
  EXPECT_EQ(expanded, 1) << "only the instance above";
  EXPECT_TRUE(seen().empty());
}

TEST(Emitter, AnOmittedInstanceHasChildrenOnlyIfTheyAreKept) {
  for (const bool keeps : {false, true}) {
    const Value::List omit{"i >= 0"};
    const Plant plant = grow(with_parameters({{"omit", omit}, {"omit_keeps_children", keeps}}), emit_both);
    EXPECT_TRUE(organs_of(plant, "probe").empty());
    EXPECT_EQ(seen().size(), keeps ? 1U : 0U);
  }
}

TEST(Emitter, AFrameThatIsNotFiniteIsAnInputError) {
  const auto errors = errors_of([] {
    GraphBuilder builder(registry());
    builder.component("view", "camera").component("far", "probe").component("probe", "probe");
    builder.link("view", "far").link("far", "probe");
    grow(builder, [](const Probe&, const Site&, Emitter& out) { out.sites().add(shifted(HUGE_VALF)); });
  });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_THAT(errors[0].text(), HasSubstr("is not finite"));
}

std::vector<std::string> calls;

void expand_nothing(const Probe&, const Site&) { calls.emplace_back("nothing"); }
void expand_sites(const Probe&, const Site&, SiteSink& sites) {
  calls.emplace_back("sites");
  sites.no_children();
}
void expand_in_another_order(const Probe&, const Site&, SiteSink& sites, const InstanceContext& instance,
                             StemSink& stems, OrganSink& organs) {
  organs.skip();
  stems.stands_as_grown();
  sites.no_children();
  calls.push_back(instance.component());
}

TEST(ExpandFunction, TakesWhatItNeedsInAnyOrder) {
  calls.clear();
  for (const ExpandFunction<Probe>& expand :
       {ExpandFunction<Probe>(expand_nothing), ExpandFunction<Probe>(expand_sites),
        ExpandFunction<Probe>(expand_in_another_order),
        ExpandFunction<Probe>([](const Probe&, const Site&, OrganSink&) { calls.emplace_back("lambda"); })}) {
    grow(builder_of("probe"), expand);
  }
  EXPECT_THAT(calls, ElementsAre("nothing", "sites", "probe", "lambda"));
}

struct Other : ComponentBase {};
static_assert(!std::is_constructible_v<ExpandFunction<Probe>, void (*)(const Other&, const Site&, SiteSink&)>);

}  // namespace meristem::emitter_test
