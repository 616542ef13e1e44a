// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/tree.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/scene/mesh_scene.h"
#include "tests/support/build_graph.h"
#include "tests/support/check_mesh.h"
#include "tests/support/check_skeleton.h"

namespace meristem::tree_test {

GraphBuilder trunk(const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  return builder.component("view", "camera").component("trunk", "tree", parameters).link("view", "trunk");
}

Vec3 tip_heading(const Skeleton& skeleton) {
  const NodeIndex tip = static_cast<NodeIndex>(skeleton.node_count() - 1);
  return glm::normalize(skeleton.position[tip] - skeleton.position[skeleton.parent[tip]]);
}

TEST(Tree, IsAsLongAndThickAsItSays) {
  const Plant plant = trunk({{"length", 3}, {"radius", 0.1}, {"segments", 6}}).grow();
  const Skeleton& stem = plant.stems.at(0).skeleton;
  check_skeleton(stem);
  ASSERT_EQ(stem.node_count(), 7U);
  EXPECT_NEAR(stem.position[6].y, 3, 1e-5);
  EXPECT_NEAR(stem.radius[0], 0.1, 1e-6);
  EXPECT_NEAR(stem.radius[6], 0.015, 1e-6);
}

TEST(Tree, CurlTurnsTheTipByItsAngleHoweverManySegments) {
  for (const int segments : {1, 4, 64}) {
    const Plant plant = trunk({{"curl", 60}, {"segments", segments}}).grow();
    EXPECT_NEAR(degrees(std::acos(tip_heading(plant.stems.at(0).skeleton).y)), 60, 0.01) << segments;
  }
}

TEST(Tree, GravitropismClosesItsShareOfTheAngleHoweverManySegments) {
  // It starts at 90 degrees from straight down; a half leaves 45.
  for (const int segments : {1, 8, 64}) {
    const Value::Object frame{{"rotate", Value(Value::List{90, 0, 0})}};
    const Plant plant = trunk({{"gravitropism", 0.5}, {"segments", segments}, {"frame", frame}}).grow();
    const Vec3 heading = tip_heading(plant.stems.at(0).skeleton);
    EXPECT_NEAR(degrees(std::acos(-heading.y)), 45, 0.05) << segments;
  }
}

TEST(Tree, PhototropismTurnsToTheSun) {
  Scene scene;
  scene.sun = {kPi / 2, radians(30)};
  scene.light.sun = {{.toward = unit_vector(scene.sun)}};
  const Plant plant = trunk({{"phototropism", 1}}).grow(0, scene);
  EXPECT_GT(glm::dot(tip_heading(plant.stems.at(0).skeleton), unit_vector(scene.sun)), 0.999F);
}

TEST(Tree, GnarlWandersDifferentlyInEachInstanceAndKeepsTheLength) {
  GraphBuilder builder = trunk({{"hidden", true}});
  builder.component("twig", "tree", {{"gnarl", 40}, {"segments", 32}, {"length", 1}});
  const Plant plant = builder.link("trunk", "twig", LinkKind::branch, {{"count", 2}}).grow();
  ASSERT_EQ(plant.stems.size(), 2U);  // hidden stems are not joined
  std::vector<Vec3> tips;
  for (const Stem& stem : plant.stems) {
    float length = 0;
    for (NodeIndex node = 1; node < stem.skeleton.node_count(); ++node) {
      length += glm::distance(stem.skeleton.position[node], stem.skeleton.position[node - 1]);
    }
    EXPECT_NEAR(length, 1, 1e-5);
    tips.push_back(stem.skeleton.position.back() - stem.skeleton.position.front());
  }
  EXPECT_GT(glm::distance(tips[0], tips[1]), 0.01F);
}

GraphBuilder three_levels() {
  GraphBuilder builder = trunk({{"length", 4}, {"radius", 0.1}});
  builder.component("limb", "tree", {{"length", 1.5}, {"radius", "0.5*radius"}, {"gravitropism", 0.2}});
  builder.component("twig", "tree", {{"length", 0.4}, {"radius", 0.008}});
  builder.link("trunk", "limb", LinkKind::branch, {{"count", 12}, {"start", 0.2}, {"angle", 60}});
  builder.link("limb", "twig", LinkKind::branch, {{"density", 6}, {"start", 0.2}});
  return builder;
}

TEST(Tree, BranchesOnBranchesAreOneSkeletonWithTheirOrders) {
  const Plant plant = three_levels().grow();
  ASSERT_EQ(plant.stems.size(), 1U);
  const Stem& tree = plant.stems[0];
  check_skeleton(tree.skeleton);
  const std::vector<std::string> names{"trunk", "limb", "twig"};
  for (NodeIndex node = 0; node < tree.skeleton.node_count(); ++node) {
    EXPECT_EQ(tree.part(tree.skeleton.axis[node]).component, names.at(tree.skeleton.order[node]));
  }
  // Each branch begins at a node on its parent's axis, on the parent's curve.
  for (NodeIndex node = 1; node < tree.skeleton.node_count(); ++node) {
    const NodeIndex parent = tree.skeleton.parent[node];
    EXPECT_LT(glm::distance(tree.skeleton.position[node], tree.skeleton.position[parent]), 0.4F);
  }
}

TEST(Tree, BranchesOnBranchesAreClosedMeshesOfTheirComponents) {
  const Plant plant = three_levels().grow();
  Progress progress;
  const MeshScene scene = make_mesh_scene(plant, {}, progress);
  ASSERT_EQ(scene.meshes.size(), 3U);
  for (const MeshInstances& instances : scene.meshes) {
    Mesh mesh = *instances.mesh;
    mesh.normals.clear();
    EXPECT_TRUE(check_mesh(mesh, {.outward = false})) << instances.component;
  }
}

TEST(Tree, IsTheSameOnAnyNumberOfThreads) {
  const ThreadLimit one(1);
  const std::string hash = hash_of(three_levels().grow());
  for (const int threads : {2, 3, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(hash_of(three_levels().grow()), hash);
  }
}

TEST(Tree, ChildrenStandAtItsTip) {
  GraphBuilder builder = trunk({{"length", 2}, {"curl", 90}, {"segments", 32}});
  const Plant plant = builder.component("cone", "simple").link("trunk", "cone").grow();
  const std::vector<Organ> cones = organs_of(plant, "cone");
  ASSERT_EQ(cones.size(), 1U);
  const Skeleton& stem = plant.stems.at(0).skeleton;
  EXPECT_EQ(cones[0].frame.origin, stem.position.back());
  EXPECT_LT(glm::distance(glm::normalize(cones[0].frame.heading()), tip_heading(stem)), 1e-4F);
}

TEST(Tree, ItsAxisFollowsASplineAtItsOwnLength) {
  // A quarter circle in the plane to the stem's right.
  Value::List axis;
  for (const double a : {22.5, 45.0, 67.5, 90.0}) {
    axis.emplace_back(Value::List{1 - std::cos(radians(a)), std::sin(radians(a)), 0});
  }
  const Plant plant = trunk({{"axis", axis}, {"length", 5}, {"segments", 60}}).grow();
  const Skeleton& stem = plant.stems.at(0).skeleton;
  const float radius = 5 / (0.5F * static_cast<float>(kPi));
  float length = 0;
  for (NodeIndex node = 1; node < stem.node_count(); ++node) {
    length += glm::distance(stem.position[node], stem.position[node - 1]);
    EXPECT_NEAR(glm::distance(stem.position[node], Vec3(radius, 0, 0)), radius, 0.02F * radius);
  }
  EXPECT_NEAR(length, 5, 1e-4);
  EXPECT_GT(tip_heading(stem).x, 0.99F);
}

TEST(Tree, ASpiralIsAHelix) {
  // Curvature k and torsion t give the radius k / (k^2 + t^2) around an axis at the angle atan(k / t) to the curve.
  const double curl = 6 * kPi, spiral = 8 * kPi;  // per metre
  const Plant plant = trunk({{"curl", degrees(curl)}, {"spiral", degrees(spiral)}, {"segments", 1000}}).grow();
  const Skeleton& stem = plant.stems.at(0).skeleton;
  const double whole = std::sqrt(curl * curl + spiral * spiral);
  // Points one winding apart are on a line along the axis, at the pitch of 2 pi t / (k^2 + t^2).
  const auto winding = static_cast<NodeIndex>(std::lround(1000 * 2 * kPi / whole));
  for (const NodeIndex node : {0U, 150U, 400U}) {
    EXPECT_NEAR(glm::distance(stem.position[node], stem.position[node + winding]), 2 * kPi * spiral / (whole * whole),
                2e-3);
  }
}

TEST(Tree, FaultsOfAnAxisAreLocated) {
  const auto error = [](const Value::List& axis) {
    const std::vector<Diagnostic> errors = errors_of([&] { trunk({{"axis", axis}}); });
    return errors.size() == 1 ? errors[0].path : std::to_string(errors.size()) + " faults";
  };
  const Value::List zero{0, 0, 0}, one{0, 1, 0};
  EXPECT_EQ(error({zero, one}), "components.trunk.axis[0]");
  EXPECT_EQ(error({one, one}), "components.trunk.axis[1]");
  EXPECT_EQ(error(Value::List(501, Value(one))), "components.trunk.axis");
}

TEST(Tree, ItBendsAwayFromEachOfItsBranches) {
  const Value::Object rows{{"count", 4},     {"divergence", 180}, {"roll", 0},         {"angle", 50},
                           {"segments", 80}, {"deflection", 30},  {"angle_spread", 10}};
  GraphBuilder builder = trunk(rows).component("twig", "tree", {{"length", 0.1}, {"radius", 0.001}});
  const Plant plant = builder.link("trunk", "twig", LinkKind::branch).grow();
  const Skeleton& tree = plant.stems.at(0).skeleton;
  // Straight pieces between bends of 30 degrees, each away from the twig at the bend.
  const SkeletonAxes axes(tree);
  std::vector<Vec3> directions;
  for (const NodeIndex node : axes.of(0).subspan(1)) {
    const Vec3 way = tree.position[node] - tree.position[tree.parent[node]];
    if (glm::length(way) < 1e-3F) continue;  // rounding at a node that a twig inserted
    const Vec3 direction = glm::normalize(way);
    if (directions.empty() || glm::distance(directions.back(), direction) > 1e-3F) directions.push_back(direction);
  }
  ASSERT_EQ(directions.size(), 5U);
  std::vector<Vec3> twigs;
  for (AxisIndex axis = 1; axis < axes.count(); ++axis) {
    twigs.push_back(tree.position[axes.of(axis).back()] - tree.position[axes.of(axis).front()]);
  }
  ASSERT_EQ(twigs.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(degrees(std::acos(glm::dot(directions[k], directions[k + 1]))), 30, 0.1);
    EXPECT_LT(glm::dot(twigs[k], directions[k + 1] - directions[k]), 0);
  }
}

TEST(Tree, ItsOwnBranchingHoldsWhereALinkSaysNothing) {
  const auto twigs_of = [](const Value::Object& own, const Value::Object& link) {
    GraphBuilder builder = trunk(own).component("cone", "simple");
    return organs_of(builder.link("trunk", "cone", LinkKind::branch, link).grow(), "cone").size();
  };
  EXPECT_EQ(twigs_of({{"count", 7}}, {}), 7U);
  EXPECT_EQ(twigs_of({{"count", 7}, {"whorl", 2}}, {}), 14U);
  EXPECT_EQ(twigs_of({{"count", 7}, {"whorl", 2}}, {{"count", 3}}), 6U);
  EXPECT_EQ(twigs_of({{"count", 7}, {"whorl", 2}}, {{"whorl", 1}}), 7U);
}

TEST(Tree, ItsOwnBranchingVariesFromInstanceToInstance) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("row", "hydra", {{"number", 3}, {"radius", 1}});
  builder.component("trunk", "tree", {{"count", Value(Value::List{2, 6})}}).component("cone", "simple");
  builder.link("view", "row").link("row", "trunk").link("trunk", "cone", LinkKind::branch);
  EXPECT_EQ(organs_of(builder.grow(), "cone").size(), 2U + 4U + 6U);
}

TEST(Tree, ComplementaryExceptionsGiveTwoKindsOfChildAtTheSamePlaces) {
  const Value::List chosen{1, Value::List{4, 6}, "i % 5 == 3"};
  const auto grow = [&](bool both) {
    GraphBuilder builder = trunk({{"density", 12.6}, {"angle_spread", 20}});
    builder.component("leaf", "leaf", both ? Value::Object{{"omit", chosen}} : Value::Object{});
    if (both) builder.component("twig", "simple", {{"only", chosen}});
    builder.link("trunk", "leaf", LinkKind::branch);
    if (both) builder.link("trunk", "twig", LinkKind::branch);
    return builder.grow();
  };
  const std::vector<Organ> whole = organs_of(grow(false), "leaf");
  const Plant mixed = grow(true);
  const std::vector<Organ> leaves = organs_of(mixed, "leaf"), twigs = organs_of(mixed, "twig");
  ASSERT_EQ(leaves.size() + twigs.size(), whole.size());
  ASSERT_GT(twigs.size(), 4U);
  std::size_t leaf = 0, twig = 0;
  for (std::size_t k = 0; k < whole.size(); ++k) {
    const bool is_twig = k == 1 || (k >= 4 && k <= 6) || k % 5 == 3;
    const Frame& frame = is_twig ? twigs[twig++].frame : leaves[leaf++].frame;
    EXPECT_EQ(frame.origin, whole[k].frame.origin) << k;
    EXPECT_LT(glm::distance(glm::normalize(frame.heading()), glm::normalize(whole[k].frame.heading())), 1e-5F);
  }
}

TEST(Tree, AStemThatGoesOnAtATipBeginsAsThickAsItsTaperSays) {
  // The lower stem ends with 0.03; the upper one continues with it and ends with 0.0045.
  GraphBuilder builder = trunk({{"radius", 0.2}});
  builder.component("top", "tree", {{"length", 0.3}, {"radius", "radius"}, {"segments", 6}}).link("trunk", "top");
  Progress progress;
  const MeshScene scene = make_mesh_scene(builder.grow(), {}, progress);
  float widest = 0;
  for (const MeshInstances& instances : scene.meshes) {
    if (instances.component != "top") continue;
    for (const Vec3 position : instances.mesh->positions)
      widest = std::max(widest, glm::length(Vec2(position.x, position.z)));
  }
  EXPECT_NEAR(widest, 0.03, 0.0005);
}

TEST(Tree, LinksWithKeysDrawPlacesOfTheirOwn) {
  GraphBuilder builder = trunk({{"count", 20}}).component("one", "simple").component("two", "simple");
  builder.link("trunk", "one", LinkKind::branch, {{"angle", 50}})
      .link("trunk", "two", LinkKind::branch, {{"angle", 50}});
  const Plant plant = builder.grow();
  const std::vector<Organ> one = organs_of(plant, "one"), two = organs_of(plant, "two");
  ASSERT_EQ(one.size(), two.size());
  EXPECT_NE(one[0].frame.origin, two[0].frame.origin);
}

TEST(Tree, TooManyBranchesOfItsOwnAreStoppedAtTheTree) {
  GraphBuilder builder = trunk({{"count", 1e9}}).component("cone", "simple");
  const std::vector<Diagnostic> errors = errors_of([&] { builder.link("trunk", "cone", LinkKind::branch).grow(); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].text(),
            "components.trunk.count: 1000000000 children are too many; expected at most 20000000 (limits.instances)");
}

TEST(Tree, TooManyNodesAreStoppedAndNamed) {
  // Ten trunks with eleven nodes each.
  auto builder =
      GraphBuilder(builtin_components()).component("view", "camera").component("star", "hydra", {{"number", 10}});
  builder.component("trunk", "tree", {{"segments", 10}}).link("view", "star").link("star", "trunk");
  EXPECT_EQ(builder.node_limit(110).grow().node_count(), 110U);
  for (const int threads : {1, 8}) {
    const ThreadLimit limit(threads);
    const std::vector<Diagnostic> errors = errors_of([&] { builder.node_limit(109).grow(); });
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].text(),
              "components.trunk: 110 skeleton nodes, of which trunk 110 (100 %), are too many; expected at most 109 "
              "(limits.nodes)");
  }
}

TEST(Tree, TooManyPixelsOfTexturesAreStoppedAndNamed) {
  const auto two = [](const char* colour) {
    const Value::Object texture{{"bark", "smooth"}, {"pixels", 16}};
    auto builder = trunk({{"texture", texture}, {"colour", "#808080"}});
    return builder.component("other", "tree", {{"texture", texture}, {"colour", colour}}).link("view", "other");
  };
  EXPECT_EQ(two("#405060").texture_limit(512).grow().materials.size(), 2U);
  EXPECT_EQ(two("#808080").texture_limit(256).grow().materials.size(), 2U);  // they share one
  const std::vector<Diagnostic> errors = errors_of([&] { two("#405060").texture_limit(511).grow(); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "components.other.texture");
  EXPECT_NE(errors[0].expected.find("limits.texture_pixels"), std::string::npos) << errors[0].text();
}

}  // namespace meristem::tree_test
