// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/organize.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/components/organize_in_a_test.h"
#include "meristem/components/parts/organize_table.h"
#include "meristem/graph/batch.h"
#include "tests/support/check_skeleton.h"

namespace meristem::organize_test {

TEST(OrganizeComponent, InAFrameHalfAsLargeItIsHalfAsLarge) {
  for (const char* const model : {"shadow", "markers"}) {
    Value::Object light{{"model", model}};
    if (light[0].second == Value("markers")) {
      light.emplace_back("room", Value::Object{{"box", Value::List{Value::List{-0.3, 0, -0.3}, Value::List{1, 2, 1}}}});
    }
    const Value::Object whole{{"iterations", 8}, {"light", light}};
    Value::Object half = whole;
    half.emplace_back("frame", Value::Object{{"scale", Value::List{0.5, 0.5, 0.5}}});
    const Skeleton large = skeleton_of(whole), small = skeleton_of(half);
    ASSERT_EQ(small.parent, large.parent) << model;
    for (NodeIndex node = 0; node < large.node_count(); ++node) {
      ASSERT_LT(glm::distance(small.position[node], 0.5F * large.position[node]), 1e-5F) << model;
      ASSERT_FLOAT_EQ(small.radius[node], 0.5F * large.radius[node]);
    }
  }
}

TEST(OrganizeComponent, ItsLeavesAreAsLargeAsItsFrame) {
  const Value::Object half{{"iterations", 4}, {"frame", Value::Object{{"scale", Value::List{0.5, 0.5, 0.5}}}}};
  for (const Organ& leaf : organs_of(leafy(half).grow(), "leaf")) {
    EXPECT_NEAR(glm::length(leaf.frame.heading()), 0.5, 1e-5);
  }
}

TEST(OrganizeComponent, DefaultsGrowATree) {
  const Plant plant = tree({}).grow();
  ASSERT_EQ(plant.stems.size(), 1U);
  const Skeleton& skeleton = plant.stems[0].skeleton;
  EXPECT_TRUE(check_skeleton(skeleton));
  EXPECT_GT(skeleton.node_count(), 1000U);
  EXPECT_LT(skeleton.node_count(), 10'000U);
  EXPECT_GT(bounds(skeleton).high.y, 2);
  EXPECT_EQ(plant.stems[0].parts[0].component, "tree");
  EXPECT_EQ(warnings({}), "");
  for (const char* column :
       {"metamer", "light", "resource", "lateral_resource", "terminal_bud", "lateral_bud", "bud_angle", "shed"}) {
    EXPECT_EQ(skeleton.extra.count(column), 1U) << column;
  }
}

TEST(OrganizeComponent, ParametersReachTheGrowth) {
  const Skeleton small = skeleton_of({{"iterations", 8}, {"length", 0.2}, {"tip_radius", 0.003}});
  EXPECT_EQ(std::ranges::max(small.birth), 8);
  EXPECT_FLOAT_EQ(std::ranges::min(small.radius), 0.003F);
  EXPECT_NEAR(glm::distance(small.position[1], small.position[0]), 0.2, 1e-6);
}

TEST(OrganizeComponent, EachOfItsParametersChangesHowItGrows) {
  const auto grown = [](Value::Object parameters) {
    parameters.emplace_back("iterations", 14);
    return hash_of(tree(parameters).grow());
  };
  const std::string plain = grown({});
  const auto object = [](const char* key, Value value) { return Value::Object{{key, std::move(value)}}; };
  for (const Value::Object& change : std::vector<Value::Object>{
           {{"longest_shoot", 1}},
           {{"stretch", true}},
           {{"terminal_threshold", 1.2}},
           {{"lateral_threshold", 1.2}},
           {{"phyllotaxis", "alternate"}},
           {{"phyllotaxis", "decussate"}},
           {{"branching_angle", 40}},
           {{"divergence", 120}},
           {{"jitter", 1}},
           {{"resource", object("alpha", 2.2)}},
           {{"resource", object("alpha0", 1)}},
           {{"resource", object("lambda", 0.55)}},
           {{"resource", object("lambda_curve",
                                object("curve", Value::List{Value(Value::List{0, 1}), Value(Value::List{1, 0.9})}))}},
           {{"resource", Value::Object{{"model", "priority"}, {"until", 6}}}},
           {{"light", object("full", 1.1)}},
           {{"light", object("a", 0.1)}},
           {{"light", object("b", 1.5)}},
           {{"light", object("depth", 5)}},
           {{"light", object("reach", 1)}},
           {{"light", object("voxel", 0.2)}},
           {{"direction", object("persistence", 1)}},
           {{"direction", object("light", 0.2)}},
           {{"direction", object("up", 0.2)}},
           {{"stem", object("persistence", 3)}},
           {{"shedding", object("below", 0.3)}},
           {{"sag", object("stiffness", 5)}},
       }) {
    EXPECT_NE(grown(change), plain) << change[0].first;
  }
  EXPECT_EQ(grown({{"every", 4}}), plain);  // a single tree
}

TEST(OrganizeComponent, GrowsFromItsSiteTheWayThatItHeads) {
  const Value frame = Value::Object{{"translate", Value::List{8, 1, 0}}, {"rotate", Value::List{0, 0, -45}}};
  const Skeleton there = skeleton_of({{"iterations", 6}, {"jitter", 0}, {"frame", frame}});
  EXPECT_EQ(there.position[0], Vec3(8, 1, 0));
  EXPECT_GT(there.position[1].x, 8.05F);
}

TEST(OrganizeComponent, RootsMakeAGroveThatCompetes) {
  const auto grove = [](double apart) {
    const Value::List roots{Value(Value::List{0, 0, 0}), Value(Value::List{apart, 0, 0})};
    return skeleton_of({{"iterations", 16}, {"roots", roots}});
  };
  const Skeleton far = grove(50);
  EXPECT_TRUE(check_skeleton(far));
  EXPECT_EQ(std::ranges::count(far.parent, kNoNode), 2);
  EXPECT_LT(static_cast<double>(grove(0.3).node_count()), 0.9 * static_cast<double>(far.node_count()));
}

TEST(OrganizeComponent, LeavesStandAtTheLateralBudsOfYoungMetamers) {
  for (const int age : {1, 3}) {
    const Value::Object parameters{{"iterations", 10}, {"leaf_age", age}, {"leaf_angle", 60}, {"tip_radius", 0.01}};
    const Plant plant = leafy(parameters).grow();
    const Skeleton& stem = plant.stems.at(0).skeleton;
    const std::vector<Organ> leaves = organs_of(plant, "leaf");
    std::size_t k = 0;
    for (NodeIndex node = 1; node < stem.node_count(); ++node) {
      if (stem.birth[node] <= static_cast<float>(10 - age)) continue;
      ASSERT_LT(k, leaves.size());
      const Frame& leaf = leaves[k++].frame;
      const Vec3 axis = glm::normalize(stem.position[node] - stem.position[stem.parent[node]]);
      const Vec3 side = bud_side(axis, stem.extra.find("bud_angle")->second[node]);
      // The leaf is on the bark at the bud, at the leaf angle to the shoot, with its upper face toward the shoot.
      EXPECT_LT(glm::distance(leaf.origin, stem.position[node] + stem.radius[node] * side), 1e-5F);
      EXPECT_NEAR(glm::dot(leaf.heading(), axis), 0.5, 1e-4);
      EXPECT_NEAR(glm::dot(leaf.heading(), side), std::sqrt(0.75), 1e-4);
      EXPECT_GT(glm::dot(leaf.upper(), axis), 0.5F);
    }
    EXPECT_EQ(k, leaves.size());
    EXPECT_GT(k, 20U);
  }
}

TEST(OrganizeComponent, ATreeThatWasCutBackHasNoLeavesOnOldWood) {
  Value::Object parameters = operation({{"at", 10}, {"above", 1}});
  parameters.emplace_back("iterations", 10);
  const Plant plant = leafy(parameters).grow();
  EXPECT_EQ(plant.stems.at(0).skeleton.node_count(), 2U);
  EXPECT_TRUE(organs_of(plant, "leaf").empty());
}

TEST(OrganizeComponent, LeavesGoTheWayThatTheirBudsGrow) {
  // A lateral shoot grows from its metamer on the side where its leaf was.
  const Value::Object parameters{{"iterations", 8},
                                 {"leaf_age", 100},
                                 {"leaf_angle", 90},
                                 {"direction", Value::Object{{"persistence", 1}, {"light", 0}}}};
  const Plant plant = leafy(parameters).grow();
  const Skeleton& stem = plant.stems.at(0).skeleton;
  const std::vector<Organ> leaves = organs_of(plant, "leaf");
  ASSERT_EQ(leaves.size(), stem.node_count() - 1);
  int laterals = 0;
  for (NodeIndex node = 1; node < stem.node_count(); ++node) {
    const NodeIndex parent = stem.parent[node];
    if (stem.axis[node] == stem.axis[parent]) continue;
    const Vec3 way = glm::normalize(stem.position[node] - stem.position[parent]);
    EXPECT_GT(glm::dot(way, leaves[parent - 1].frame.heading()), 0.6F);
    ++laterals;
  }
  EXPECT_GT(laterals, 5);
}

TEST(OrganizeComponent, WithoutAnAgeThereAreNoLeaves) {
  EXPECT_TRUE(organs_of(leafy({{"iterations", 6}, {"leaf_age", 0}}).grow(), "leaf").empty());
}

TEST(OrganizeComponent, PlacementKeysPutLeavesAlongTheStems) {
  EXPECT_EQ(organs_of(leafy({{"iterations", 8}}, {{"count", 77}}).grow(), "leaf").size(), 77U);
}

TEST(OrganizeComponent, LeafLinksStandAtTheTips) {
  auto builder = tree({{"iterations", 8}}).component("bud", "simple").link("tree", "bud", LinkKind::leaf);
  const Plant plant = builder.grow();
  EXPECT_EQ(organs_of(plant, "bud").size(), SkeletonAxes(plant.stems.at(0).skeleton).count());
}

TEST(OrganizeComponent, WhatOnlyDressesItDoesNotGrowItAnew) {
  Scene scene;
  scene.fingerprint = 1;
  const Value::Object parameters{{"iterations", 10}};
  for (const auto& [change, made] : std::vector<std::pair<Value::Object, std::uint64_t>>{
           {{{"leaf_age", 4}}, 0},
           {{{"leaf_angle", 20}}, 0},
           {{{"surface", Value::Object{{"sides", 5}}}}, 0},
           {{{"jitter", 2}}, 1},
           {{{"resource", Value::Object{{"alpha", 2.3}}}}, 1},
           {operation({{"above", 4}}), 1},
       }) {
    Cache cache;
    leafy(parameters).grow(0, scene, &cache);
    EXPECT_EQ(cache.reuse<GrownBatch>().made, 1U);
    Value::Object changed = parameters;
    changed.insert(changed.end(), change.begin(), change.end());
    const Plant again = leafy(changed).grow(0, scene, &cache);
    EXPECT_EQ(cache.reuse<GrownBatch>().made, made) << change[0].first;
    EXPECT_EQ(hash_of(again), hash_of(leafy(changed).grow(0, scene))) << change[0].first;
  }
}

TEST(OrganizeComponent, TheSameBytesOnAnyNumberOfThreads) {
  std::vector<std::string> hashes;
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    hashes.push_back(hash_of(leafy({{"iterations", 22}, {"leaf_age", 3}}).grow()));
  }
  for (const std::string& hash : hashes) EXPECT_EQ(hash, hashes[0]);
}

TEST(OrganizeComponent, WarnsOfTheKnifeEdge) {
  const auto at = [](double alpha) { return warnings({{"resource", Value::Object{{"alpha", alpha}}}}); };
  EXPECT_NE(at(1.8).find("tree.resource.alpha: growth is unstable here"), std::string::npos) << at(1.8);
  EXPECT_NE(at(1.85), "");
  EXPECT_NE(at(1.75), "");
  EXPECT_EQ(at(1.95), "");
  EXPECT_EQ(at(1.6), "");
  // The critical value is where a bud's light makes exactly the resource that a lateral bud needs.
  EXPECT_NE(warnings({{"resource", Value::Object{{"alpha", 3.6}}}, {"light", Value::Object{{"full", 0.5}}}}), "");
  EXPECT_NE(warnings({{"lateral_threshold", 2}}), "");
  // The priority model has no critical value.
  EXPECT_EQ(warnings({{"resource", Value::Object{{"alpha", 1.8}, {"model", "priority"}}}}), "");
}

TEST(OrganizeComponent, WarnsWhereNothingCanGrow) {
  const std::string found = warnings({{"resource", Value::Object{{"alpha", 0.9}}}});
  EXPECT_NE(found.find("nothing will grow"), std::string::npos) << found;
  EXPECT_EQ(error({{"resource", Value::Object{{"alpha", 0.9}}}}).path, "components.tree.resource.alpha");
  EXPECT_EQ(warnings({{"resource", Value::Object{{"alpha", 0.9}, {"alpha0", 0.5}}}}), "");
}

TEST(OrganizeComponent, ParametersAreCheckedInTheirRanges) {
  const auto path_of = [](const char* key, Value value) { return error({{key, std::move(value)}}).path; };
  const auto path_in = [](const char* object, const char* key, Value value) {
    return error({{object, Value::Object{{key, std::move(value)}}}}).path;
  };
  EXPECT_EQ(path_of("iterations", -1), "components.tree.iterations");
  EXPECT_EQ(path_of("iterations", 65536), "components.tree.iterations");
  EXPECT_EQ(path_of("every", 0), "components.tree.every");
  EXPECT_EQ(path_of("length", 0), "components.tree.length");
  EXPECT_EQ(path_of("longest_shoot", 0), "components.tree.longest_shoot");
  EXPECT_EQ(path_of("maturity", 0), "components.tree.maturity");
  EXPECT_EQ(path_of("terminal_threshold", -1), "components.tree.terminal_threshold");
  EXPECT_EQ(path_of("takeover", -1), "components.tree.takeover");
  EXPECT_EQ(path_of("branching_angle", 181), "components.tree.branching_angle");
  EXPECT_EQ(path_of("phyllotaxis", "oposite"), "components.tree.phyllotaxis");
  EXPECT_EQ(path_of("leaf_age", -1), "components.tree.leaf_age");
  EXPECT_EQ(path_of("tip_radius", 0), "components.tree.tip_radius");
  EXPECT_EQ(path_of("roots", Value::List{}), "components.tree.roots");
  EXPECT_EQ(path_in("light", "depth", 65), "components.tree.light.depth");
  EXPECT_EQ(path_in("light", "b", 0.9), "components.tree.light.b");
  EXPECT_EQ(path_in("light", "reach", 5), "components.tree.light.reach");
  EXPECT_EQ(path_in("light", "model", "shade"), "components.tree.light.model");
  EXPECT_EQ(path_in("resource", "lambda", 1.1), "components.tree.resource.lambda");
  EXPECT_EQ(path_in("resource", "pass_back", -0.1), "components.tree.resource.pass_back");
  EXPECT_EQ(path_in("resource", "alpha", -1), "components.tree.resource.alpha");
  EXPECT_EQ(path_in("direction", "up_fade", 2), "components.tree.direction.up_fade");
  EXPECT_EQ(path_in("shedding", "below", -1), "components.tree.shedding.below");
  EXPECT_EQ(path_in("sag", "stiffness", 0), "components.tree.sag.stiffness");
}

TEST(OrganizeComponent, ShootsOfTheShadowModelStayInTheirRoom) {
  const Value room = Value::Object{{"box", Value::List{Value::List{-0.6, -1, -0.6}, Value::List{0.6, 1.5, 0.6}}}};
  const Value::Object free{{"iterations", 14}};
  Value::Object bounded = free;
  bounded.emplace_back("light", Value::Object{{"room", room}});
  EXPECT_GT(bounds(skeleton_of(free)).high.y, 1.6F);
  const Box found = bounds(skeleton_of(bounded));
  EXPECT_LE(found.high.y, 1.52F);  // includes the thickness of its twigs
  EXPECT_GT(found.high.y, 1.3F);
  EXPECT_LE(std::max(found.high.x, found.high.z), 0.62F);
}

TEST(OrganizeComponent, GrowthThatExplodesStopsAtTheLimit) {
  const auto errors = errors_of([] { tree({{"resource", Value::Object{{"alpha", 900}}}}).node_limit(20'000).grow(); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "components.tree.resource.alpha");
}

}  // namespace meristem::organize_test
