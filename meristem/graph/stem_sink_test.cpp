// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/stem_sink.h"

#include <set>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/build_graph.h"
#include "tests/support/probe_component.h"

namespace meristem::stem_sink_test {

using namespace meristem::probe;

using testing::HasSubstr;

TEST(StemSink, AStemThatIsWholeKeepsItsLengthAndFrames) {
  const Plant plant = grow(builder_of("stems"), [](const Probe&, const Site& site, Emitter& out) {
    out.stems().add(straight_stem(site), SurfaceOptions{});
    EXPECT_EQ(out.stems().length_left(), 1);
    for (const NodeIndex node : {NodeIndex{2}, kNoNode}) {
      const auto frame = out.stems().on_rest(node, shifted(3));
      ASSERT_TRUE(frame);
      EXPECT_EQ(frame->origin, Vec3(3, 0, 0));
    }
  });
  ASSERT_EQ(plant.stems.size(), 1U);
  EXPECT_EQ(plant.stems[0].skeleton.node_count(), 3U);
}

TEST(StemSink, AnUnseenStemBearsChildrenAndIsNotInThePlant) {
  const auto children = [](bool is_seen) {
    GraphBuilder builder(registry());
    builder.component("view", "camera").component("probe", "stems").component("seer", "seer");
    builder.link("view", "probe").link("probe", "seer", LinkKind::branch, {{"count", 4}});
    const Plant plant = grow(builder, [&](const Probe&, const Site& site, Emitter& out) {
      is_seen ? out.stems().add(straight_stem(site), SurfaceOptions{}) : out.stems().add_unseen(straight_stem(site));
    });
    EXPECT_EQ(plant.stems.size(), is_seen ? 1U : 0U);
    std::vector<float> heights;
    for (const Seen& one : seen()) heights.push_back(one.site.frame.origin.y);
    return heights;
  };
  const std::vector<float> on_seen = children(true);
  EXPECT_EQ(on_seen.size(), 4U);
  EXPECT_EQ(children(false), on_seen);
}

TEST(StemSink, TooManyNodesOfStemsAreAnInputError) {
  auto builder = builder_of("stems");
  builder.node_limit(5);
  const auto errors = errors_of([&] {
    grow(builder, [](const Probe&, const Site& site, Emitter& out) {
      for (int k = 0; k < 2; ++k) out.stems().add(straight_stem(site), SurfaceOptions{});
    });
  });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_THAT(errors[0].text(), HasSubstr("limits.nodes"));
}

TEST(StemSink, PlaceMovesTheVisibleStemAndNotItsChildren) {
  GraphBuilder builder(registry());
  builder.component("view", "camera").component("seer", "seer");
  builder.component("probe", "stems", {{"place", Value::Object{{"translate", Value::List{5.0, 0.0, 0.0}}}}});
  builder.link("view", "probe").link("probe", "seer", LinkKind::branch, {{"count", 1}});
  const Plant plant = grow(builder, [](const Probe&, const Site& site, Emitter& out) {
    out.stems().add(straight_stem(site), SurfaceOptions{});
  });
  ASSERT_EQ(plant.stems.size(), 1U);
  EXPECT_EQ(plant.stems[0].skeleton.position[0].x, 5);
  ASSERT_EQ(seen().size(), 1U);
  EXPECT_LT(seen()[0].site.frame.origin.x, 1);
}

TEST(StemSink, OrgansAfterAnUnseenStemAreVisible) {
  const Plant plant = grow(builder_of("stems"), [](const Probe&, const Site& site, Emitter& out) {
    out.stems().add_unseen(straight_stem(site));
    out.organs().add(Frame{}, 1, [] { return triangle(); });
  });
  EXPECT_EQ(plant.stems.size(), 0U);
  EXPECT_EQ(organs_of(plant, "probe").size(), 1U);
}

TEST(StemSink, EachStemOfAnInstanceHasAKeyOfItsOwnForItsChildren) {
  std::set<std::uint64_t> keys;
  grow(builder_of("stems"), [&](const Probe&, const Site& site, Emitter& out) {
    for (int k = 0; k < 3; ++k) {
      keys.insert(out.stems().places_on_next().bits());
      out.stems().add(straight_stem(site), SurfaceOptions{});
    }
  });
  EXPECT_EQ(keys.size(), 3U);
}

TEST(StemSink, EachRootOfTheFirstStemOfAPlantIsAPlant) {
  const Plant plant = grow(builder_of("stems"), [](const Probe&, const Site& site, Emitter& out) {
    Skeleton two = straight_stem(site);
    two.add_node(kNoNode, site.frame.point({4, 0, 0}), 0);
    two.radius.back() = 0.01F;
    out.stems().add(std::move(two), SurfaceOptions{});
    out.stems().add(straight_stem(site), SurfaceOptions{});
  });
  ASSERT_EQ(plant.individuals.size(), 2U);
  EXPECT_EQ(plant.individuals[1].foot, Vec3(4, 0, 0));
}

}  // namespace meristem::stem_sink_test
