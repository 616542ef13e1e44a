// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/organ_sink.h"

#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/build_graph.h"
#include "tests/support/probe_component.h"

namespace meristem::organ_sink_test {

using namespace meristem::probe;

using testing::ElementsAre;
using testing::HasSubstr;

TEST(ShapeKey, TellsNumbersAndTheirOrder) {
  EXPECT_EQ(shape_key({1, 2}), shape_key({1, 2}));
  const std::set<std::uint64_t> keys{shape_key({1, 2}), shape_key({2, 1}), shape_key({1, 2, 0}), shape_key({1}),
                                     shape_key({})};
  EXPECT_EQ(keys.size(), 5U);
}

TEST(OrganSink, OrgansOfEqualKeysShareWhatOneOfThemMakes) {
  int made = 0;
  const auto make = [&] {
    ++made;
    return triangle();
  };
  const Plant plant = grow(three_probes(), [&](const Probe&, const Site&, Emitter& out) {
    out.organs().add(Frame{}, 7, make);
    out.organs().add(shifted(0.5F), 7, make);
  });
  EXPECT_EQ(made, 1);
  EXPECT_EQ(prototypes_of(plant, "probe").size(), 1U);
  ASSERT_EQ(organs_of(plant, "probe").size(), 6U);
  EXPECT_EQ(organs_of(plant, "probe")[5].frame.origin, Vec3(2.5F, 0, 0)) << "in the frame of the last instance";
}

TEST(OrganSink, OrgansOfOtherKeysHaveMeshesOfTheirOwn) {
  const Plant plant = grow(three_probes(), [](const Probe&, const Site& site, Emitter& out) {
    out.organs().add(Frame{}, site.i, [] { return triangle(); });
  });
  EXPECT_EQ(prototypes_of(plant, "probe").size(), 3U);
}

TEST(OrganSink, ATintMultipliesTheColourOfItsOrganAlone) {
  const Plant plant = grow(builder_of("probe"), [](const Probe&, const Site&, Emitter& out) {
    out.organs().add(Frame{}, 1, [] { return triangle(); });
    out.organs().add(
        Frame{}, 1, [] { return triangle(); }, Vec3(0.5F, 1, 2));
  });
  const std::vector<Organ> organs = organs_of(plant, "probe");
  ASSERT_EQ(organs.size(), 2U);
  EXPECT_EQ(organs[1].tint, organs[0].tint * Vec3(0.5F, 1, 2));
}

TEST(OrganSink, AnOrganThatIsNotThereLeavesTheNamesOfLaterOnes) {
  const auto names = [](bool is_there) {
    const Plant plant = grow(builder_of("probe"), [&](const Probe&, const Site&, Emitter& out) {
      out.organs().add(Frame{}, 1, [] { return triangle(); });
      is_there ? out.organs().add(Frame{}, 1, [] { return triangle(); }) : out.organs().skip();
      out.organs().add(Frame{}, 1, [] { return triangle(); });
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

TEST(OrganSink, BladesKeepTheColourOfTheirMaterial) {
  const Plant plant = grow(builder_of("probe"), [](const Probe&, const Site&, Emitter& out) {
    out.organs().add_blade(
        Frame{}, 1, [] { return triangle(); }, Vec3(0.5F, 1, 2));
  });
  const std::vector<Organ> organs = organs_of(plant, "probe");
  ASSERT_EQ(organs.size(), 1U);
  EXPECT_EQ(organs[0].tint, Vec3(0.5F, 1, 2)) << "without the random colour of the instance";
}

TEST(OrganSink, PlaceMovesOrgansAndNoSites) {
  GraphBuilder builder = builder_of("probe");
  builder.component("probe", "probe", {{"place", Value::Object{{"translate", Value::List{5.0, 0.0, 0.0}}}}});
  const Plant plant = grow(builder, [](const Probe&, const Site&, Emitter& out) {
    out.organs().add(shifted(1), 1, [] { return triangle(); });
    out.sites().add(shifted(1));
  });
  ASSERT_EQ(organs_of(plant, "probe").size(), 1U);
  EXPECT_EQ(organs_of(plant, "probe")[0].frame.origin, Vec3(6, 0, 0));
  ASSERT_EQ(seen().size(), 1U);
  EXPECT_EQ(seen()[0].site.frame.origin, Vec3(1, 0, 0));
}

TEST(OrganSink, TooManyBytesOfMeshesAreAnInputError) {
  GraphBuilder builder = builder_of("probe");
  builder.mesh_limit(10);
  const auto errors = errors_of([&] {
    grow(builder,
         [](const Probe&, const Site&, Emitter& out) { out.organs().add(Frame{}, 1, [] { return triangle(); }); });
  });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_THAT(errors[0].text(), HasSubstr("limits.mesh_bytes"));
}

}  // namespace meristem::organ_sink_test
