// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/instance_context.h"

#include <memory>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/build_graph.h"
#include "tests/support/probe_component.h"

namespace meristem::instance_context_test {

using namespace meristem::probe;

TEST(InstanceContext, InstancesHaveKeysOfTheirOwnAndOneOfTheirComponent) {
  std::set<std::uint64_t> own, shared;
  grow(three_probes(), [&](const Probe&, const Site& site, Emitter& out) {
    own.insert(site.key.bits());
    shared.insert(out.context().component_key().bits());
    EXPECT_EQ(out.context().component(), "probe");
  });
  EXPECT_EQ(own.size(), 3U);
  EXPECT_EQ(shared.size(), 1U);
}

TEST(InstanceContext, WithoutTimeAGrowthHasComeToItsEnd) {
  grow(builder_of("probe"), [](const Probe&, const Site&, Emitter& out) {
    EXPECT_FALSE(out.context().grows_in_time());
    EXPECT_EQ(out.stems().grown_to(12), 12);
    EXPECT_EQ(out.context().watched_growth(), nullptr);
  });
}

TEST(InstanceContext, AMemberVariesIfTheDocumentVariesIt) {
  GraphBuilder builder = builder_of("probe");
  builder.component("probe", "probe", {{"size", Value::List{1.0, 2.0}}, {"age", 3.0}});
  grow(builder, [](const Probe& probe, const Site&, Emitter& out) {
    EXPECT_TRUE(out.context().varies(member_of(probe, &Probe::size)));
    EXPECT_FALSE(out.context().varies(member_of(probe, &Probe::age)));
  });
}

TEST(InstanceContext, DirectionsAreThoseOfTheSceneUnlessAComponentSetsThem) {
  const Vec3 east(1, 0, 0);
  Vec3 below(0);
  GraphBuilder builder(registry());
  builder.component("view", "camera").component("above", "probe").component("probe", "probe");
  builder.link("view", "above").link("above", "probe");
  grow(builder, [&](const Probe&, const Site&, Emitter& out) {
    const InstanceContext& instance = out.context();
    if (instance.component() == "probe") {
      below = instance.directions().gravity(Vec3(0)).vector();
      return;
    }
    EXPECT_EQ(instance.surroundings().directions, nullptr);
    Surroundings changed = instance.surroundings();
    changed.directions = std::make_shared<const Directions>(kUp, east);
    out.sites().surround(std::move(changed));
  });
  EXPECT_EQ(below, east);
}

}  // namespace meristem::instance_context_test
