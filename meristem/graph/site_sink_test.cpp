// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/site_sink.h"

#include <memory>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/build_graph.h"
#include "tests/support/probe_component.h"

namespace meristem::site_sink_test {

using namespace meristem::probe;

using testing::ElementsAre;
using testing::HasSubstr;

TEST(SiteSink, WithoutACallChildrenStandInTheFrameOfTheInstance) {
  grow(builder_of("probe"), [](const Probe&, const Site&, Emitter&) {});
  ASSERT_EQ(seen().size(), 1U);
  EXPECT_EQ(seen()[0].site.frame.origin, Vec3(0));
  grow(builder_of("probe"), [](const Probe&, const Site&, Emitter& out) { out.sites().no_children(); });
  EXPECT_TRUE(seen().empty());
}

TEST(SiteSink, ChildrenAreNumberedAndSeeTheLengthAndRadiusOfTheirSite) {
  grow(builder_of("probe"), [](const Probe&, const Site&, Emitter& out) {
    for (int k = 0; k < 3; ++k) out.sites().add(shifted(static_cast<float>(k)), 2, 0.25F);
  });
  ASSERT_EQ(seen().size(), 3U);
  for (std::uint32_t k = 0; k < 3; ++k) {
    EXPECT_EQ(seen()[k].site.i, k);
    EXPECT_EQ(seen()[k].site.n, 3U);
    EXPECT_EQ(seen()[k].site.frame.origin.x, static_cast<float>(k));
    EXPECT_EQ(seen()[k].site.length, 2);
    EXPECT_EQ(seen()[k].site.radius, 0.25F);
  }
}

TEST(SiteSink, TooManyExpectedChildrenAreRefusedBeforeOneIsMade) {
  bool went_on = false;
  auto builder = builder_of("probe");
  builder.instance_limit(10);
  const auto errors = errors_of([&] {
    grow(builder, [&](const Probe&, const Site&, Emitter& out) {
      out.sites().expect(11);
      went_on = true;
    });
  });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_THAT(errors[0].text(), HasSubstr("limits.instances"));
  EXPECT_FALSE(went_on);
}

TEST(SiteSink, OfAPartedCountTheLastChildIsSmallerByTheFraction) {
  grow(builder_of("probe"), [](const Probe& probe, const Site&, Emitter& out) {
    const std::uint32_t count = out.sites().expect_parts(member_of(probe, &Probe::parts));
    EXPECT_EQ(count, 3U);
    for (std::uint32_t k = 0; k < count; ++k) out.sites().add(Frame{});
  });
  ASSERT_EQ(seen().size(), 3U);
  EXPECT_EQ(seen()[1].site.frame.axes, Mat3(1));
  EXPECT_EQ(seen()[2].site.frame.axes, Mat3(0.5F));
}

TEST(SiteSink, AClockStartsAfterItsDelayAndRunsAtItsSpeed) {
  for (const double time : {1.0, 5.0}) {
    bool has_started = false;
    grow(
        builder_of("probe"),
        [&](const Probe&, const Site&, Emitter& out) {
          EXPECT_EQ(out.context().time(), time);
          has_started = out.sites().begin_clock(2, 3);
        },
        time);
    ASSERT_EQ(seen().size(), 1U);
    EXPECT_EQ(has_started, time > 2);
    EXPECT_DOUBLE_EQ(seen()[0].time, time > 2 ? 9 : 0);
  }
}

TEST(SiteSink, SurroundingsHoldForSitesThatAreOfferedLater) {
  grow(builder_of("probe"), [](const Probe&, const Site&, Emitter& out) {
    out.sites().add(Frame{});
    Surroundings said = out.context().surroundings();
    said.directions = std::make_shared<const Directions>(kUp, Vec3(1, 0, 0));
    out.sites().surround(std::move(said));
    out.sites().add(Frame{});
  });
  ASSERT_EQ(seen().size(), 2U);
  EXPECT_FALSE(seen()[0].has_directions);
  EXPECT_TRUE(seen()[1].has_directions);
}

TEST(SiteSink, ASiteKnowsTheRowThatPlacedIt) {
  grow(builder_of("probe"), [](const Probe&, const Site&, Emitter& out) {
    out.sites().add(Frame{});
    out.sites().from_row(4, false);
    out.sites().add(Frame{});
  });
  ASSERT_EQ(seen().size(), 2U);
  EXPECT_EQ(seen()[0].site.row, 4U);
  EXPECT_EQ(seen()[1].site.row, kNoRow);
}

TEST(SiteSink, BranchChildrenStandAtBranchSitesAndOthersAtChildSites) {
  const auto both = [](const Probe&, const Site&, Emitter& out) {
    out.sites().add(shifted(1));
    out.sites().add_for_branches(shifted(2), 0.25F, 1, 0);
  };
  grow(builder_of("probe", LinkKind::child), both);
  ASSERT_EQ(seen().size(), 1U);
  EXPECT_EQ(seen()[0].site.frame.origin.x, 1);
  grow(builder_of("probe", LinkKind::branch), both);
  ASSERT_EQ(seen().size(), 1U);
  EXPECT_EQ(seen()[0].site.frame.origin.x, 2);
  EXPECT_EQ(seen()[0].site.u, 0.25F);
  grow(builder_of("probe", LinkKind::branch),
       [](const Probe&, const Site&, Emitter& out) { out.sites().add(shifted(1)); });
  ASSERT_EQ(seen().size(), 1U) << "without branch sites they stand where children of child links do";
  EXPECT_EQ(seen()[0].site.frame.origin.x, 1);
}

TEST(SiteSink, SitesAreRelativeToTheFrameOfTheInstance) {
  GraphBuilder builder = builder_of("probe");
  builder.component("probe", "probe", {{"frame", Value::Object{{"scale", Value::List{2.0, 2.0, 2.0}}}}});
  grow(builder, [](const Probe&, const Site&, Emitter& out) { out.sites().add(shifted(1), 3, 0.5F); });
  ASSERT_EQ(seen().size(), 1U);
  EXPECT_EQ(seen()[0].site.frame.origin.x, 2);
  EXPECT_EQ(seen()[0].site.length, 6);
  EXPECT_EQ(seen()[0].site.radius, 1);
}

TEST(SiteSink, ASiteAfterAStemStandsOnIt) {
  grow(builder_of("stems"), [](const Probe&, const Site& site, Emitter& out) {
    out.stems().add(straight_stem(site), SurfaceOptions{});
    out.sites().add_at_tip(Frame{.origin = {0, 2, 0}}, 2, 0.01F);
  });
  ASSERT_EQ(seen().size(), 1U);
  EXPECT_NE(seen()[0].site.stem, kOnNoStem);
  EXPECT_EQ(seen()[0].site.node, 2U);
  EXPECT_EQ(seen()[0].site.length, 2);
}

TEST(SiteSink, APlainNumberIsEqualForAllChildren) {
  grow(builder_of("probe"), [](const Probe&, const Site&, Emitter& out) {
    EXPECT_THAT(out.sites().per_child(PerChild(1.5), 3), ElementsAre(1.5, 1.5, 1.5));
    EXPECT_TRUE(out.sites().per_child(PerChild(1.5), 0).empty());
  });
}

}  // namespace meristem::site_sink_test
