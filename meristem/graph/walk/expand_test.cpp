// SPDX-License-Identifier: Apache-2.0
// Links, recursions, omissions, frames, randomness and limits, on components with plain geometry.
#include "meristem/graph/expand.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/cache.h"
#include "meristem/base/parallel.h"
#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::expand_test {

GraphBuilder with_camera() {
  GraphBuilder builder(test_components());
  return builder.component("view", "camera");
}

// A star of `number` sticks.
GraphBuilder star_of(int number, const Value::Object& stick = {}) {
  auto builder = with_camera().component("star", "star", {{"number", number}}).component("stick", "stick", stick);
  return builder.link("view", "star").link("star", "stick");
}

std::size_t count_of(const GraphBuilder& builder, std::string_view component) {
  return organs_of(builder.grow(), component).size();
}

// The x coordinates of a component's organs, sorted and rounded.
std::vector<int> places_of(const Plant& plant, std::string_view component) {
  std::vector<int> places;
  for (const Organ& organ : organs_of(plant, component))
    places.push_back(static_cast<int>(organ.frame.origin.x + 0.5F));
  std::sort(places.begin(), places.end());
  return places;
}

// A stalk, three branches of sticks that recurse: the example of the p-graph's source.
GraphBuilder source_example() {
  auto builder = with_camera().component("B", "stick").component("C", "star", {{"number", 3}});
  builder.component("D", "stick", {{"recursion", 3}});
  return builder.link("view", "B").link("B", "C").link("C", "D").link("D", "D");
}

TEST(Expand, TheSourcesExampleHasNineInstancesOfD) {
  // Figure 6.1: a recursion of three instances, multiplied by three.
  const Plant plant = source_example().grow();
  EXPECT_EQ(organs_of(plant, "B").size(), 1U);
  ASSERT_EQ(organs_of(plant, "D").size(), 9U);
  std::vector<float> heights;
  for (const Organ& organ : organs_of(plant, "D")) heights.push_back(organ.frame.origin.y);
  std::sort(heights.begin(), heights.end());
  EXPECT_EQ(heights, (std::vector<float>{1, 1, 1, 2, 2, 2, 3, 3, 3}));
}

TEST(Expand, AMultiplierOfNoneHasNoChildren) { EXPECT_EQ(count_of(star_of(0), "stick"), 0U); }

TEST(Expand, ChildrenStandWhereTheirParentEnds) {
  auto builder = with_camera().component("a", "stick", {{"length", 2}}).component("b", "stick");
  const Plant plant = builder.link("view", "a").link("a", "b").grow();
  EXPECT_EQ(organs_of(plant, "b").at(0).frame.origin, Vec3(0, 2, 0));
}

TEST(Expand, LeafLinksLeadOnOnlyWhereTheRecursionEnds) {
  auto builder = source_example().component("leaf", "stick").component("bud", "stick");
  builder.link("D", "leaf", LinkKind::leaf).link("D", "bud");
  const Plant plant = builder.grow();
  EXPECT_EQ(organs_of(plant, "bud").size(), 9U);
  const std::vector<Organ> leaves = organs_of(plant, "leaf");
  ASSERT_EQ(leaves.size(), 3U);
  for (const Organ& leaf : leaves) EXPECT_EQ(leaf.frame.origin.y, 4);
}

TEST(Expand, LeafLinksOutsideOfRecursionsAreChildLinks) {
  auto builder = star_of(3).component("leaf", "stick").link("stick", "leaf", LinkKind::leaf);
  EXPECT_EQ(count_of(builder, "leaf"), 3U);
}

TEST(Expand, BranchLinksFollowTheRibsAndChildLinksTheEnd) {
  auto builder = with_camera().component("ribs", "ribs", {{"number", 4}});
  builder.component("side", "stick").component("top", "stick");
  builder.link("view", "ribs").link("ribs", "side", LinkKind::branch).link("ribs", "top");
  const Plant plant = builder.grow();
  EXPECT_EQ(organs_of(plant, "side").size(), 4U);
  EXPECT_EQ(organs_of(plant, "side")[3].frame.origin.y, 3);
  ASSERT_EQ(organs_of(plant, "top").size(), 1U);
  EXPECT_EQ(organs_of(plant, "top")[0].frame.origin.y, 4);
}

TEST(Expand, AnInstanceWithoutRibsHasNoBranchChildrenWhateverItsNeighboursHave) {
  auto builder = with_camera().component("star", "star", {{"number", 300}});
  builder.component("ribs", "ribs", {{"number", "i == 299 ? 2 : 0"}}).component("side", "stick");
  builder.link("view", "star").link("star", "ribs").link("ribs", "side", LinkKind::branch);
  EXPECT_EQ(count_of(builder, "side"), 2U);
}

TEST(Expand, BranchLinksFromOtherComponentsAreChildLinks) {
  auto branch = star_of(3).component("side", "stick").link("stick", "side", LinkKind::branch);
  auto child = star_of(3).component("side", "stick").link("stick", "side", LinkKind::child);
  EXPECT_EQ(hash_of(branch.grow()), hash_of(child.grow()));
}

TEST(Expand, DepthCountsTheLinksBackAndStaysKnownBelow) {
  auto builder = with_camera().component("D", "stick", {{"recursion", 4}, {"length", "1 + depth"}});
  builder.component("leaf", "stick", {{"length", "1 + depth"}});
  const Plant plant = builder.link("view", "D").link("D", "D").link("D", "leaf", LinkKind::leaf).grow();
  std::vector<float> heights;
  for (const Organ& organ : organs_of(plant, "D")) heights.push_back(organ.frame.origin.y);
  EXPECT_EQ(heights, (std::vector<float>{0, 1, 3, 6}));
  EXPECT_EQ(plant.prototypes[organs_of(plant, "leaf").at(0).prototype].mesh->positions[2].y, 4);
}

TEST(Expand, ANestedRecursionStartsAnewInEachRoundOfTheOuter) {
  // B recurses 2 times; from each of the three B a link leads back to A, once.
  auto builder = with_camera().component("A", "stick", {{"recursion", 2}}).component("B", "stick", {{"recursion", 3}});
  builder.link("view", "A").link("A", "B").link("B", "B").link("B", "A");
  const Plant plant = builder.grow();
  EXPECT_EQ(organs_of(plant, "A").size(), 1U + 3U);
  EXPECT_EQ(organs_of(plant, "B").size(), 3U * (1 + 3));
}

TEST(Expand, ASideLoopWithinARecursionCountsOnItsOwn) {
  // B > D > B goes round twice in each round of A > B > A.
  auto builder = with_camera().component("A", "stick", {{"recursion", 2}}).component("B", "stick", {{"recursion", 3}});
  builder.component("D", "stick");
  builder.link("view", "A").link("A", "B").link("B", "A").link("B", "D").link("D", "B");
  const Plant plant = builder.grow();
  EXPECT_EQ(organs_of(plant, "A").size(), 1U + 3U);
  EXPECT_EQ(organs_of(plant, "B").size(), 3U * (1 + 3));
  EXPECT_EQ(organs_of(plant, "D").size(), 3U * (1 + 3));
}

TEST(Expand, TwoLinksBackToOneAncestorShareItsDepth) {
  // A binary tree of depth 3.
  auto builder = with_camera().component("A", "stick", {{"recursion", 4}});
  builder.link("view", "A").link("A", "A").link("A", "A");
  EXPECT_EQ(count_of(builder, "A"), 1U + 2 + 4 + 8);
}

TEST(Expand, OmittedInstancesAreWithoutGeometryAndChildren) {
  const Value::List list{0, Value::List{3, 5}, "i % 4 == 2"};
  auto builder = star_of(8, {{"omit", list}}).component("leaf", "stick").link("stick", "leaf");
  const Plant plant = builder.grow();
  EXPECT_EQ(places_of(plant, "stick"), (std::vector<int>{1, 7}));
  EXPECT_EQ(places_of(plant, "leaf"), (std::vector<int>{1, 7}));
}

TEST(Expand, OnlyIsTheComplementOfOmit) {
  const Value::List list{0, Value::List{3, 5}, "i % 4 == 2"};
  EXPECT_EQ(places_of(star_of(8, {{"only", list}}).grow(), "stick"), (std::vector<int>{0, 2, 3, 4, 5, 6}));
}

TEST(Expand, ComplementaryListsGiveTwoKindsOfChildOnOneStem) {
  const Value::List list{1, Value::List{4, 5}};
  auto builder = star_of(8, {{"omit", list}}).component("other", "stick", {{"only", list}}).link("star", "other");
  const Plant plant = builder.grow();
  EXPECT_EQ(places_of(plant, "stick"), (std::vector<int>{0, 2, 3, 6, 7}));
  EXPECT_EQ(places_of(plant, "other"), (std::vector<int>{1, 4, 5}));
}

TEST(Expand, ChildrenOfOmittedInstancesStayWhereAsked) {
  auto builder = star_of(4, {{"omit", Value::List{1}}, {"omit_keeps_children", true}});
  const Plant plant = builder.component("leaf", "stick").link("stick", "leaf").grow();
  EXPECT_EQ(places_of(plant, "stick"), (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(places_of(plant, "leaf"), (std::vector<int>{0, 1, 2, 3}));
}

TEST(Expand, HiddenComponentsKeepTheirChildrenInPlace) {
  auto builder = star_of(4).component("leaf", "stick").link("stick", "leaf");
  const std::string leaves = hash_of(builder.grow(), "leaf");
  const Plant plant = builder.component("stick", "stick", {{"hidden", true}}).grow();
  EXPECT_TRUE(organs_of(plant, "stick").empty());
  EXPECT_EQ(hash_of(plant, "leaf"), leaves);
}

TEST(Expand, PlaceMovesOwnGeometryOnly) {
  const auto moved = [](const char* key) {
    const Value::Object transform{{"translate", Value::List{0, 0, 5}}, {"scale", Value::List{2, 2, 2}}};
    auto builder = star_of(2, {{key, transform}}).component("leaf", "stick").link("stick", "leaf");
    return builder.grow();
  };
  const Plant place = moved("place");
  EXPECT_EQ(organs_of(place, "stick")[1].frame.origin, Vec3(1, 0, 5));
  EXPECT_EQ(organs_of(place, "stick")[1].frame.heading(), Vec3(0, 2, 0));
  EXPECT_EQ(organs_of(place, "leaf")[1].frame.origin, Vec3(1, 1, 0));
  EXPECT_EQ(organs_of(place, "leaf")[1].frame.heading(), Vec3(0, 1, 0));
  const Plant frame = moved("frame");
  EXPECT_EQ(organs_of(frame, "stick")[1].frame.origin, Vec3(1, 0, 5));
  EXPECT_EQ(organs_of(frame, "leaf")[1].frame.origin, Vec3(1, 2, 5));
  EXPECT_EQ(organs_of(frame, "leaf")[1].frame.heading(), Vec3(0, 2, 0));
}

TEST(Expand, PlaceMovesAStemButNotWhatStandsOnIt) {
  const auto grow = [](const Value::Object& place) {
    auto builder = with_camera().component("pole", "pole", {{"place", place}}).component("leaf", "stick");
    return builder.link("view", "pole").link("pole", "leaf", LinkKind::branch).grow();
  };
  const Plant plain = grow({});
  const Plant moved = grow({{"translate", Value::List{3, 0, 0}}, {"scale", Value::List{2, 2, 2}}});
  EXPECT_EQ(hash_of(plain, "leaf"), hash_of(moved, "leaf"));
  EXPECT_EQ(plain.stems.at(0).skeleton.position.back(), Vec3(0, 2, 0));
  EXPECT_LT(glm::distance(moved.stems.at(0).skeleton.position.back(), Vec3(3, 4, 0)), 1e-6F);
  EXPECT_FLOAT_EQ(moved.stems[0].skeleton.radius[0], 2 * plain.stems[0].skeleton.radius[0]);
}

TEST(Expand, LeafLinksFromAStemStandAtItsTip) {
  auto builder = with_camera().component("pole", "pole").component("leaf", "stick", {{"length", "1 + radius"}});
  const Plant plant = builder.link("view", "pole").link("pole", "leaf", LinkKind::leaf).grow();
  const std::vector<Organ> leaves = organs_of(plant, "leaf");
  ASSERT_EQ(leaves.size(), 1U);
  EXPECT_EQ(leaves[0].frame.origin, Vec3(0, 2, 0));
  EXPECT_EQ(leaves[0].frame.heading(), Vec3(0, 1, 0));
  EXPECT_EQ(leaves[0].birth, 20);
}

const Value::Object kRandomLeaf{{"length", "1 + rand()"}, {"width", "rand()"}};

// Two stars of random sticks with random leaves.
GraphBuilder random_plant() {
  auto builder =
      with_camera().component("a", "star", {{"number", 4}}).component("b", "star", {{"number", "3 + rand(0, 9)"}});
  builder.component("stick", "stick", kRandomLeaf).component("twig", "stick", kRandomLeaf);
  builder.component("leaf", "stick", kRandomLeaf);
  return builder.link("view", "a").link("view", "b").link("a", "stick").link("b", "twig").link("twig", "leaf");
}

TEST(Expand, EditingAComponentLeavesTheOthersBytesAlone) {
  auto builder = random_plant();
  const Plant before = builder.grow();
  builder.component("stick", "stick", {{"length", "3 * rand() + rand()"}, {"width", Value::List{0, 1}}});
  const Plant after = builder.grow();
  EXPECT_NE(hash_of(before, "stick"), hash_of(after, "stick"));
  EXPECT_EQ(hash_of(before, "twig"), hash_of(after, "twig"));
  EXPECT_EQ(hash_of(before, "leaf"), hash_of(after, "leaf"));
}

TEST(Expand, ANewLinkLeavesTheOthersBytesAlone) {
  auto builder = random_plant();
  const Plant before = builder.grow();
  builder.component("new", "stick", kRandomLeaf).link("a", "new").link("stick", "leaf");
  const Plant after = builder.grow();
  EXPECT_EQ(hash_of(before, "stick"), hash_of(after, "stick"));
  EXPECT_EQ(hash_of(before, "twig"), hash_of(after, "twig"));
  EXPECT_GT(organs_of(after, "leaf").size(), organs_of(before, "leaf").size());
}

TEST(Expand, TwoLinksToOneChildDrawDifferentNumbers) {
  auto builder = with_camera().component("stick", "stick", kRandomLeaf).link("view", "stick").link("view", "stick");
  const Plant plant = builder.grow();
  ASSERT_EQ(plant.prototypes.size(), 2U);
  EXPECT_NE(plant.prototypes[0].mesh->positions, plant.prototypes[1].mesh->positions);
}

TEST(Expand, TheSameBytesOnAnyNumberOfThreads) {
  auto builder = random_plant();
  builder.component("a", "star", {{"number", 3000}}).component("pole", "pole").link("stick", "pole");
  builder.component("side", "stick", kRandomLeaf).link("pole", "side", LinkKind::branch, {{"density", 5}});
  std::vector<std::string> hashes;
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    hashes.push_back(hash_of(builder.grow()));
  }
  EXPECT_GT(organs_of(builder.grow(), "side").size(), 3000U);
  for (const std::string& hash : hashes) EXPECT_EQ(hash, hashes[0]);
}

// The only fault of growing with at most `limit` instances.
Diagnostic limit_error(GraphBuilder builder, std::uint64_t limit) {
  const auto errors = errors_of([&] { builder.instance_limit(limit).grow(); });
  EXPECT_EQ(errors.size(), 1U);
  return errors.empty() ? Diagnostic{} : errors[0];
}

TEST(Expand, AnExplodingRecursionIsStoppedAndNamed) {
  auto builder = with_camera().component("tree", "star", {{"number", 10}, {"recursion", 1000}});
  builder.link("view", "tree").link("tree", "tree");
  const Diagnostic error = limit_error(builder, 100'000);
  EXPECT_EQ(error.path, "components.tree.recursion");
  EXPECT_NE(error.expected.find("at most 100000 (limits.instances)"), std::string::npos) << error.text();
}

TEST(Expand, AThousandMillionChildrenAreStoppedBeforeMemoryIsSpent) {
  for (const int threads : {1, 8}) {
    const ThreadLimit limit(threads);
    const Diagnostic error = limit_error(star_of(1'000'000'000), 100'000);
    EXPECT_EQ(error.text(),
              "components.star: 'star' offers sites to more than 100000 instances; "
              "expected at most 100000 (limits.instances)");
  }
}

TEST(Expand, AThousandMillionPlacesAreStoppedAtTheirLink) {
  for (const char* key : {"density", "count"}) {
    auto builder = with_camera().component("pole", "pole").component("leaf", "stick").link("view", "pole");
    builder.link("pole", "leaf", LinkKind::branch, {{key, 1e9}, {"where", "1"}});
    EXPECT_EQ(limit_error(builder, 100'000).path, std::string("links[1].") + key);
  }
}

TEST(Expand, TheLimitItselfIsAllowed) {
  // The camera, the star and its children.
  EXPECT_EQ(count_of(star_of(1000).instance_limit(1002), "stick"), 1000U);
  EXPECT_EQ(limit_error(star_of(1000), 1001).path, "components.star");
}

TEST(Expand, TooManyDifferentShapesAreStoppedAndNamed) {
  // A stick takes 48 bytes, and there are 1000 lengths.
  const auto builder = star_of(1000, {{"length", "0.01*(1 + i)"}});
  EXPECT_EQ(GraphBuilder(builder).mesh_limit(48'000).grow().prototypes.size(), 1000U);
  for (const int threads : {1, 8}) {
    const ThreadLimit limit(threads);
    const auto errors = errors_of([&] { GraphBuilder(builder).mesh_limit(47'999).grow(); });
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].text(),
              "components.stick: the shapes of 'stick' take more than 47999 bytes; "
              "expected at most 47999 (limits.mesh_bytes)");
  }
}

TEST(Expand, FramesThatGrowBeyondAllBoundsAreInputErrors) {
  auto builder = with_camera().component(
      "a", "stick", {{"recursion", 101}, {"frame", Value::Object{{"scale", Value::List{1e4, 1e4, 1e4}}}}});
  const auto errors = errors_of([&] { builder.link("view", "a").link("a", "a").grow(); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "components.a");
  EXPECT_NE(errors[0].message.find("is not finite"), std::string::npos);
}

TEST(Expand, WhatHasShrunkToNothingEnds) {
  auto builder = with_camera().component(
      "a", "stick", {{"recursion", 1000}, {"frame", Value::Object{{"scale", Value::List{0.5, 0.5, 0.5}}}}});
  const Plant plant = builder.link("view", "a").link("a", "a").grow();
  EXPECT_GT(plant.organs.size(), 30U);
  EXPECT_LT(plant.organs.size(), 100U);
  for (const Organ& organ : plant.organs) EXPECT_GT(organ.frame.heading().y, 0);
}

TEST(Expand, AHundredThousandInstancesAreExpandedOnceEachAndShareGeometry) {
  static std::atomic<std::uint64_t> expanded, made;
  expanded = made = 0;
  struct Counted : ComponentBase {};
  std::vector<ComponentType> types(test_components().types().begin(), test_components().types().end());
  types.push_back(define_component<Counted>({
      .traits = {.name = "counted", .doc = "Counts."},
      .parameters = Table<Counted>("a counted", "Counts."),
      .expand =
          [](const Counted&, const Site& site, OrganSink& organs) {
            ++expanded;
            organs.add(Frame{}, site.i % 5, [] {
              ++made;
              return Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {}, {{0, 1, 2}}};
            });
          },
  }));
  const Registry registry(std::move(types));
  GraphBuilder builder(registry);
  builder.component("view", "camera").component("star", "star", {{"number", 100'000}}).component("c", "counted");
  const ThreadLimit one(1);  // several may make the same mesh at the same time
  const Plant plant = builder.link("view", "star").link("star", "c").grow();
  EXPECT_EQ(expanded, 100'000U);
  EXPECT_EQ(plant.organs.size(), 100'000U);
  EXPECT_EQ(plant.prototypes.size(), 5U);
  EXPECT_EQ(made, 5U);
}

TEST(Expand, StopsWhenCancelled) {
  const Graph graph = star_of(1000).sound_graph();
  Progress progress;
  progress.cancel();
  EXPECT_THROW(expand(graph, Scene{}, 0, progress), Cancelled);
}

TEST(Expand, MaterialsTakeTheComponentsNameAndColour) {
  const Plant plant = star_of(2, {{"colour", "#ff0000"}, {"roughness", 0.25}}).grow();
  ASSERT_EQ(plant.materials.size(), 1U);
  EXPECT_EQ(plant.materials[0].name, "stick");
  EXPECT_EQ(plant.materials[0].colour, Vec3(1, 0, 0));
  EXPECT_EQ(plant.materials[0].roughness, 0.25F);
}

TEST(Expand, SlicesOfBatchesGiveThePlantThatWholeBatchesGive) {
  // With a cache, batches expand whole. Without a cache, large batches expand in slices.
  auto builder = with_camera()
                     .component("field", "star", {{"number", 20}, {"step", 9}})
                     .component("bush", "star", {{"number", 60}, {"step", 3}})
                     .component("twig", "stick", {{"length", "0.5 + rand()"}, {"recursion", 3}})
                     .component("pole", "pole", {{"height", 2}, {"nodes", 3}})
                     .component("leaf", "stick", {{"width", "rand(0.1, 0.2)"}});
  builder.link("view", "field").link("field", "bush").link("bush", "twig").link("twig", "twig");
  builder.link("twig", "leaf").link("bush", "pole").link("pole", "leaf", LinkKind::branch, {{"count", 7}});
  const Plant sliced = builder.grow();
  EXPECT_EQ(organs_of(sliced, "twig").size(), 3 * 1200U);
  EXPECT_EQ(organs_of(sliced, "leaf").size(), (3 + 7) * 1200U);
  Cache cache;
  EXPECT_EQ(hash_of(sliced), hash_of(builder.grow(0, {}, &cache)));
}

TEST(Expand, RecordsTheGrowthThatTheViewRequests) {
  auto builder = with_camera().component("star", "star", {{"number", 3}}).component("sprout", "sprout");
  const Graph graph = builder.link("view", "star").link("star", "sprout").sound_graph();
  const auto grow = [&](const GrowthView& view, GrowthTraces& traces) {
    Progress progress;
    return expand(graph, Scene(), 0, progress, ExpandOptions{.view = view, .traces = &traces});
  };
  GrowthTraces nothing;
  const Plant whole = grow({}, nothing);
  EXPECT_FALSE(nothing.has_growths());
  GrowthView view;
  view.step = 1;
  view.request = TraceRequest::all();
  GrowthTraces traces;
  const Plant half = grow(view, traces);
  ASSERT_EQ(traces.growths.size(), 3U);
  for (std::uint32_t k = 0; k < 3; ++k) {
    EXPECT_EQ(traces.growths[k].component, "sprout");
    EXPECT_EQ(traces.growths[k].instance, k);
    EXPECT_EQ(traces.growths[k].trace->place.origin.x, static_cast<float>(k));
  }
  EXPECT_EQ(traces.steps, (std::vector<ComponentSteps>{{"sprout", 2}}));
  EXPECT_EQ(traces.shown_step(), 1);
  EXPECT_EQ(traces.recorded, TraceRequest::all());
  ASSERT_EQ(half.stems.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_FLOAT_EQ(whole.stems[k].skeleton.position[1].y, 1.0F / 3);
    EXPECT_FLOAT_EQ(half.stems[k].skeleton.position[1].y, 0.5F / 3);
  }
}

}  // namespace meristem::expand_test
