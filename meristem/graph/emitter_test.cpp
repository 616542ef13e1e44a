// SPDX-License-Identifier: Apache-2.0
// What components are promised when they emit: a component whose expansion each test gives, and a child that notes the
// sites that it stands at.
#include "meristem/graph/emitter.h"

#include <algorithm>
#include <functional>
#include <mutex>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::emitter_test {

using testing::ElementsAre;
using testing::HasSubstr;

struct Probe : ComponentBase {
  Count parts{2.5};
};

using Expansion = std::function<void(const Probe& probe, const Site& site, Emitter& out)>;

/// A child's site, and its time in seconds.
struct Seen {
  Site site;
  double time = 0;
  bool has_directions = false;
};

Expansion expansion;
std::mutex mutex;
std::vector<Seen> seen;

ComponentType probe_type(const std::string& name, bool makes_stems) {
  return define_component<Probe>({
      .traits = {.name = name, .doc = "What a test says.", .makes_stems = makes_stems, .stance = BranchStance::on_axis},
      .parameters = Table<Probe>("a probe", "What a test says."),
      .expand = [](const Probe& probe, const Site& site, Emitter& out) { expansion(probe, site, out); },
  });
}

ComponentType seer_type() {
  return define_component<Probe>({
      .traits = {.name = "seer", .doc = "Notes its site.", .has_geometry = false},
      .parameters = Table<Probe>("a seer", "Notes its site."),
      .expand =
          [](const Probe&, const Site& site, Emitter& out) {
            const std::lock_guard lock(mutex);
            seen.push_back({site, out.time(), out.surroundings().directions != nullptr});
          },
  });
}

struct Many : ComponentBase {};

/// Has three children, a metre apart.
ComponentType many_type() {
  return define_component<Many>({
      .traits = {.name = "many", .doc = "Multiplies.", .has_geometry = false},
      .parameters = Table<Many>("many", "Multiplies."),
      .expand =
          [](const Many&, const Site&, Emitter& out) {
            for (int k = 0; k < 3; ++k) out.child_site(Frame{.origin = {static_cast<float>(k), 0, 0}});
          },
  });
}

ComponentType camera_type() {
  return define_component<Many>({
      .traits = {.name = "camera", .doc = "The root.", .is_camera = true},
      .parameters = Table<Many>("a camera", "The root."),
      .expand = [](const Many&, const Site&, Emitter&) {},
  });
}

const Registry& registry() {
  static const Registry made(
      {camera_type(), probe_type("probe", false), probe_type("stems", true), seer_type(), many_type()});
  return made;
}

/// A camera, a component of this type below it, and a seer on that.
GraphBuilder builder_of(const std::string& type, LinkKind kind = LinkKind::child) {
  GraphBuilder builder(registry());
  builder.component("view", "camera").component("probe", type).component("seer", "seer");
  return builder.link("view", "probe").link("probe", "seer", kind);
}

/// Three probes, each with a seer.
GraphBuilder three_probes() {
  GraphBuilder builder(registry());
  builder.component("view", "camera").component("many", "many").component("probe", "probe").component("seer", "seer");
  return builder.link("view", "many").link("many", "probe").link("probe", "seer");
}

Plant grow(const GraphBuilder& builder, Expansion with, double time = 0) {
  expansion = std::move(with);
  seen.clear();
  Plant plant = builder.grow(time);
  std::ranges::stable_sort(seen, {}, [](const Seen& one) { return one.site.i; });
  return plant;
}

Mesh triangle() {
  return {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .normals = {}, .uvs = {}, .triangles = {{0, 1, 2}}};
}

Frame shifted(float x) { return Frame{.origin = {x, 0, 0}}; }

/// A stem of two segments, a metre each.
Skeleton straight_stem(const Site& site) {
  Skeleton skeleton;
  for (int k = 0; k < 3; ++k) {
    skeleton.add_node(k == 0 ? kNoNode : static_cast<NodeIndex>(k - 1), site.frame.point({0, static_cast<float>(k), 0}),
                      0);
    skeleton.radius.back() = 0.01F;
  }
  return skeleton;
}

TEST(ShapeKey, TellsNumbersAndTheirOrder) {
  EXPECT_EQ(shape_key({1, 2}), shape_key({1, 2}));
  const std::set<std::uint64_t> keys{shape_key({1, 2}), shape_key({2, 1}), shape_key({1, 2, 0}), shape_key({1}),
                                     shape_key({})};
  EXPECT_EQ(keys.size(), 5U);
}

TEST(Emitter, OrgansOfEqualKeysShareWhatOneOfThemMakes) {
  int made = 0;
  const auto make = [&] {
    ++made;
    return triangle();
  };
  const Plant plant = grow(three_probes(), [&](const Probe&, const Site&, Emitter& out) {
    out.organ(Frame{}, 7, make);
    out.organ(shifted(0.5F), 7, make);
  });
  EXPECT_EQ(made, 1);
  EXPECT_EQ(prototypes_of(plant, "probe").size(), 1U);
  ASSERT_EQ(organs_of(plant, "probe").size(), 6U);
  EXPECT_EQ(organs_of(plant, "probe")[5].frame.origin, Vec3(2.5F, 0, 0)) << "in the frame of the last instance";
}

TEST(Emitter, OrgansOfOtherKeysHaveMeshesOfTheirOwn) {
  const Plant plant = grow(three_probes(), [](const Probe&, const Site& site, Emitter& out) {
    out.organ(Frame{}, site.i, [] { return triangle(); });
  });
  EXPECT_EQ(prototypes_of(plant, "probe").size(), 3U);
}

TEST(Emitter, ATintMultipliesTheColourOfItsOrganAlone) {
  const Plant plant = grow(builder_of("probe"), [](const Probe&, const Site&, Emitter& out) {
    out.organ(Frame{}, 1, [] { return triangle(); });
    out.organ(
        Frame{}, 1, [] { return triangle(); }, Vec3(0.5F, 1, 2));
  });
  const std::vector<Organ> organs = organs_of(plant, "probe");
  ASSERT_EQ(organs.size(), 2U);
  EXPECT_EQ(organs[1].tint, organs[0].tint * Vec3(0.5F, 1, 2));
}

TEST(Emitter, AnOrganThatIsNotThereLeavesTheNamesOfLaterOnes) {
  const auto names = [](bool is_there) {
    const Plant plant = grow(builder_of("probe"), [&](const Probe&, const Site&, Emitter& out) {
      out.organ(Frame{}, 1, [] { return triangle(); });
      is_there ? out.organ(Frame{}, 1, [] { return triangle(); }) : out.no_organ();
      out.organ(Frame{}, 1, [] { return triangle(); });
    });
    std::vector<std::uint64_t> found;
    for (const Organ& organ : organs_of(plant, "probe")) found.push_back(organ.name);
    return found;
  };
  const std::vector<std::uint64_t> all = names(true);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(std::set(all.begin(), all.end()).size(), 3U);
  EXPECT_THAT(names(false), ElementsAre(all[0], all[2]));
}

TEST(Emitter, WithoutACallChildrenStandInTheFrameOfTheInstance) {
  grow(builder_of("probe"), [](const Probe&, const Site&, Emitter&) {});
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].site.frame.origin, Vec3(0));
  grow(builder_of("probe"), [](const Probe&, const Site&, Emitter& out) { out.no_children(); });
  EXPECT_TRUE(seen.empty());
}

TEST(Emitter, ChildrenAreNumberedAndSeeTheLengthAndRadiusOfTheirSite) {
  grow(builder_of("probe"), [](const Probe&, const Site&, Emitter& out) {
    for (int k = 0; k < 3; ++k) out.child_site(shifted(static_cast<float>(k)), 2, 0.25F);
  });
  ASSERT_EQ(seen.size(), 3U);
  for (std::uint32_t k = 0; k < 3; ++k) {
    EXPECT_EQ(seen[k].site.i, k);
    EXPECT_EQ(seen[k].site.n, 3U);
    EXPECT_EQ(seen[k].site.frame.origin.x, static_cast<float>(k));
    EXPECT_EQ(seen[k].site.length, 2);
    EXPECT_EQ(seen[k].site.radius, 0.25F);
  }
}

TEST(Emitter, TooManyExpectedChildrenAreRefusedBeforeOneIsMade) {
  bool went_on = false;
  auto builder = builder_of("probe");
  builder.instance_limit(10);
  const auto errors = errors_of([&] {
    grow(builder, [&](const Probe&, const Site&, Emitter& out) {
      out.expect_children(11);
      went_on = true;
    });
  });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_THAT(errors[0].text(), HasSubstr("limits.instances"));
  EXPECT_FALSE(went_on);
}

TEST(Emitter, OfAPartedCountTheLastChildIsSmallerByTheFraction) {
  grow(builder_of("probe"), [](const Probe& probe, const Site&, Emitter& out) {
    const std::uint32_t count = out.expect_parts(member_of(probe, &Probe::parts));
    EXPECT_EQ(count, 3U);
    for (std::uint32_t k = 0; k < count; ++k) out.child_site(Frame{});
  });
  ASSERT_EQ(seen.size(), 3U);
  EXPECT_EQ(seen[1].site.frame.axes, Mat3(1));
  EXPECT_EQ(seen[2].site.frame.axes, Mat3(0.5F));
}

TEST(Emitter, AClockStartsAfterItsDelayAndRunsAtItsSpeed) {
  for (const double time : {1.0, 5.0}) {
    bool has_started = false;
    grow(
        builder_of("probe"),
        [&](const Probe&, const Site&, Emitter& out) {
          EXPECT_EQ(out.time(), time);
          has_started = out.begin_clock(2, 3);
        },
        time);
    ASSERT_EQ(seen.size(), 1U);
    EXPECT_EQ(has_started, time > 2);
    EXPECT_DOUBLE_EQ(seen[0].time, time > 2 ? 9 : 0);
  }
}

TEST(Emitter, SurroundingsHoldForSitesThatAreOfferedLater) {
  grow(builder_of("probe"), [](const Probe&, const Site&, Emitter& out) {
    out.child_site(Frame{});
    Surroundings said = out.surroundings();
    said.directions = std::make_shared<const Directions>(kUp, Vec3(1, 0, 0));
    out.surround(std::move(said));
    out.child_site(Frame{});
  });
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_FALSE(seen[0].has_directions);
  EXPECT_TRUE(seen[1].has_directions);
}

TEST(Emitter, ASiteKnowsTheRowThatPlacedIt) {
  grow(builder_of("probe"), [](const Probe&, const Site&, Emitter& out) {
    out.child_site(Frame{});
    out.from_row(4, false);
    out.child_site(Frame{});
  });
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(seen[0].site.row, 4U);
  EXPECT_EQ(seen[1].site.row, kNoRow);
}

TEST(Emitter, InstancesHaveKeysOfTheirOwnAndOneOfTheirComponent) {
  std::set<std::uint64_t> own, shared;
  grow(three_probes(), [&](const Probe&, const Site& site, Emitter& out) {
    own.insert(site.key.bits());
    shared.insert(out.component_key().bits());
    EXPECT_EQ(out.component(), "probe");
  });
  EXPECT_EQ(own.size(), 3U);
  EXPECT_EQ(shared.size(), 1U);
}

TEST(Emitter, WithoutTimeAGrowthHasComeToItsEnd) {
  grow(builder_of("probe"), [](const Probe&, const Site&, Emitter& out) {
    EXPECT_FALSE(out.grows_in_time());
    EXPECT_EQ(out.grown_to(12), 12);
    EXPECT_EQ(out.watched_growth(), nullptr);
  });
}

TEST(Emitter, BranchChildrenStandAtBranchSitesAndOthersAtChildSites) {
  const auto both = [](const Probe&, const Site&, Emitter& out) {
    out.child_site(shifted(1));
    out.branch_site(shifted(2), 0.25F, 1, 0);
  };
  grow(builder_of("probe", LinkKind::child), both);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].site.frame.origin.x, 1);
  grow(builder_of("probe", LinkKind::branch), both);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].site.frame.origin.x, 2);
  EXPECT_EQ(seen[0].site.u, 0.25F);
  grow(builder_of("probe", LinkKind::branch),
       [](const Probe&, const Site&, Emitter& out) { out.child_site(shifted(1)); });
  ASSERT_EQ(seen.size(), 1U) << "without branch sites they stand where children of child links do";
  EXPECT_EQ(seen[0].site.frame.origin.x, 1);
}

TEST(Emitter, AStemThatIsWholeKeepsItsLengthAndFrames) {
  const Plant plant = grow(builder_of("stems"), [](const Probe&, const Site& site, Emitter& out) {
    out.stem(straight_stem(site), Surface{});
    EXPECT_EQ(out.length_left(), 1);
    for (const NodeIndex node : {NodeIndex{2}, kNoNode}) {
      const auto frame = out.on_stem_left(node, shifted(3));
      ASSERT_TRUE(frame);
      EXPECT_EQ(frame->origin, Vec3(3, 0, 0));
    }
  });
  ASSERT_EQ(plant.stems.size(), 1U);
  EXPECT_EQ(plant.stems[0].skeleton.node_count(), 3U);
}

TEST(Emitter, AnUnseenStemBearsChildrenAndIsNotInThePlant) {
  const auto children = [](bool is_seen) {
    GraphBuilder builder(registry());
    builder.component("view", "camera").component("probe", "stems").component("seer", "seer");
    builder.link("view", "probe").link("probe", "seer", LinkKind::branch, {{"count", 4}});
    const Plant plant = grow(builder, [&](const Probe&, const Site& site, Emitter& out) {
      is_seen ? out.stem(straight_stem(site), Surface{}) : out.unseen_stem(straight_stem(site));
    });
    EXPECT_EQ(plant.stems.size(), is_seen ? 1U : 0U);
    std::vector<float> heights;
    for (const Seen& one : seen) heights.push_back(one.site.frame.origin.y);
    return heights;
  };
  const std::vector<float> on_seen = children(true);
  EXPECT_EQ(on_seen.size(), 4U);
  EXPECT_EQ(children(false), on_seen);
}

TEST(Emitter, TooManyNodesOfStemsAreAnInputError) {
  auto builder = builder_of("stems");
  builder.node_limit(5);
  const auto errors = errors_of([&] {
    grow(builder, [](const Probe&, const Site& site, Emitter& out) {
      for (int k = 0; k < 2; ++k) out.stem(straight_stem(site), Surface{});
    });
  });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_THAT(errors[0].text(), HasSubstr("limits.nodes"));
}

}  // namespace meristem::emitter_test
