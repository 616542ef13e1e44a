// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/colonize.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"
#include "tests/support/check_skeleton.h"

namespace meristem::colonize_test {

Value crown(std::initializer_list<Value::List> profile) {
  return Value::Object{{"profile", Value::List(profile.begin(), profile.end())}};
}

const Value kCrown = crown({{0, 0.4}, {0.5, 1}, {0.6, 1.5}, {0, 2.2}});

Value::Object with(Value::Object parameters) {
  parameters.insert(parameters.begin(), {"crown", kCrown});
  return parameters;
}

GraphBuilder tree(const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  return builder.component("view", "camera").component("tree", "colonize", parameters).link("view", "tree");
}

// Returns the only error of reading and growing.
Diagnostic error(const Value::Object& parameters) {
  const auto errors = errors_of([&] { tree(parameters).grow(); });
  EXPECT_EQ(errors.size(), 1U);
  return errors.empty() ? Diagnostic{} : errors[0];
}

TEST(ColonizeComponent, GrowsASkeletonFromItsParameters) {
  const Plant plant =
      tree(with({{"points", 400}, {"tip_radius", 0.002}, {"surface", Value::Object{{"sides", 5}}}})).grow();
  ASSERT_EQ(plant.stems.size(), 1U);
  const Skeleton& skeleton = plant.stems[0].skeleton;
  EXPECT_TRUE(check_skeleton(skeleton));
  EXPECT_GT(skeleton.node_count(), 100U);
  EXPECT_FLOAT_EQ(*std::min_element(skeleton.radius.begin(), skeleton.radius.end()), 0.002F);
  EXPECT_EQ(plant.stems[0].parts[0].surface.sides, 5);
  EXPECT_EQ(plant.stems[0].parts[0].component, "tree");
}

TEST(ColonizeComponent, MorePointsGiveMoreNodes) {
  const auto nodes = [](int points) { return tree(with({{"points", points}})).grow().node_count(); };
  EXPECT_LT(nodes(50), nodes(200));
  EXPECT_LT(nodes(200), nodes(800));
}

TEST(ColonizeComponent, PointsMayBeWrittenWithTheirName) {
  EXPECT_EQ(hash_of(tree(with({{"points", 99}})).grow()),
            hash_of(tree(with({{"points", Value::Object{{"count", 99}}}})).grow()));
}

TEST(ColonizeComponent, GrowsFromItsSite) {
  const auto moved = [](double x) {
    return tree(with({{"points", 200}, {"frame", Value::Object{{"translate", Value::List{x, 0, 0}}}}})).grow();
  };
  const Skeleton there = moved(8).stems.at(0).skeleton;
  EXPECT_EQ(there.position[0], Vec3(8, 0, 0));
  EXPECT_EQ(moved(0).stems.at(0).skeleton.position[0], Vec3(0, 0, 0));
  for (const Vec3 position : there.position) EXPECT_LT(std::abs(position.x - 8), 0.8F);
}

Value::Object scaled(double scale) { return {{"frame", Value::Object{{"scale", Value::List{scale, scale, scale}}}}}; }

TEST(ColonizeComponent, InAFrameHalfAsLargeItIsHalfAsLarge) {
  const Value::Object light{{"shift", 0.1}, {"limit", Value::Object{{"share", 0.2}}}, {"shade", Value::Object{}}};
  const Value::Object parameters =
      with({{"points", 150}, {"finish", Value::Object{{"subdivide", 1}}}, {"light", light}});
  Value::Object small = parameters;
  small.insert(small.end(), {"frame", scaled(0.5)[0].second});
  const Skeleton whole = tree(parameters).grow().stems.at(0).skeleton;
  const Skeleton half = tree(small).grow().stems.at(0).skeleton;
  EXPECT_EQ(half.parent, whole.parent);
  for (NodeIndex node = 0; node < whole.node_count(); ++node) {
    ASSERT_EQ(half.position[node], 0.5F * whole.position[node]);
    ASSERT_EQ(half.radius[node], 0.5F * whole.radius[node]);
  }
}

TEST(ColonizeComponent, AMultiplierScalesIt) {
  const auto under = [](double size) {
    return tree(with({{"points", 100}}))
        .component("hydra", "hydra", {{"number", 1}, {"angle", 0}, {"radius", 0}, {"size", size}})
        .component("other", "colonize", with({{"points", 100}}))
        .link("view", "hydra")
        .link("hydra", "other")
        .grow();
  };
  const auto height = [](const Plant& plant) {
    float highest = 0;
    for (const Vec3 position : plant.stems.at(1).skeleton.position) highest = std::max(highest, position.y);
    return highest;
  };
  EXPECT_NEAR(height(under(3)), 3 * height(under(1)), 0.3);
  EXPECT_EQ(under(0).stems.size(), 1U) << "nothing grows in a frame of no size";
}

TEST(ColonizeComponent, ATurnedFrameTurnsItsCrown) {
  const Value::Object over{{"rotate", Value::List{0, 0, -90}}};
  const Skeleton lying = tree(with({{"points", 200}, {"frame", over}})).grow().stems.at(0).skeleton;
  float farthest = 0, highest = 0;
  for (const Vec3 position : lying.position) {
    farthest = std::max(farthest, position.x);
    highest = std::max(highest, position.y);
  }
  EXPECT_GT(farthest, 1.7F);
  EXPECT_LT(highest, 0.7F);
}

TEST(ColonizeComponent, TwoTreesOfOneComponentDifferAndStandApart) {
  GraphBuilder builder(builtin_components());
  const auto at = [](double x) {
    return Value::Object{{"frame", Value::Object{{"translate", Value::List{x, 0, 0}}}}, {"hidden", true}};
  };
  builder.component("view", "camera").component("left", "simple", at(-3)).component("right", "simple", at(3));
  builder.component("tree", "colonize", with({{"points", 200}}));
  builder.link("view", "left").link("view", "right").link("left", "tree").link("right", "tree");
  const Plant plant = builder.grow();
  ASSERT_EQ(plant.stems.size(), 2U);
  EXPECT_EQ(plant.stems[0].skeleton.position[0].x, -3);
  EXPECT_EQ(plant.stems[1].skeleton.position[0].x, 3);
  EXPECT_NE(plant.stems[0].skeleton.node_count(), plant.stems[1].skeleton.node_count());
  EXPECT_TRUE(check_skeleton(plant.stems[1].skeleton));
}

TEST(ColonizeComponent, LeavesStandAlongTwigsAndAtTips) {
  auto builder = tree(with({{"points", 300}})).component("leaf", "leaf").component("bud", "simple");
  builder.link("tree", "leaf", LinkKind::branch, {{"count", 500}}).link("tree", "bud", LinkKind::leaf);
  const Plant plant = builder.grow();
  EXPECT_EQ(organs_of(plant, "leaf").size(), 500U);
  const SkeletonAxes axes(plant.stems.at(0).skeleton);
  EXPECT_EQ(organs_of(plant, "bud").size(), axes.count());
  std::size_t at_tip = 0;
  for (AxisIndex a = 0; a < axes.count(); ++a) {
    const Vec3 tip = plant.stems[0].skeleton.position[axes.of(a).back()];
    if (organs_of(plant, "bud")[a].frame.origin.y == tip.y + 0) ++at_tip;
  }
  EXPECT_EQ(at_tip, axes.count());
}

TEST(ColonizeComponent, EditingTheLeavesLeavesTheTreeAlone) {
  auto builder = tree(with({{"points", 300}})).component("leaf", "leaf");
  builder.link("tree", "leaf", LinkKind::branch, {{"count", 50}});
  const std::string before = hash_of(builder.grow(), "tree");
  builder.component("leaf", "leaf", {{"length", "rand(0.1, 0.2)"}});
  EXPECT_EQ(hash_of(builder.grow(), "tree"), before);
}

TEST(ColonizeComponent, TheSameBytesOnAnyNumberOfThreads) {
  auto builder = tree(with({{"points", 1500}})).component("leaf", "leaf", {{"curl", "rand(0, 60)"}});
  builder.link("tree", "leaf", LinkKind::branch, {{"density", 60}});
  std::vector<std::string> hashes;
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    hashes.push_back(hash_of(builder.grow()));
  }
  for (const std::string& hash : hashes) EXPECT_EQ(hash, hashes[0]);
}

TEST(ColonizeComponent, EmptyAndFaultyCrownsAreRejected) {
  EXPECT_EQ(error({{"crown", crown({{0, 0}, {0, 2}})}}).path, "components.tree.crown.profile");
  EXPECT_EQ(error({{"crown", crown({{1, 0}})}}).path, "components.tree.crown.profile");
  EXPECT_EQ(error({{"crown", crown({{1, 2}, {1, 1}})}}).path, "components.tree.crown.profile[1]");
  EXPECT_EQ(error({{"crown", crown({{1, 0}, {-1, 1}})}}).path, "components.tree.crown.profile[1][0]");
  EXPECT_EQ(error({}).message, "a colonize has no 'crown'");
}

TEST(ColonizeComponent, DistancesMustLetPointsPullBeforeTheyGo) {
  EXPECT_EQ(error(with({{"step", 0}})).path, "components.tree.step");
  EXPECT_EQ(error(with({{"kill", 0.6}, {"influence", 0.6}})).path, "components.tree.kill");
  EXPECT_EQ(error(with({{"kill", 0.04}, {"step", 0.05}})).path, "components.tree.step");
}

TEST(ColonizeComponent, TooManyPointsAreRejectedAtTheirParameter) {
  const Diagnostic found = error(with({{"points", 1e9}}));
  EXPECT_EQ(found.path, "components.tree.points");
  EXPECT_NE(found.text().find("1000000000 attraction points are too many"), std::string::npos) << found.text();
}

TEST(ColonizeComponent, RulesHoldForEachInstanceWhereParametersVary) {
  EXPECT_EQ(error(with({{"points", "1e9 + i"}})).path, "components.tree.points");
  EXPECT_EQ(error(with({{"kill", "0.7 + i"}})).path, "components.tree.kill");
}

std::size_t root_count(const Skeleton& skeleton) {
  return static_cast<std::size_t>(std::count(skeleton.parent.begin(), skeleton.parent.end(), kNoNode));
}

TEST(ColonizeComponent, RootsMakeAGroveWithACrownOverEach) {
  const Value::List two{Value::List{0, 0, 0}, Value::List{2, 0, 0}};
  const Plant plant = tree(with({{"points", 300}, {"roots", two}})).grow();
  ASSERT_EQ(plant.stems.size(), 1U);
  const Skeleton& grove = plant.stems[0].skeleton;
  EXPECT_TRUE(check_skeleton(grove));
  EXPECT_EQ(root_count(grove), 2U);
  // Each crown is about 1.2 m wide.
  EXPECT_LT(bounds(grove).low.x, -0.3F);
  EXPECT_GT(bounds(grove).high.x, 2.3F);
}

TEST(ColonizeComponent, OneCrownIsSharedByAllRoots) {
  const Value::List two{Value::List{-0.2, 0, 0}, Value::List{0.2, 0, 0}};
  const auto grove = [&](bool shared) {
    return tree(with({{"points", 300}, {"roots", two}, {"one_crown", shared}})).grow().stems[0].skeleton;
  };
  const Skeleton shared = grove(true);
  EXPECT_TRUE(check_skeleton(shared));
  EXPECT_EQ(root_count(shared), 2U);
  EXPECT_LT(shared.node_count(), grove(false).node_count());
  EXPECT_LT(bounds(shared).high.x, 0.65F);
}

TEST(ColonizeComponent, TreesOfADocumentCompeteUnlessAlone) {
  const auto nodes = [](bool alone) {
    GraphBuilder builder(builtin_components());
    builder.component("view", "camera");
    for (const char* id : {"a", "b"}) {
      const double x = *id == 'a' ? -0.2 : 0.2;
      const Value frame = Value::Object{{"translate", Value::List{x, 0, 0}}};
      builder.component(id, "colonize", with({{"points", 400}, {"alone", alone}, {"frame", frame}}));
      builder.link("view", id);
    }
    return builder.grow().node_count();
  };
  EXPECT_LT(static_cast<double>(nodes(false)), 0.85 * static_cast<double>(nodes(true)));
}

TEST(ColonizeComponent, ShedBranchesAreGoneAndRememberedByTheWood) {
  const auto stem = [](const char* shed, double memory) {
    return tree(with({{"points", 500}, {"shed", shed}, {"memory", memory}})).grow().stems[0].skeleton;
  };
  const Skeleton whole = tree(with({{"points", 500}})).grow().stems[0].skeleton;
  const Skeleton remembering = stem("height < 1.2", 1);
  const Skeleton forgetting = stem("height < 1.2", 0);
  ASSERT_TRUE(check_skeleton(remembering));
  ASSERT_TRUE(check_skeleton(forgetting));
  EXPECT_LT(remembering.node_count(), whole.node_count());
  EXPECT_EQ(remembering.position, forgetting.position);
  EXPECT_EQ(remembering.radius[0], whole.radius[0]);
  EXPECT_LT(forgetting.radius[0], whole.radius[0]);
  EXPECT_EQ(error({{"crown", kCrown}, {"shed", "heigth < 1"}}).nearest, "height");
}

TEST(ColonizeComponent, RefusesRootsThatAreNone) {
  EXPECT_EQ(error(with({{"roots", Value::List{}}})).path, "components.tree.roots");
  EXPECT_EQ(error(with({{"roots", Value::List{Value(Value::List{0, 0})}}})).path, "components.tree.roots[0]");
}

Scene walled_scene() {
  Scene scene;
  Obstacle wall;
  wall.mesh = box_mesh({-3, 0, 0.3}, {3, 3, 1});
  scene.obstacles = Obstacles({wall});
  scene.light.sun = sun_of_day(0.9, 126, 3);
  return scene;
}

TEST(ColonizeComponent, EachPartOfItsLightChangesHowItGrows) {
  const Scene scene = walled_scene();
  const auto grown = [&](Value::Object light) {
    return hash_of(tree(with({{"points", 300}, {"light", std::move(light)}})).grow(0, scene));
  };
  const auto plain = grown({});
  EXPECT_EQ(plain, hash_of(tree(with({{"points", 300}})).grow(0, scene)));
  EXPECT_NE(grown({{"shift", 0.3}}), plain);
  EXPECT_NE(grown({{"drift", 0.3}}), plain);
  EXPECT_NE(grown({{"limit", Value::Object{{"share", 0.3}}}}), plain);
  EXPECT_NE(grown({{"shade", Value::Object{{"bears", 0.95}, {"a", 1}}}}), plain);
  EXPECT_NE(grown({{"shift", 0.3}, {"hold_height", true}}), grown({{"shift", 0.3}}));
  EXPECT_NE(grown({{"drift", 0.3}, {"sunlit_weight", 0.1}}), grown({{"drift", 0.3}}));
  // The default step is 0.05 m.
  EXPECT_EQ(grown({{"shift_m", 0.015}}), grown({{"shift", 0.3}}));
}

TEST(ColonizeComponent, AFieldOfAWorldCarriesItsPoints) {
  const auto grown = [](double field, double strength) {
    GraphBuilder builder(builtin_components());
    const Value::Object wind{{"wind", Value::Object{}}, {"strength", strength}, {"add", true}};
    Value::Object parameters = with({{"points", 300}});
    if (field > 0) parameters.emplace_back("light", Value::Object{{"field", field}});
    return builder.component("view", "camera")
        .component("coast", "world", {{"light", wind}})
        .component("tree", "colonize", parameters)
        .link("view", "coast")
        .link("coast", "tree")
        .grow()
        .stems.at(0)
        .skeleton;
  };
  const auto mean = [](const Skeleton& tree) {
    double sum = 0;
    for (const Vec3 position : tree.position) sum += position.x;
    return sum / static_cast<double>(tree.node_count());
  };
  EXPECT_GT(mean(grown(0.1, 1)), mean(grown(0, 1)) + 0.1);
  EXPECT_GT(mean(grown(0.1, 1)), mean(grown(0.1, 0.3)) + 0.05);
  // Without a world, the parameter has no effect and is an error.
  const Diagnostic without = error(with({{"light", Value::Object{{"field", 0.1}}}}));
  EXPECT_EQ(without.path, "components.tree.light.field");
  EXPECT_EQ(without.message, "no world above the tree has a field of light or gravity");
}

/// Returns the warnings of reading.
std::vector<Diagnostic> warnings(const Value::Object& parameters) {
  const ComponentType type = colonize_component();
  const auto read = type.make_parameters();
  ParameterReader reader({}, SizeLimits());
  reader.read_varying(type.parameters, read.get(), parameters, DocumentPath(DocumentPath(), "tree"));
  return reader.take_diagnostics();
}

TEST(ColonizeComponent, WarnsOfShadeThatHasNoEffect) {
  for (const char* const name : {"bears", "a"}) {
    const Value::Object shade{{name, 0}, {"voxel", 0.5}};
    const auto found = warnings(with({{"light", Value::Object{{"shade", shade}}}}));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].path, std::string("tree.light.shade.") + name);
    EXPECT_EQ(found[0].severity, Severity::warning);
  }
  EXPECT_TRUE(warnings(with({{"light", Value::Object{{"shade", Value::Object{{"voxel", 0.5}}}}}})).empty());
}

TEST(ColonizeComponent, WarnsOfACrownThatIsNeverReached) {
  const Value::Object far{{"centre", Value::List{0, 900, 0}}, {"radius", 1}};
  const auto found = warnings({{"crown", Value::Object{{"sphere", far}}}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].severity, Severity::warning);
  EXPECT_EQ(found[0].path, "tree.iterations");
  EXPECT_EQ(found[0].message,
            "growth ends in the trunk: the crown begins 899 m from the root, and 1000 steps of 0.05 m with the "
            "influence distance of 0.6 m reach 50.6 m");
  EXPECT_TRUE(warnings(with({})).empty());
}

TEST(ColonizeComponent, ItsLightIsChecked) {
  const auto path_of = [](Value::Object light) { return error(with({{"light", std::move(light)}})).path; };
  EXPECT_EQ(path_of({{"shift", 1.5}}), "components.tree.light.shift");
  EXPECT_EQ(path_of({{"shift", 0.1}, {"shift_m", 0.1}}), "components.tree.light.shift_m");
  EXPECT_EQ(path_of({{"drift", -1}}), "components.tree.light.drift");
  EXPECT_EQ(path_of({{"limit", Value::Object{{"share", 1}}}}), "components.tree.light.limit.share");
  EXPECT_EQ(path_of({{"limit", Value::Object{{"share", 0.1}, {"radius", 0}}}}), "components.tree.light.limit.radius");
  EXPECT_EQ(path_of({{"shade", Value::Object{{"b", 0.5}}}}), "components.tree.light.shade.b");
  EXPECT_EQ(path_of({{"shade", Value::Object{{"depth", 100}}}}), "components.tree.light.shade.depth");
}

}  // namespace meristem::colonize_test
