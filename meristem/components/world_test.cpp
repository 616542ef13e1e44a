// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/world.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "meristem/graph/batch.h"
#include "meristem/scene/crown/solid_crowns.h"
#include "tests/support/build_graph.h"

namespace meristem::world_test {

using Object = Value::Object;
using List = Value::List;

Value vector(double x, double y, double z) { return List{x, y, z}; }

/// A camera, a world, and a component `plant` below the world.
GraphBuilder in_world(const Object& world, const std::string& type, const Object& plant) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("world", "world", world).component("plant", type, plant);
  return builder.link("view", "world").link("world", "plant");
}

Object formula(const char* x, const char* y, const char* z) {
  return {{"formula", Object{{"x", x}, {"y", y}, {"z", z}}}};
}

const Skeleton& only_stem(const Plant& plant) { return plant.stems.at(0).skeleton; }

Vec3 heading_of(const Skeleton& stem, NodeIndex node) {
  return glm::normalize(stem.position[node] - stem.position[stem.parent[node]]);
}

TEST(World, InAUniformFieldAStemsAngleFallsGeometrically) {
  // At 90 degrees from the field, each section leaves the share (1 - 0.6)^(strength / 24) of the previous angle.
  for (const double strength : {1.0, 2.5}) {
    const Object gravity{{"uniform", vector(strength, 0, 0)}};
    const Plant plant =
        in_world({{"gravity", gravity}}, "tree", {{"gravitropism", 0.6}, {"segments", 24}, {"length", 2}}).grow();
    const Skeleton& stem = only_stem(plant);
    const double ratio = std::pow(0.4, strength / 24);
    for (NodeIndex node = 1; node <= 24; ++node) {
      const double angle = degrees(std::acos(std::clamp(heading_of(stem, node).x, -1.0F, 1.0F)));
      EXPECT_NEAR(angle, 90 * std::pow(ratio, node), 0.02) << node;
    }
  }
}

TEST(World, AUniformFieldLikeTheScenesOwnChangesNoByte) {
  GraphBuilder plain(builtin_components());
  const Object form{{"gravitropism", 0.6}, {"phototropism", -0.2}, {"curl", 30}, {"gnarl", 20}};
  plain.component("view", "camera").component("world", "hydra", {{"number", 1}, {"angle", 0}, {"radius", 0}});
  plain.component("plant", "tree", form).link("view", "world").link("world", "plant");
  const Object fields{{"gravity", Object{{"uniform", vector(0, -1, 0)}}},
                      {"light", Object{{"uniform", vector(0, 1, 0)}}}};
  const auto straight = in_world(fields, "tree", form).grow();
  const auto expressions =
      in_world({{"gravity", formula("0", "-1", "0")}, {"light", formula("0", "cos(0)", "0")}}, "tree", form).grow();
  EXPECT_EQ(hash_of(straight, "plant"), hash_of(expressions, "plant"));
  EXPECT_EQ(hash_of(straight, "plant"), hash_of(in_world({}, "tree", form).grow(), "plant"));
}

TEST(World, ACylinderKeepsTheStemOnItsSurface) {
  const Object pole{{"radius", 0.1}, {"edge", 0.05}};
  const Object world{{"gravity", Object{{"cylinder", pole}, {"strength", 12}}},
                     {"light", Object{{"uniform", vector(0, 8, 0)}}}};
  const Object stem{
      {"length", 6},          {"segments", 600},
      {"gravitropism", 0.98}, {"phototropism", 0.98},
      {"gnarl", 15},          {"gnarl_waves", 20},
      {"radius", 0.005},      {"frame", Object{{"translate", vector(0.35, 0, 0.1)}, {"rotate", vector(0, 0, 30)}}}};
  const Plant plant = in_world(world, "tree", stem).grow();
  const Skeleton& skeleton = only_stem(plant);
  EXPECT_GT(skeleton.position.back().y, 5);
  for (std::size_t node = 150; node < skeleton.node_count(); ++node) {
    const Vec3 at = skeleton.position[node];
    EXPECT_NEAR(std::sqrt(at.x * at.x + at.z * at.z), 0.1, 0.04) << node;
  }
}

TEST(World, TurnedWithThePlantItTurnsThePlant) {
  const Object world{
      {"gravity", formula("-z - 0.3", "0.2*y", "x*y")},
      {"light", Object{{"vortex", Object{{"point", vector(0.2, 0, 0)}, {"core", 0.3}}}, {"strength", 2}}},
      {"avoid", Object{{"body", Object{{"sphere", Object{{"centre", vector(0, 1, 0)}, {"radius", 0.4}}}}}}}};
  const Object stem{{"length", 3}, {"segments", 60}, {"gravitropism", 0.5}, {"phototropism", 0.4}, {"curl", 20}};
  const Plant plain = in_world(world, "tree", stem).grow();
  Object turned_world = world;
  turned_world.emplace_back("frame", Object{{"translate", vector(3, 1, -2)}, {"rotate", vector(20, 50, -70)}});
  const Plant turned = in_world(turned_world, "tree", stem).grow();
  InstanceTransform transform;
  transform.translate = {3, 1, -2};
  transform.rotate = {static_cast<float>(radians(20)), static_cast<float>(radians(50)),
                      static_cast<float>(radians(-70))};
  const Frame frame = transform.frame();
  const Skeleton& from = only_stem(plain);
  const Skeleton& to = only_stem(turned);
  ASSERT_EQ(from.node_count(), to.node_count());
  EXPECT_GT(glm::distance(from.position.back(), Vec3(0, 3, 0)), 0.5F);
  for (std::size_t node = 0; node < from.node_count(); ++node) {
    EXPECT_LT(glm::distance(frame.point(from.position[node]), to.position[node]), 5e-3F) << node;
  }
}

TEST(World, StemsGrowAroundTheBodyThatTheyAvoid) {
  const Object body{{"box", List{vector(-0.5, 0.6, -0.5), vector(0.5, 1.4, 0.5)}}};
  const BoxCrown box(Box{{-0.5F, 0.6F, -0.5F}, {0.5F, 1.4F, 0.5F}});
  for (const char* type : {"tree", "horn"}) {
    const Object form{{"length", 3},
                      {"segments", 150},
                      {"radius", 0.03},
                      {"frame", Object{{"translate", vector(0.05, 0, 0.1)}}},
                      {"gravitropism", -0.8}};
    const auto grown = [&](const Object& world) { return in_world(world, type, form).grow(); };
    const Plant through = grown({});
    EXPECT_LT(box.distance(only_stem(through).position[50]), 0);
    const Plant around = grown({{"avoid", Object{{"body", body}, {"reach", 0.2}}}});
    for (std::size_t node = 0; node < only_stem(around).node_count(); ++node) {
      EXPECT_GE(box.distance(only_stem(around).position[node]), only_stem(around).radius[node] - 1e-3) << type << node;
    }
    EXPECT_GT(only_stem(around).position.back().y, 1.5F) << type;  // it has grown past the body
  }
}

/// Returns the mean direction of one axis of all leaves of a plant.
Vec3 mean_of(const Plant& plant, std::string_view component, int column) {
  Vec3 sum(0);
  for (const Organ& organ : organs_of(plant, component)) sum += glm::normalize(organ.frame.axes[column]);
  return normalized_or(sum, Vec3(0));
}

TEST(World, LeavesTurnTheirFacesAndHeadings) {
  const Object world{{"light", Object{{"uniform", vector(0, 0, 1)}}},
                     {"gravity", Object{{"uniform", vector(-1, 0, 0)}}}};
  EXPECT_GT(mean_of(in_world(world, "leaf", {{"phototropism", 1}}).grow(), "plant", 2).z, 0.999F);
  EXPECT_LT(mean_of(in_world(world, "leaf", {{"gravitropism", 1}}).grow(), "plant", 1).x, -0.999F);
  auto placed = in_world(world, "tree", {{"length", 1}}).component("leaf", "leaf");
  placed.link("plant", "leaf", LinkKind::branch, {{"count", 20}, {"droop", 1}});
  EXPECT_LT(mean_of(placed.grow(), "leaf", 1).x, -0.999F);
  auto faced = in_world(world, "tree", {{"length", 1}}).component("leaf", "leaf");
  faced.link("plant", "leaf", LinkKind::branch, {{"count", 20}, {"face_light", 1}});
  EXPECT_GT(mean_of(faced.grow(), "leaf", 2).z, 0.999F);
}

TEST(World, GrammarsBendWhereItPulls) {
  const Object plant{{"grammar", "#axiom\nF F F F F F F F"}, {"steps", 1}, {"length", 0.2}, {"elasticity", 0.4}};
  const auto tip = [&](const Object& world) {
    return only_stem(in_world(world, "lsystem", plant).grow()).position.back();
  };
  EXPECT_GT(tip({{"gravity", Object{{"uniform", vector(1, 0, 0)}}}}).x, 0.6F);
  EXPECT_GT(tip({{"light", Object{{"uniform", vector(0, 0, 1)}}}}).z, 0.6F);
}

/// Returns how far a plant leans along x, compared with the plant without a world.
double lean_of(const Object& world, const std::string& type, const Object& form) {
  const auto middle = [](const Plant& plant) {
    double sum = 0;
    const Skeleton& skeleton = only_stem(plant);
    for (const Vec3 at : skeleton.position) sum += at.x;
    return sum / static_cast<double>(skeleton.node_count());
  };
  return middle(in_world(world, type, form).grow()) - middle(in_world({}, type, form).grow());
}

TEST(World, GrowthModelsLeanWithIt) {
  const Object wind{{"uniform", vector(1, 0, 0)}, {"strength", 0.8}, {"add", true}};
  const Object organize{{"iterations", 8}};
  EXPECT_GT(lean_of({{"light", wind}}, "organize", organize), 0.05);
  const Object crown{{"sphere", Object{{"centre", vector(0, 2, 0)}, {"radius", 1}}}};
  const Object colonize{{"crown", crown}, {"points", 300}, {"kill", 0.2}, {"influence", 0.8}};
  EXPECT_GT(lean_of({{"light", wind}}, "colonize", colonize), 0.01);
  EXPECT_GT(lean_of({{"gravity", wind}}, "colonize", colonize), 0.01);
}

TEST(World, NestedOnesAddReplaceAndEnd) {
  const Object east{{"gravity", Object{{"uniform", vector(1, 0, 0)}}}};
  const auto heading = [&](const Object& inner) {
    auto builder = in_world(east, "world", inner).component("leaf", "leaf", {{"gravitropism", 1}});
    return mean_of(builder.link("plant", "leaf").grow(), "leaf", 1);
  };
  EXPECT_LT(glm::distance(heading({}), Vec3(1, 0, 0)), 1e-5F);
  const Object south{{"uniform", vector(0, 0, 1)}};
  Object added = south;
  added.emplace_back("add", true);
  EXPECT_LT(glm::distance(heading({{"gravity", south}}), Vec3(0, 0, 1)), 1e-5F);
  EXPECT_LT(glm::distance(heading({{"gravity", added}}), glm::normalize(Vec3(1, 0, 1))), 1e-5F);
  EXPECT_LT(glm::distance(heading({{"off", true}}), Vec3(0, -1, 0)), 1e-5F);
}

TEST(World, TheSameBytesOnAnyNumberOfThreadsAndWithACache) {
  const Object world{{"light", Object{{"wind", Object{{"gusts", 0.7}, {"size", 0.5}}}, {"add", true}}},
                     {"gravity", formula("-y*z", "-1", "sin(90*x)")}};
  auto builder =
      in_world(world, "tree", {{"count", 60}, {"phototropism", 0.5}, {"gravitropism", 0.2}, {"segments", 20}});
  builder.component("twig", "tree", {{"length", 0.4}, {"gravitropism", 0.8}, {"segments", 9}, {"gnarl", 10}});
  builder.component("leaf", "leaf", {{"phototropism", 0.6}});
  builder.link("plant", "twig", LinkKind::branch).link("twig", "leaf", LinkKind::branch, {{"count", 6}});
  Scene scene;
  scene.fingerprint = 1;
  const std::string hash = hash_of(builder.grow(0, scene));
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(hash_of(builder.grow(0, scene)), hash) << threads;
  }
  Cache cache;
  EXPECT_EQ(hash_of(builder.grow(0, scene, &cache)), hash);
  builder.component("world", "world",
                    {{"light", Object{{"wind", Object{{"gusts", 0.6}, {"size", 0.5}}}, {"add", true}}}});
  EXPECT_EQ(hash_of(builder.grow(0, scene, &cache)), hash_of(builder.grow(0, scene)));
  EXPECT_EQ(cache.reuse<BatchResult>().reused, 1U);  // the camera
}

TEST(World, HornsOfOneFormAreToldApartWhereTheFieldDiffers) {
  auto builder = in_world({{"gravity", Object{{"toward", vector(0, 0, 0)}}}}, "hydra",
                          {{"number", 6}, {"angle", 90}, {"radius", 1}});
  builder.component("horn", "horn",
                    {{"section", "outline"},
                     {"outline", List{List{-1, -1}, List{1, -1}, List{0, 1}}},
                     {"gravitropism", 0.9},
                     {"frame", Object{{"rotate", vector(60, 0, 0)}}}});
  const Plant plant = builder.link("plant", "horn").grow();
  EXPECT_EQ(prototypes_of(plant, "horn").size(), 6U);
}

std::vector<Diagnostic> errors_in(const Object& world, const Object& plant = {{"gravitropism", 0.5}}) {
  return errors_of([&] { in_world(world, "tree", plant).grow(); });
}

void expect_error(const std::vector<Diagnostic>& errors, std::string_view path, std::string_view words) {
  ASSERT_FALSE(errors.empty()) << path;
  EXPECT_EQ(errors[0].path, path);
  EXPECT_NE(errors[0].message.find(words), std::string::npos) << errors[0].message;
}

TEST(World, BadFieldsAreToldWithTheirPlace) {
  expect_error(errors_in({{"gravity", formula("1/x", "0", "0")}}), "components.world.gravity.formula.x",
               "the x of the gravity field is inf at (0, 0, 0)");
  expect_error(errors_in({{"gravity", formula("-x", "0", "-z")}}), "components.world.gravity.formula",
               "the gravity field vanishes at (0, 0, 0)");
  expect_error(errors_in({{"light", formula("rand()", "0", "1")}}), "components.world.light.formula.x",
               "draws nothing");
  expect_error(errors_in({{"light", Object{{"uniform", vector(0, 0, 0)}}}}), "components.world.light.uniform",
               "no length");
  expect_error(errors_in({{"light", Object{{"wind", Object{{"direction", vector(0, 0, 0)}}}}}}),
               "components.world.light.wind.direction", "no length");
  expect_error(errors_in({{"light", Object{{"cylinder", Object{{"direction", vector(0, 0, 0)}}}}}}),
               "components.world.light.cylinder.direction", "no length");
  expect_error(errors_in({{"light", Object{{"swirl", 1}}}}), "components.world.light.swirl", "swirl");
  expect_error(errors_in({{"light", Object{{"uniform", vector(0, 1, 0)}, {"toward", vector(0, 1, 0)}}}}),
               "components.world.light", "");
  expect_error(errors_in({{"light", Object{{"strength", 2}}}}), "components.world.light", "");
  expect_error(errors_in({{"avoid", Object{{"reach", 2}}}}), "components.world.avoid", "");
  // A plant that does not query the field meets no error.
  EXPECT_TRUE(errors_in({{"gravity", formula("1/x", "0", "0")}}, {}).empty());
}

}  // namespace meristem::world_test
