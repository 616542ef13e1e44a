// SPDX-License-Identifier: Apache-2.0
// Operations and trainings of self-organizing trees.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/components/organize_in_a_test.h"
#include "meristem/components/parts/organize_table.h"
#include "meristem/graph/batch.h"
#include "meristem/plant/operation_record.h"
#include "tests/support/check_skeleton.h"

namespace meristem::organize_operations_test {

using namespace organize_test;

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
  EXPECT_EQ(error(operation({{"shoots", "mian"}, {"above", 2}})).path, "components.tree.operations[0].shoots");
  EXPECT_EQ(error(operation({{"shoots", "mian"}, {"above", 2}})).nearest, "main");
  EXPECT_EQ(error(operation({{"shoots", "leder"}, {"above", 2}})).nearest, "leader");
  EXPECT_EQ(error(operation({{"shoots", "main.4.x"}, {"above", 2}})).path, "components.tree.operations[0].shoots");
  EXPECT_EQ(error(operation({{"above", 0}})).path, "components.tree.operations[0].above");
  EXPECT_EQ(error(operation({{"at", 0}, {"above", 4}})).path, "components.tree.operations[0].at");
  EXPECT_EQ(error(operation({{"do", "prune"}, {"above", 4}})).path, "components.tree.operations[0].do");
  const Value::Object bare{{"at", 5}, {"shoots", "main"}, {"above", 3}};
  EXPECT_NE(error({{"operations", Value::List{Value(bare)}}}).message.find("'do'"), std::string::npos);
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
  const Diagnostic found = error(operation({{"at", 3}, {"shoots", "main.3000"}, {"above", 1}}));
  EXPECT_EQ(found.path, "components.tree.operations[0].shoots");
  EXPECT_NE(found.message.find("'main.3000'"), std::string::npos) << found.message;
  EXPECT_NE(found.expected.find("main"), std::string::npos);
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

TEST(OrganizeComponent, AnEspalierHoldsItsSizeAndItsLimits) {
  const auto grown = [](std::uint64_t seed, int iterations) {
    return tree({{"training", "espalier"},
                 {"iterations", iterations},
                 {"resource", Value::Object{{"alpha", 2.45}}},
                 {"length", 0.1}})
        .seed(seed)
        .grow()
        .stems.at(0)
        .skeleton;
  };
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    double first = 0;
    for (const int iterations : {15, 17, 20, 25}) {
      const Skeleton espalier = grown(seed, iterations);
      for (const Arm& arm : arms_of(espalier)) EXPECT_LE(arm.metamers, 12) << seed << " at " << iterations;
      const auto metamers = static_cast<double>(espalier.node_count() - 1);
      if (iterations == 15) first = metamers;
      EXPECT_NEAR(metamers / first, 1, 0.1) << seed << " at " << iterations;
    }
  }
}

TEST(OrganizeComponent, WarnsOfParametersOfCutsWithoutACut) {
  const auto marking = [](Value::Object more) {
    more.emplace_back("operations",
                      Value::List{Value(Value::Object{{"do", "mark"}, {"shoots", "rank == 1"}, {"state", "old"}})});
    return more;
  };
  EXPECT_EQ(warnings(marking({{"takeover", 0.3}})),
            "warning: tree.takeover: 'takeover' has no effect: none of the operations cuts a shoot\n");
  EXPECT_NE(warnings(marking({{"damage", false}})), "");
  EXPECT_NE(warnings(marking({{"resource", Value::Object{{"pass_back", 0.2}}}})), "");
  EXPECT_EQ(warnings(marking({})), "");
  Value::Object cutting = operation({{"above", 3}});
  cutting.emplace_back("takeover", 0.3);
  EXPECT_EQ(warnings(cutting), "");
}

TEST(OrganizeComponent, WarnsOfLateralsThatWaitInAnyCase) {
  const auto warned = [](Value::Object more) {
    more.emplace_back("laterals_wait", false);
    return warnings(more);
  };
  EXPECT_NE(warned({}), "") << "lambda is 0.52";
  EXPECT_EQ(warned({{"resource", Value::Object{{"lambda", 0.48}}}}), "");
  EXPECT_EQ(warned({{"terminal_threshold", 2}, {"lateral_threshold", 1.5}}), "");
  EXPECT_EQ(warned({{"light", Value::Object{{"model", "markers"}}}}), "");
  // The warning is true: both grow equal trees.
  EXPECT_EQ(skeleton_of({{"iterations", 12}, {"laterals_wait", false}}).position,
            skeleton_of({{"iterations", 12}}).position);
}

TEST(OrganizeComponent, LeansInVainUnderLightFromAbove) {
  const auto in_vain = [](Value::Object light, Vec3 toward) {
    const Graph graph = tree({{"light", std::move(light)}}).graph();
    Light sun;
    sun.sun = {{toward, 1}};
    return std::ranges::any_of(graph.components, [&](const Prototype& one) { return leans_in_vain(one, sun); });
  };
  EXPECT_TRUE(in_vain({{"lean", 0.5}}, kUp));
  EXPECT_FALSE(in_vain({{"lean", 0.5}}, Vec3(0.6F, 0.8F, 0)));
  EXPECT_FALSE(in_vain({}, kUp));
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
  const auto place = [](Value::Object more) { return error(operation(std::move(more))).path; };
  EXPECT_EQ(place({{"above", 2}, {"above_lateral", 3}}), "components.tree.operations[0]");
  EXPECT_EQ(place({{"above", 2}, {"every", 2}}), "components.tree.operations[0].every");
  EXPECT_EQ(place({{"above", 2}, {"when", "heigth > 2"}}), "components.tree.operations[0].when");
  EXPECT_EQ(place({{"above", 2}, {"shoots", "rnk >= 2"}}), "components.tree.operations[0].shoots");
  EXPECT_EQ(place({{"above", 2}, {"tree", 1}}), "components.tree.operations[0].tree");
  const auto support = [](Value line) {
    return error({{"operations", Value::List{Value(Value::Object{{"do", "support"}, {"line", std::move(line)}})}}})
        .path;
  };
  EXPECT_EQ(support(Value::List(1, Value(Value::List{0, 0, 0}))), "components.tree.operations[0].line");
  EXPECT_EQ(support(Value::List{Value::List{0, 0, 0}, Value::List{0, 0, 0}}), "components.tree.operations[0].line[1]");
}

TEST(OrganizeComponent, SupportsTiesAndMarksAreChecked) {
  const auto found = [](Value::Object operation) {
    return error({{"operations", Value::List{Value(std::move(operation))}}});
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
  const auto errors = errors_of([&] { read(32); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "components.tree.operations[31].state");
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
    EXPECT_EQ(error(operation({{"above_lateral", number}})).path, "components.tree.operations[0].above_lateral")
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

}  // namespace meristem::organize_operations_test
