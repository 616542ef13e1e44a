// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/organize.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/components/parts/organize_table.h"
#include "meristem/components/registry.h"
#include "meristem/graph/batch.h"
#include "tests/support/build_graph.h"
#include "tests/support/check_skeleton.h"
#include "tests/support/temporary_folder.h"

namespace meristem::organize_test {

GraphBuilder tree(const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  return builder.component("view", "camera").component("tree", "organize", parameters).link("view", "tree");
}

/// The tree with boxes instead of leaves.
GraphBuilder leafy(const Value::Object& parameters, const Value::Object& placement = {}) {
  return tree(parameters)
      .component("leaf", "simple", {{"size", Value::List{1, 1, 1}}})
      .link("tree", "leaf", LinkKind::branch, placement);
}

Skeleton skeleton_of(const Value::Object& parameters) { return tree(parameters).grow().stems.at(0).skeleton; }

/// Returns the only error of reading and growing.
Diagnostic fault(const Value::Object& parameters) {
  const auto faults = faults_of([&] { tree(parameters).grow(); });
  EXPECT_EQ(faults.size(), 1U);
  return faults.empty() ? Diagnostic{} : faults[0];
}

/// Returns the warnings of reading, one per line.
std::string warnings(const Value::Object& parameters) {
  const ComponentType type = organize_component();
  const auto read = type.make_parameters();
  ParameterReader reader({}, Limits());
  const DocumentPath top;
  reader.read_varying(type.parameters, read.get(), parameters, DocumentPath(top, "tree"));
  EXPECT_EQ(reader.fault_count(), 0U);
  std::string texts;
  for (const Diagnostic& found : reader.diagnostics()) texts += found.text() + "\n";
  return texts;
}

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

Value::Object operation(Value::Object more) {
  Value::Object whole{{"at", 5}, {"do", "cut"}, {"shoots", "main"}};
  for (auto& [key, value] : more) {
    std::erase_if(whole, [&name = key](const auto& member) { return member.first == name; });
    whole.emplace_back(key, value);
  }
  return {{"operations", Value::List{Value(std::move(whole))}}};
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
  EXPECT_EQ(organs_of(plant, "bud").size(), Axes(plant.stems.at(0).skeleton).count());
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
  EXPECT_EQ(fault({{"resource", Value::Object{{"alpha", 0.9}}}}).path, "components.tree.resource.alpha");
  EXPECT_EQ(warnings({{"resource", Value::Object{{"alpha", 0.9}, {"alpha0", 0.5}}}}), "");
}

TEST(OrganizeComponent, KnowsShootsNamesByTheirForm) {
  for (const char* name : {"main", "main.4", "main.4.12", "main.123456789"}) EXPECT_TRUE(is_shoot_name(name)) << name;
  for (const char* name : {"", "mai", "mains", "main.", "main.4.", "main..4", "main.x", "main.-4", "main. 4", "Main",
                           "leader", "main.1234567890"}) {
    EXPECT_FALSE(is_shoot_name(name)) << name;
  }
}

TEST(OrganizeComponent, CutsAShoot) {
  Value::Object cut = operation({{"above", 4}});
  cut.emplace_back("iterations", 6);
  EXPECT_LT(skeleton_of(cut).node_count(), skeleton_of({{"iterations", 6}}).node_count());
}

TEST(OrganizeComponent, OperationsAreChecked) {
  EXPECT_EQ(fault(operation({{"shoots", "mian"}, {"above", 2}})).path, "components.tree.operations[0].shoots");
  EXPECT_EQ(fault(operation({{"shoots", "mian"}, {"above", 2}})).nearest, "main");
  EXPECT_EQ(fault(operation({{"shoots", "leder"}, {"above", 2}})).nearest, "leader");
  EXPECT_EQ(fault(operation({{"shoots", "main.4.x"}, {"above", 2}})).path, "components.tree.operations[0].shoots");
  EXPECT_EQ(fault(operation({{"above", 0}})).path, "components.tree.operations[0].above");
  EXPECT_EQ(fault(operation({{"at", 0}, {"above", 4}})).path, "components.tree.operations[0].at");
  EXPECT_EQ(fault(operation({{"do", "prune"}, {"above", 4}})).path, "components.tree.operations[0].do");
  const Value::Object bare{{"at", 5}, {"shoots", "main"}, {"above", 3}};
  EXPECT_NE(fault({{"operations", Value::List{Value(bare)}}}).message.find("'do'"), std::string::npos);
}

TEST(OrganizeComponent, WarnsOfOperationsThatNeverAct) {
  const auto late = [](Value iterations, int at) {
    const Value::Object cut{{"do", "cut"}, {"at", at}, {"shoots", "main"}, {"above", 3}};
    return warnings({{"operations", Value::List{Value(cut)}}, {"iterations", std::move(iterations)}});
  };
  EXPECT_NE(late(8, 9).find("tree.operations[0].at: the operation never acts"), std::string::npos) << late(8, 9);
  EXPECT_EQ(late(9, 9), "");
  EXPECT_NE(warnings(operation({{"at", 21}, {"above", 3}})), "") << "after the default";
  // The age may follow the time.
  EXPECT_EQ(late("4 + 4", 9), "");
  EXPECT_EQ(late(Value::Object{{"range", Value::List{8, 12}}}, 11), "");
}

TEST(OrganizeComponent, AShootThatHasNotGrownIsNamedWithTheNearest) {
  const Diagnostic found = fault(operation({{"at", 3}, {"shoots", "main.3000"}, {"above", 1}}));
  EXPECT_EQ(found.path, "components.tree.operations[0].shoots");
  EXPECT_NE(found.message.find("'main.3000'"), std::string::npos) << found.message;
  EXPECT_NE(found.expected.find("main"), std::string::npos);
}

TEST(OrganizeComponent, ParametersAreCheckedInTheirRanges) {
  const auto path_of = [](const char* key, Value value) { return fault({{key, std::move(value)}}).path; };
  const auto path_in = [](const char* object, const char* key, Value value) {
    return fault({{object, Value::Object{{key, std::move(value)}}}}).path;
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

TEST(OrganizeComponent, TrainedRowsHaveTheSameBytesOnAnyNumberOfThreads) {
  std::vector<std::string> hashes;
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    const Value::List roots{Value::List{0, 0, 0}, Value::List{2, 0, 0}, Value::List{4, 0, 0}};
    hashes.push_back(hash_of(tree({{"iterations", 12}, {"roots", roots}, {"training", "espalier"}}).grow()));
  }
  for (const std::string& hash : hashes) EXPECT_EQ(hash, hashes[0]);
}

TEST(OrganizeComponent, GrowthOfATrainedTreeIsTheBeginningOfLongerGrowth) {
  // Everything that was not cut later keeps its position.
  const Value::Object cut{{"do", "cut"}, {"at", 14}, {"shoots", "rank == 1"}, {"above", 4}};
  const auto grown = [&](int iterations) {
    return skeleton_of({{"iterations", iterations}, {"operations", Value::List{Value(cut)}}});
  };
  const Skeleton young = grown(13);
  EXPECT_EQ(young.position, skeleton_of({{"iterations", 13}}).position);
  EXPECT_LT(grown(14).node_count(), skeleton_of({{"iterations", 14}}).node_count());
}

/// Returns the stems of a tree with this training.
Skeleton trained(const Value& training, int iterations = 15) {
  return skeleton_of({{"training", training},
                      {"iterations", iterations},
                      {"resource", Value::Object{{"alpha", 2.3}}},
                      {"length", 0.1}});
}

/// A shoot of rank 1, without its branches.
struct Arm {
  Vec3 begin{}, tip{};
  float off = 0;  // metres; largest distance from the xy plane
  int metamers = 0;
};

/// Returns the arms in the order in which they began.
std::vector<Arm> arms_of(const Skeleton& tree) {
  const std::vector<float>& rank = tree.extra.find("rank")->second;
  std::vector<Arm> arms;
  std::vector<std::size_t> arm_of(tree.node_count());
  for (NodeIndex node = 1; node < tree.node_count(); ++node) {
    if (rank[node] != 1) continue;
    const NodeIndex parent = tree.parent[node];
    if (rank[parent] == 1) {
      arm_of[node] = arm_of[parent];
    } else {
      arm_of[node] = arms.size();
      arms.push_back({.begin = tree.position[parent]});
    }
    Arm& arm = arms[arm_of[node]];
    arm.tip = tree.position[node];
    arm.off = std::max(arm.off, std::abs(arm.tip.z));
    ++arm.metamers;
  }
  return arms;
}

TEST(OrganizeComponent, AnEspalierHasTwoLevelArmsALayer) {
  GraphBuilder espalier = tree(
      {{"training", "espalier"}, {"iterations", 15}, {"resource", Value::Object{{"alpha", 2.3}}}, {"length", 0.1}});
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Skeleton grown = espalier.seed(seed).grow().stems.at(0).skeleton;
    ASSERT_TRUE(check_skeleton(grown));
    const std::vector<Arm> arms = arms_of(grown);
    ASSERT_EQ(arms.size(), 6U) << seed;
    for (const Arm& arm : arms) {
      const Vec3 way = glm::normalize(arm.tip - arm.begin);
      EXPECT_LT(degrees(std::asin(std::abs(way.y))), 7) << seed;
      EXPECT_LT(degrees(std::asin(std::abs(way.z))), 3) << seed;
      EXPECT_LT(arm.off, 0.25F) << seed;
      EXPECT_GE(arm.metamers, 6) << seed;
    }
    EXPECT_EQ(std::ranges::count_if(arms, [](const Arm& arm) { return arm.tip.x > arm.begin.x; }), 3) << seed;
  }
}

TEST(OrganizeComponent, AFanAtAWallHasTwoWholeArmsALayer) {
  Scene scene;
  scene.light = {.sun = {}, .sky = even_sky(1), .lamps = {}};
  Obstacle wall;
  wall.mesh = box_mesh({-3.2, 0, -0.55}, {3.2, 2.7, -0.3});
  scene.obstacles = Obstacles({wall});
  const Value::Object form{{"form", "fan"}, {"layers", 5}, {"spacing", 3}, {"reach", 12}, {"spurs", 3}};
  const auto whole = [&](double a, std::uint64_t seed) {
    const Plant plant = tree({{"training", form},
                              {"iterations", 13},
                              {"resource", Value::Object{{"alpha", 9}}},
                              {"light", Value::Object{{"a", a}}},
                              {"length", 0.08}})
                            .seed(seed)
                            .grow(0, scene);
    const std::vector<Arm> arms = arms_of(plant.stems.at(0).skeleton);
    return std::ranges::count_if(arms, [](const Arm& arm) { return arm.metamers == 12; });
  };
  for (std::uint64_t seed = 1; seed <= 10; ++seed) EXPECT_EQ(whole(0.1, seed), 10) << seed;
  // With the default shade, some trees lose an arm, as this one does.
  EXPECT_EQ(whole(0.2, 3), 9);
}

TEST(OrganizeComponent, SpursAndLimitsHoldAnEspalierAsItIs) {
  const auto metamers = [](int iterations) {
    return static_cast<double>(trained("espalier", iterations).node_count());
  };
  EXPECT_NEAR(metamers(25) / metamers(16), 1, 0.1);
}

TEST(OrganizeComponent, EachTrainingGrowsATree) {
  for (const char* form : {"espalier", "cordon", "fan", "spindle", "open_vase", "standard", "half_standard", "hedge"}) {
    const Skeleton tree = trained(form, 12);
    EXPECT_TRUE(check_skeleton(tree)) << form;
    EXPECT_GT(tree.node_count(), 20U) << form;
  }
}

TEST(OrganizeComponent, ItsSupportsAreSeen) {
  const Value::Object support{{"do", "support"},
                              {"line", Value::List{Value::List{0, 0, 0}, Value::List{0, 1, 0}, Value::List{0, 2, 0}}},
                              {"thickness", 0.05}};
  const Plant plant = tree({{"operations", Value::List{Value(support)}},
                            {"iterations", 3},
                            {"roots", Value::List{Value::List{0, 0, 0}, Value::List{2, 0, 0}}}})
                          .grow();
  const std::vector<Organ> rods = organs_of(plant, "tree");
  ASSERT_EQ(rods.size(), 4U);
  EXPECT_NEAR(glm::length(rods[0].frame.heading()), 1, 1e-5);
  EXPECT_NEAR(glm::length(rods[0].frame.right()), 0.025, 1e-5);
  EXPECT_NEAR(rods[2].frame.origin.x, 2, 1e-5);
}

TEST(OrganizeComponent, OperationsSayWhenAndWhere) {
  const auto place = [](Value::Object more) { return fault(operation(std::move(more))).path; };
  EXPECT_EQ(place({{"above", 2}, {"above_lateral", 3}}), "components.tree.operations[0]");
  EXPECT_EQ(place({{"above", 2}, {"every", 2}}), "components.tree.operations[0].every");
  EXPECT_EQ(place({{"above", 2}, {"when", "heigth > 2"}}), "components.tree.operations[0].when");
  EXPECT_EQ(place({{"above", 2}, {"shoots", "rnk >= 2"}}), "components.tree.operations[0].shoots");
  EXPECT_EQ(place({{"above", 2}, {"tree", 1}}), "components.tree.operations[0].tree");
  const auto support = [](Value line) {
    return fault({{"operations", Value::List{Value(Value::Object{{"do", "support"}, {"line", std::move(line)}})}}})
        .path;
  };
  EXPECT_EQ(support(Value::List(1, Value(Value::List{0, 0, 0}))), "components.tree.operations[0].line");
  EXPECT_EQ(support(Value::List{Value::List{0, 0, 0}, Value::List{0, 0, 0}}), "components.tree.operations[0].line[1]");
}

TEST(OrganizeComponent, SupportsTiesAndMarksAreChecked) {
  const auto found = [](Value::Object operation) {
    return fault({{"operations", Value::List{Value(std::move(operation))}}});
  };
  const Value::List line{Value::List{0, 0, 0}, Value::List{0, 1, 0}};
  EXPECT_EQ(found({{"do", "support"}}).path, "components.tree.operations[0]");
  EXPECT_EQ(found({{"do", "support"}, {"line", line}, {"named", "wire"}}).path, "components.tree.operations[0]");
  EXPECT_EQ(found({{"do", "support"}, {"line", line}, {"season", "summer"}}).path,
            "components.tree.operations[0].season");
  EXPECT_EQ(found({{"do", "support"}, {"named", "wire"}}).message, "the scene has no support 'wire'");
  EXPECT_EQ(found({{"do", "tie"}, {"shoots", "leader"}}).path, "components.tree.operations[0].shoots");
  EXPECT_EQ(found({{"do", "tie"}, {"shoots", "rank == 1"}, {"anchor", "mian"}}).path,
            "components.tree.operations[0].anchor");
  EXPECT_EQ(found({{"do", "tie"}, {"shoots", "rank == 1"}, {"below", 0}}).path, "components.tree.operations[0].below");
  for (const char* const word : {"", "two words", "rank", "leader", "sin"}) {
    EXPECT_EQ(found({{"do", "mark"}, {"shoots", "rank == 1"}, {"state", word}}).path,
              "components.tree.operations[0].state")
        << word;
  }
}

TEST(OrganizeComponent, ThereAreAsManyStatesAsAreToldApart) {
  const auto read = [](int states) {
    Value::List operations;
    for (int k = 0; k < states; ++k) {
      operations.push_back(Value::Object{{"do", "mark"}, {"shoots", "rank == 1"}, {"state", "s" + std::to_string(k)}});
    }
    return tree({{"iterations", 4}, {"operations", operations}}).grow();
  };
  const Plant plant = read(31);
  EXPECT_EQ(plant.stems.at(0).skeleton.extra.count("mark_s30"), 1U);
  const auto faults = faults_of([&] { read(32); });
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].path, "components.tree.operations[31].state");
}

TEST(OrganizeComponent, OperationsAndLeavesAskForMarks) {
  const Value::List operations{
      Value::Object{{"do", "mark"}, {"at", 10}, {"shoots", "rank == 1"}, {"chance", 0.5}, {"state", "dead"}},
      Value::Object{{"do", "mark"}, {"at", 10}, {"shoots", "rank == 0"}, {"state", "main_stem"}}};
  const Skeleton marked = skeleton_of({{"iterations", 12}, {"operations", operations}});
  const auto& dead = marked.extra.find("mark_dead")->second;
  const double share = std::count(dead.begin(), dead.end(), 1.0F) / static_cast<double>(dead.size());
  EXPECT_GT(share, 0);
  EXPECT_LT(share, 1);
  // Shoots cut because they were dead are gone.
  Value::List cut = operations;
  cut.push_back(Value::Object{{"do", "cut"}, {"at", 12}, {"shoots", "dead"}, {"above", 0}});
  const Skeleton left = skeleton_of({{"iterations", 12}, {"operations", cut}});
  const auto& still = left.extra.find("mark_dead")->second;
  EXPECT_EQ(std::count(still.begin(), still.end(), 1.0F), 0);
  EXPECT_LT(left.node_count(), marked.node_count());
  // Conditions of links can test whether a shoot has any mark.
  const auto leaves = [&](const char* where) {
    const Value::Object parameters{{"iterations", 12}, {"leaf_age", 12}, {"operations", operations}};
    return organs_of(leafy(parameters, {{"where", where}}).grow(), "leaf").size();
  };
  const std::size_t all = leaves("1"), of_marked = leaves("marked"), of_others = leaves("!marked");
  EXPECT_GT(of_marked, 0U);
  EXPECT_GT(of_others, 0U);
  EXPECT_EQ(of_marked + of_others, all);
}

TEST(OrganizeComponent, ConditionsThatAreNoNumbersFindNothing) {
  for (const char* const shoots : {"sqrt(-1)", "0 / 0", "log(-length)", "1 / 0", "-1 / 0"}) {
    Value::Object cut = operation({{"shoots", shoots}, {"above", 0}});
    cut.emplace_back("iterations", 6);
    EXPECT_EQ(skeleton_of(cut).node_count(), skeleton_of({{"iterations", 6}}).node_count()) << shoots;
  }
  for (const char* const condition : {"0 / 0", "1 / 0", "-1 / 0"}) {
    Value::Object when = operation({{"when", condition}, {"above", 3}});
    when.emplace_back("iterations", 6);
    EXPECT_EQ(skeleton_of(when).node_count(), skeleton_of({{"iterations", 6}}).node_count()) << condition;
    // Conditions of links select no part of a stem either.
    EXPECT_TRUE(organs_of(leafy({{"iterations", 6}}, {{"where", condition}}).grow(), "leaf").empty()) << condition;
  }
}

TEST(OrganizeComponent, LinksAskForRankAgeAndInclination) {
  const Value operations = operation({{"at", 8}, {"above", 8}})[0].second;
  const Value::Object parameters{{"iterations", 14}, {"operations", operations}};
  const Skeleton tree = skeleton_of(parameters);
  const std::vector<float>& rank = tree.extra.at("rank");
  const auto leaves = [&](const char* where) {
    return static_cast<double>(organs_of(leafy(parameters, {{"where", where}}).grow(), "leaf").size());
  };
  const double all = leaves("1");
  // Metamers have equal lengths, so the share of leaves equals the share of metamers for which the condition holds.
  const auto expect = [&](const char* where, auto holds) {
    double count = 0;
    for (NodeIndex node = 1; node < tree.node_count(); ++node) count += holds(node) ? 1 : 0;
    EXPECT_GT(count, 0) << where;
    EXPECT_NEAR(leaves(where) / all, count / static_cast<double>(tree.node_count() - 1), 0.005) << where;
  };
  expect("rank == 0", [&](NodeIndex node) { return rank[node] == 0; });
  expect("rank >= 2", [&](NodeIndex node) { return rank[node] >= 2; });
  const auto is_three_or_four = [&](NodeIndex node) { return tree.birth[node] == 10 || tree.birth[node] == 11; };
  expect("bud_age >= 3 && bud_age < 5", is_three_or_four);
  expect("inclination > 30", [&](NodeIndex node) {
    const Vec3 way = tree.position[node] - tree.position[tree.parent[node]];
    return static_cast<double>(way.y) > glm::length(way) * std::sin(radians(30));
  });
}

TEST(OrganizeComponent, ACutAboveNoLateralIsRefused) {
  for (const char* const number : {"0", "-2", "0.5", "1 / 0", "0 / 0"}) {
    EXPECT_EQ(fault(operation({{"above_lateral", number}})).path, "components.tree.operations[0].above_lateral")
        << number;
  }
}

TEST(OrganizeComponent, TakesTenThousandOperations) {
  Value::List operations;
  for (int k = 0; k < 10'000; ++k) {
    operations.push_back(Value::Object{{"do", "cut"}, {"at", 4}, {"shoots", "rank == 1 && length > 9"}, {"above", 1}});
  }
  EXPECT_EQ(skeleton_of({{"iterations", 5}, {"operations", operations}}).node_count(),
            skeleton_of({{"iterations", 5}}).node_count());
}

TEST(OrganizeComponent, ASupportOfTheSceneIsSeenOnce) {
  const Value::Object support{{"do", "support"}, {"named", "wire"}, {"thickness", 0.05}};
  Scene scene;
  scene.supports["wire"] = {Vec3(0), Vec3(0, 1, 0), Vec3(0, 2, 0)};
  const Plant plant = tree({{"operations", Value::List{Value(support)}},
                            {"iterations", 3},
                            {"frame", Value::Object{{"translate", Value::List{3, 0, 0}}}},
                            {"roots", Value::List{Value::List{0, 0, 0}, Value::List{2, 0, 0}}}})
                          .grow(0, scene);
  const std::vector<Organ> rods = organs_of(plant, "tree");
  ASSERT_EQ(rods.size(), 2U);
  EXPECT_NEAR(rods[1].frame.origin.x, 0, 1e-5) << "where the scene has it";
  EXPECT_NEAR(rods[1].frame.origin.y, 1, 1e-5);
}

TEST(OrganizeComponent, APlanLeavesTheTreeAndTellsTheTrainingsCuts) {
  const auto grown = [](bool plans) {
    return skeleton_of({{"training", "espalier"}, {"iterations", 12}, {"plan", plans}});
  };
  const Skeleton planned = grown(true), done = grown(false);
  EXPECT_GT(planned.node_count(), done.node_count());
  std::size_t metamers = 0;
  for (const OperationRecord& record : planned.operations) metamers += record.metamers;
  EXPECT_EQ(planned.node_count(), done.node_count() + metamers);
}

TEST(OrganizeComponent, GrowthThatExplodesStopsAtTheLimit) {
  const auto faults = faults_of([] { tree({{"resource", Value::Object{{"alpha", 900}}}}).node_limit(20'000).grow(); });
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].path, "components.tree.resource.alpha");
}

class OrganizeOnWood : public testing::Test {
 protected:
  /// Returns the parameters of a tree that continues from a table.
  Value::Object on(const std::string& table, Value::Object more = {}, Value::Object source = {}) const {
    std::ofstream(folder_ / "wood.csv") << table;
    source.emplace_back("file", (folder_ / "wood.csv").string());
    more.emplace_back("skeleton", std::move(source));
    return more;
  }

  TemporaryFolder folder_;
};

// A trunk of 3 m with a branch, in centimetres, z up, away from the origin.
const std::string kWood =
    "x,y,z,radius,parent\n100,0,0,10,-1\n100,0,100,8,0\n100,0,200,6,1\n100,0,300,4,2\n200,0,150,3,1\n";

TEST_F(OrganizeOnWood, GoesOnFromATable) {
  const Skeleton tree = skeleton_of(on(kWood, {{"iterations", 4}, {"length", 0.2}}, {{"unit", 0.01}}));
  EXPECT_TRUE(check_skeleton(tree));
  EXPECT_EQ(tree.position[0], Vec3(0));
  EXPECT_GE(tree.radius[0], 0.1F);
  EXPECT_GT(bounds(tree).high.y, 3) << "its top has grown";
  EXPECT_TRUE(std::ranges::find(tree.position, Vec3(0, 3, 0)) != tree.position.end()) << "and is where it was";
  EXPECT_GT(*std::ranges::max_element(tree.birth), 3);
}

TEST_F(OrganizeOnWood, StandsAtEachRootAndInFrames) {
  Value::Object parameters = on(kWood, {{"iterations", 0}, {"length", 0.2}}, {{"unit", 0.01}});
  parameters.emplace_back("roots", Value::List{Value::List{0, 0, 0}, Value::List{9, 0, 0}});
  parameters.emplace_back("frame", Value::Object{{"scale", Value::List{2, 2, 2}}, {"translate", Value::List{0, 0, 5}}});
  const Skeleton trees = skeleton_of(parameters);
  EXPECT_TRUE(std::ranges::find(trees.position, Vec3(0, 6, 5)) != trees.position.end());
  EXPECT_TRUE(std::ranges::find(trees.position, Vec3(18, 6, 5)) != trees.position.end());
  EXPECT_FLOAT_EQ(trees.radius[0], 0.2F);
}

TEST_F(OrganizeOnWood, AFileMayHaveSeveralTrees) {
  const std::string two = "x,y,z,radius,parent\n0,0,0,10,-1\n0,0,100,8,0\n500,0,0,10,-1\n500,0,100,8,2\n";
  const Skeleton trees = skeleton_of(on(two, {{"iterations", 3}}, {{"unit", 0.01}}));
  EXPECT_EQ(std::ranges::count(trees.parent, kNoNode), 2);
  Value::Object third{{"do", "cut"}, {"at", 2}, {"shoots", "leader"}, {"above", 2}, {"tree", 2}};
  const Diagnostic found =
      fault(on(two, {{"iterations", 3}, {"operations", Value::List{Value(third)}}}, {{"unit", 0.01}}));
  EXPECT_EQ(found.path, "components.tree.operations[0].tree");
  EXPECT_EQ(found.expected, "a number of the trees at 'roots', from 0 to 1");
}

TEST_F(OrganizeOnWood, RejectsFilesWithTheirLine) {
  const Diagnostic found = fault(on("x,y,z,radius,parent\n0,0,0,1,-1\n0,0,1,1,9\n"));
  EXPECT_EQ(found.path, "components.tree.skeleton.file");
  EXPECT_NE(found.message.find("wood.csv:3"), std::string::npos) << found.message;
}

TEST_F(OrganizeOnWood, CountsWhatStandsBeforeItIsMade) {
  const std::string tall = "x,y,z,radius,parent\n0,0,0,1,-1\n0,0,100000,1,0\n";
  const auto faults = faults_of([&] { tree(on(tall, {{"length", 0.001}})).node_limit(20'000).grow(); });
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].path, "components.tree.length");
}

}  // namespace meristem::organize_test
