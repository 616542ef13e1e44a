// SPDX-License-Identifier: Apache-2.0
// Self-organizing growth as a whole: published sizes, invariance, and errors.
#include "meristem/grow/organize/organize.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "tests/support/check_skeleton.h"
#include "tests/support/organized_trees.h"

namespace meristem::organize_test {

Diagnostic error_of(const OrganizeParameters& parameters, const Scene& scene = {}, const SizeLimits& limits = {},
                    const Frame& seed = {}) {
  try {
    grow_organized(parameters, 1, scene, seed, limits);
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().size(), 1U);
    EXPECT_FALSE(error.diagnostics()[0].expected.empty());
    return error.diagnostics()[0];
  }
  ADD_FAILURE() << "no InputError";
  return {};
}

/// Sizes of trees of 20 seeds.
struct Sizes {
  std::vector<double> metamers;
  double mean = 0;
  double mean_height = 0;

  explicit Sizes(const OrganizeParameters& parameters) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Skeleton tree = grow_organized(parameters, seed);
      EXPECT_TRUE(check_skeleton(tree));
      metamers.push_back(metamer_count(tree));
      mean += metamers.back() / 20;
      mean_height += bounds(tree).high.y / 20.0;
    }
  }
};

TEST(Organize, GrowsToItsKnownSizes) {
  // Figures of the specification, from its own trials.
  struct Known {
    OrganizeParameters parameters;
    double metamers;
    double height;  // in metamers; 0: unknown
  };
  for (const auto& [parameters, metamers, height] :
       {Known{slim(9), 32, 12}, Known{slim(18), 288, 30}, Known{slim(25), 1080, 43}, Known{full(9), 146, 0},
        Known{full(18), 1640, 0}, Known{full(25), 6270, 0}}) {
    const Sizes sizes(parameters);
    EXPECT_NEAR(sizes.mean, metamers, 0.25 * metamers);
    if (height > 0) {
      EXPECT_NEAR(sizes.mean_height, height, 0.1 * height);
    }
    // Single trees change by whole metamers, but not by more than this.
    EXPECT_GT(std::ranges::min(sizes.metamers), 0.5 * sizes.mean);
    EXPECT_LT(std::ranges::max(sizes.metamers), 1.5 * sizes.mean);
  }
}

TEST(Organize, MetamersAreOneLengthLong) {
  const Skeleton tree = grow_organized(full(12));
  for (NodeIndex node = 1; node < tree.node_count(); ++node) {
    ASSERT_NEAR(glm::distance(tree.position[node], tree.position[tree.parent[node]]), 1, 1e-5);
  }
}

TEST(Organize, IsTheSameOnAnyNumberOfThreads) {
  OrganizeParameters parameters = full(22);
  parameters.shedding.below = 0.05;
  parameters.sag.emplace();
  const auto hash_on = [&](int threads) {
    const ThreadLimit limit(threads);
    return skeleton_hash(grow_organized(parameters));
  };
  const std::string one = hash_on(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(hash_on(threads), one);
}

TEST(Organize, AnotherSeedGrowsAnotherTree) {
  EXPECT_NE(skeleton_hash(grow_organized(full(9), 1)), skeleton_hash(grow_organized(full(9), 2)));
}

TEST(Organize, FewerIterationsGrowTheBeginningOfTheSameTree) {
  const Skeleton whole = grow_organized(full(15));
  for (const int iterations : {0, 1, 7, 14}) {
    const Skeleton part = grow_organized(full(iterations));
    const auto nodes = static_cast<std::ptrdiff_t>(part.node_count());
    EXPECT_EQ(nodes, std::ranges::count_if(whole.birth, [&](float birth) { return birth <= iterations; }));
    EXPECT_TRUE(std::equal(part.position.begin(), part.position.end(), whole.position.begin()));
    EXPECT_TRUE(std::equal(part.parent.begin(), part.parent.end(), whole.parent.begin()));
    EXPECT_TRUE(std::equal(part.birth.begin(), part.birth.end(), whole.birth.begin()));
  }
}

TEST(Organize, TreesOfLongerMetamersAreTheSameTreesEnlarged) {
  OrganizeParameters twice = full(14);
  twice.length = 2;
  const Skeleton small = grow_organized(full(14));
  const Skeleton large = grow_organized(twice);
  EXPECT_EQ(large.parent, small.parent);
  for (NodeIndex node = 0; node < small.node_count(); ++node) {
    ASSERT_EQ(large.position[node], 2.0F * small.position[node]);
  }
}

TEST(Organize, ColumnsTellWhatGrew) {
  const Skeleton tree = grow_organized(full(12));
  const auto column = [&](const char* name) { return tree.extra.find(name)->second; };
  const auto terminal = column("terminal_bud");
  const auto lateral = column("lateral_bud");
  const auto number = column("metamer");
  std::vector<int> children(tree.node_count(), 0);
  for (NodeIndex node = 1; node < tree.node_count(); ++node) {
    const NodeIndex parent = tree.parent[node];
    const bool goes_on = tree.axis[node] == tree.axis[parent];
    EXPECT_EQ((goes_on ? terminal : lateral)[parent], 1);
    EXPECT_EQ(number[node], goes_on ? number[parent] + 1 : 1);
    ++children[parent];
  }
  for (NodeIndex node = 0; node < tree.node_count(); ++node) {
    EXPECT_EQ(children[node], (terminal[node] == 1 ? 1 : 0) + (lateral[node] == 1 ? 1 : 0));
  }
  EXPECT_EQ(number[0], 0);
  EXPECT_FLOAT_EQ(column("resource")[0], 2 * column("light")[0]);
}

TEST(Organize, ResourceComesDownFromTheSeed) {
  const Skeleton tree = grow_organized(full(12));
  const auto& resource = tree.extra.find("resource")->second;
  const NodeChildren children(tree);
  for (NodeIndex node = 0; node < tree.node_count(); ++node) {
    float sum = 0;
    for (const NodeIndex child : children.of(node)) sum += resource[child];
    EXPECT_LE(sum, resource[node] * 1.00001F);
  }
}

TEST(Organize, WithoutWaitingLateralsOpenBesideDormantTerminals) {
  OrganizeParameters parameters = slim(12);
  parameters.lateral_threshold = 1;
  parameters.resource.lambda = 0.4;
  const auto has_lone_lateral = [&](bool wait) {
    parameters.laterals_wait = wait;
    const Skeleton tree = grow_organized(parameters);
    for (NodeIndex node = 1; node < tree.node_count(); ++node) {
      const bool is_dormant = tree.extra.find("terminal_bud")->second[node] == 0;
      if (is_dormant && tree.extra.find("lateral_bud")->second[node] == 1) return true;
    }
    return false;
  };
  EXPECT_FALSE(has_lone_lateral(true));
  EXPECT_TRUE(has_lone_lateral(false));
}

TEST(Organize, ALowerLateralThresholdBranchesMore) {
  OrganizeParameters parameters = slim(12);
  const Skeleton with = grow_organized(parameters);
  parameters.lateral_threshold = 1;
  const Skeleton without = grow_organized(parameters);
  EXPECT_GT(SkeletonAxes(without).count(), 3 * SkeletonAxes(with).count());
}

TEST(Organize, HigherLambdaGrowsSlenderTrees) {
  const auto slenderness = [](double lambda) {
    OrganizeParameters parameters = full(16);
    parameters.resource.lambda = lambda;
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Vec3 size = bounds(grow_organized(parameters, seed)).size();
      sum += size.y / std::max(size.x, size.z);
    }
    return sum;
  };
  EXPECT_GT(slenderness(0.56), 1.3 * slenderness(0.48));
}

TEST(Organize, PriorityForTheFirstIterationsGrowsAnotherTreeThatDoesNotExplode) {
  OrganizeParameters parameters = slim(18);
  parameters.resource.division = ResourceModel::Division::priority;
  parameters.resource.until = 8;
  const Skeleton tree = grow_organized(parameters);
  EXPECT_TRUE(check_skeleton(tree));
  EXPECT_GT(metamer_count(tree), 30);
  EXPECT_LT(metamer_count(tree), 10'000);
  EXPECT_NE(skeleton_hash(tree), skeleton_hash(grow_organized(slim(18))));
}

TEST(Organize, LongestShootBoundsWhatABudGrowsInAnIteration) {
  OrganizeParameters parameters = full(12);
  parameters.resource.lambda = 0.6;
  const auto longest = [&](int max) {
    parameters.longest_shoot = max;
    const Skeleton tree = grow_organized(parameters);
    std::vector<int> run(tree.node_count(), 1);
    for (NodeIndex node = 1; node < tree.node_count(); ++node) {
      const NodeIndex parent = tree.parent[node];
      const bool goes_on = tree.birth[node] == tree.birth[parent] && tree.axis[node] == tree.axis[parent];
      if (goes_on) run[node] = run[parent] + 1;
    }
    return std::ranges::max(run);
  };
  EXPECT_EQ(longest(1), 1);
  EXPECT_EQ(longest(2), 2);
  EXPECT_GT(longest(10), 2);
}

TEST(Organize, StretchedShootsAreAsLongAsTheirResource) {
  OrganizeParameters parameters = full(1);
  parameters.resource.alpha = 2.7;
  EXPECT_EQ(metamer_count(grow_organized(parameters)), 2);
  EXPECT_LT(bounds(grow_organized(parameters)).high.y, 2.1F);
  parameters.stretch = true;
  const Skeleton stretched = grow_organized(parameters);
  EXPECT_EQ(metamer_count(stretched), 2);
  for (NodeIndex node = 1; node <= 2; ++node) {
    EXPECT_NEAR(glm::distance(stretched.position[node], stretched.position[node - 1]), 1.35, 1e-5);
  }
}

TEST(Organize, ShedsAsMuchAsPublished) {
  const auto kept = [](double below) {
    OrganizeParameters parameters = full(25);
    parameters.shedding.below = below;
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const Skeleton tree = grow_organized(parameters, seed);
      EXPECT_TRUE(check_skeleton(tree));
      sum += metamer_count(tree);
    }
    return sum;
  };
  const double all = kept(0);
  EXPECT_NEAR(kept(0.1) / all, 0.81, 0.05);
  EXPECT_NEAR(kept(0.3) / all, 0.43, 0.05);
}

TEST(Organize, WhereAShootWasShedNothingGrowsAgain) {
  OrganizeParameters parameters = full(20);
  parameters.shedding.below = 0.3;
  const Skeleton tree = grow_organized(parameters);
  const auto& lateral = tree.extra.find("lateral_bud")->second;
  const auto& lost = tree.extra.find("shed")->second;
  const NodeChildren children(tree);
  std::size_t dead = 0;
  for (NodeIndex node = 1; node < tree.node_count(); ++node) {
    if (lateral[node] != 3) continue;
    ++dead;
    EXPECT_GT(lost[node], 0);
    EXPECT_LE(children.of(node).size(), 1U);
  }
  EXPECT_GT(dead, 20U);
}

TEST(Organize, YoungShootsAreNotShed) {
  OrganizeParameters parameters = full(8);
  parameters.shedding = {.below = 1000, .after = 3};  // everything that may be shed is shed
  const Skeleton tree = grow_organized(parameters);
  std::vector<float> began(SkeletonAxes(tree).count(), 0);
  for (NodeIndex node = tree.node_count(); node-- > 1;) began[tree.axis[node]] = tree.birth[node];
  ASSERT_GT(began.size(), 2U);
  for (std::size_t axis = 1; axis < began.size(); ++axis) EXPECT_GE(began[axis], 8 - 3);
  parameters.shedding.after = 8;
  EXPECT_EQ(skeleton_hash(grow_organized(parameters)), skeleton_hash(grow_organized(full(8))));
}

TEST(Organize, SheddedWoodIsRemembered) {
  OrganizeParameters parameters = full(18);
  parameters.shedding.below = 0.3;
  const Skeleton remembering = grow_organized(parameters);
  parameters.radii.memory = 0;
  const Skeleton forgetting = grow_organized(parameters);
  EXPECT_EQ(remembering.position, forgetting.position);
  EXPECT_GT(remembering.radius[0], forgetting.radius[0]);
}

TEST(Organize, ExplosionStopsAtTheLimitOfNodes) {
  OrganizeParameters parameters = organized(1000, 60);
  parameters.resource.lambda = 0.5;
  SizeLimits limits;
  limits.nodes = 5000;
  const Diagnostic found = error_of(parameters, {}, limits);
  EXPECT_EQ(found.path, "components.tree.resource.alpha");
  EXPECT_NE(found.text().find("nodes"), std::string::npos) << found.text();
}

TEST(Organize, TheLimitOfNodesCountsAllTreesOfAComponent) {
  const auto grow = [](std::uint64_t nodes) {
    SizeLimits limits;
    limits.nodes = nodes;
    const Scene scene;
    std::vector<OrganizeSeed> seeds(3);
    for (int k = 0; k < 3; ++k) seeds[static_cast<std::size_t>(k)].frame.origin.x = 100.0F * static_cast<float>(k);
    Stand stand;
    stand.add(make_organizer(stand, seeds, full(6), RandomKey(1), scene, limits, "tree"));
    Progress progress;
    stand.grow(progress);
    return stand.take_skeletons(progress)[0];
  };
  const Skeleton three = grow(1'000'000);
  EXPECT_TRUE(check_skeleton(three));
  EXPECT_EQ(std::ranges::count(three.parent, kNoNode), 3);
  EXPECT_NO_THROW(grow(three.node_count()));
  EXPECT_THROW(grow(three.node_count() - 1), InputError);
}

TEST(Organize, ASeedInAnObstacleIsRefused) {
  Scene scene;
  Obstacle block;
  block.mesh = box_mesh({-1, -1, -1}, {1, 0.5, 1});
  scene.obstacles = Obstacles({block});
  const Diagnostic found = error_of(full(5), scene);
  EXPECT_EQ(found.path, "components.tree.roots");
  EXPECT_NE(found.message.find("(0, 0, 0)"), std::string::npos) << found.message;
}

TEST(Organize, WhereNothingGrowsIsAFault) {
  EXPECT_EQ(error_of(organized(0.9, 5)).path, "components.tree.resource.alpha");
  Scene night;
  night.light.sun.clear();
  EXPECT_EQ(error_of(full(5), night).path, "components.tree.light");
  Scene cellar;
  Obstacle lid;
  lid.mesh = box_mesh({-50, 20, -50}, {50, 21, 50});
  cellar.obstacles = Obstacles({lid});
  EXPECT_EQ(error_of(full(5), cellar).path, "components.tree.light");
  // A bud does not open in the dark, however low its threshold is.
  OrganizeParameters undemanding = full(5);
  undemanding.terminal_threshold = 0;
  undemanding.resource.alpha0 = 2;
  EXPECT_EQ(error_of(undemanding, night).path, "components.tree.light");
}

TEST(Organize, UnderAFaintSkyAloneTreesGrowLess) {
  // As at night, all light comes from the sky and is below 1.
  Scene scene;
  scene.light.sun.clear();
  scene.light.sky = even_sky(0.95);
  const double faint = metamer_count(grow_organized(full(14), 1, scene));
  scene.light.sky = even_sky(1);
  EXPECT_LT(faint, 0.9 * metamer_count(grow_organized(full(14), 1, scene)));
}

TEST(Organize, WhereNoStemHasRoomIsAFaultOfTheRoots) {
  // Seeds that point into the ground.
  const Frame down = frame_along(Vec3(0), -kUp, Vec3(0, 0, 1));
  EXPECT_EQ(error_of(full(5), {}, {}, down).path, "components.tree.roots");
}

TEST(Organize, NoIterationsLeaveTheSeed) {
  const Skeleton seed = grow_organized(organized(0, 0));
  EXPECT_EQ(seed.node_count(), 1U);
  EXPECT_TRUE(check_skeleton(seed));
}

TEST(Organize, RejectsParametersOutOfTheirRanges) {
  const auto rejects = [](auto change) {
    OrganizeParameters parameters = full(2);
    change(parameters);
    EXPECT_THROW(grow_organized(parameters), std::invalid_argument);
  };
  rejects([](OrganizeParameters& p) { p.iterations = -1; });
  rejects([](OrganizeParameters& p) { p.iterations = 65536; });
  rejects([](OrganizeParameters& p) { p.every = 0; });
  rejects([](OrganizeParameters& p) { p.longest_shoot = 0; });
  rejects([](OrganizeParameters& p) { p.maturity = 0; });
  rejects([](OrganizeParameters& p) { p.length = 0; });
  rejects([](OrganizeParameters& p) { p.length = std::numeric_limits<double>::quiet_NaN(); });
  rejects([](OrganizeParameters& p) { p.light.full = -1; });
  rejects([](OrganizeParameters& p) { p.operations = {cut_above(1, "main", -1)}; });
  rejects([](OrganizeParameters& p) { p.light.a = -1; });
  rejects([](OrganizeParameters& p) { p.light.b = 0.5; });
}

TEST(Organize, StopsWhenAsked) {
  Stand stand;
  const Scene scene;
  add_organizer(stand, full(40), 1, scene);
  Progress* asked = nullptr;
  Progress progress([&](std::string_view, double share) {
    if (share > 0.3) asked->cancel();
  });
  asked = &progress;
  EXPECT_THROW(stand.grow(progress), Cancelled);
}

}  // namespace meristem::organize_test
