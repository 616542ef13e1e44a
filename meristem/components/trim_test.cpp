// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/trim.h"

#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/scene/mesh_scene.h"
#include "tests/support/build_graph.h"
#include "tests/support/check_mesh.h"
#include "tests/support/check_skeleton.h"

namespace meristem::trim_test {

Value box(double low, double high) { return Value::List{Value::List{-2, low, -2}, Value::List{2, high, 2}}; }

/// A pole 4 m high with eight horizontal branches, in a box 2.1 m high.
GraphBuilder pole(const Value& trim, double height = 2.1) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("body", "trim", {{"body", Value::Object{{"box", box(-1, height)}}}});
  builder.component("pole", "tree",
                    {{"length", 4}, {"radius", 0.1}, {"segments", 8}, {"count", 8}, {"angle", 90}, {"trim", trim}});
  builder.component("twig", "tree", {{"length", 0.5}, {"radius", 0.01}, {"trim", trim}});
  return builder.link("view", "body").link("body", "pole").link("pole", "twig", LinkKind::branch);
}

MeshScene clothed(const Plant& plant) {
  Progress progress;
  return make_mesh_scene(plant, {}, progress);
}

float highest(const Plant& plant) {
  float height = -1e9F;
  for (const Stem& stem : plant.stems) {
    for (const Vec3 position : stem.skeleton.position) height = std::max(height, position.y);
  }
  return height;
}

std::size_t axes_of(const Plant& plant) {
  std::size_t count = 0;
  for (const Stem& stem : plant.stems) count += SkeletonAxes(stem.skeleton).count();
  return count;
}

TEST(Trim, CutsStemsOffAtTheBoundaryAndWhatHangsBeyond) {
  const Plant whole = pole("none").grow();
  const Plant cut = pole("cut").grow();
  EXPECT_NEAR(highest(whole), 4, 1e-4);
  EXPECT_NEAR(highest(cut), 2.1, 1e-4);
  EXPECT_EQ(axes_of(whole), 9U);
  std::size_t below = 0;
  for (const Stem& stem : whole.stems) {
    const SkeletonAxes axes(stem.skeleton);
    for (AxisIndex axis = 1; axis < axes.count(); ++axis) {
      if (stem.skeleton.position[stem.skeleton.parent[axes.of(axis)[0]]].y < 2.1F) ++below;
    }
  }
  EXPECT_EQ(axes_of(cut), 1U + below);
  for (const Stem& stem : cut.stems) EXPECT_TRUE(check_skeleton(stem.skeleton));
}

TEST(Trim, BranchesOfACutStemAreThoseOfTheWholeOne) {
  const Skeleton whole = pole("none").grow().stems.at(0).skeleton;
  const Skeleton cut = pole("cut").grow().stems.at(0).skeleton;
  for (NodeIndex node = 0; node < cut.node_count(); ++node) {
    if (cut.axis[node] == 0) continue;
    EXPECT_TRUE(std::ranges::any_of(whole.position, [&](Vec3 at) {
      return glm::distance(at, cut.position[node]) < 1e-5F;
    })) << node;
  }
}

TEST(Trim, StemsThatFitTaperToTheBoundaryAndBearAllTheirBranches) {
  const Plant fit = pole("fit").grow();
  const Skeleton& stem = fit.stems.at(0).skeleton;
  ASSERT_TRUE(check_skeleton(stem));
  EXPECT_EQ(axes_of(fit), 9U);
  EXPECT_NEAR(highest(fit), 2.1, 0.02);
  const SkeletonAxes axes(stem);
  const NodeIndex tip = axes.of(0).back();
  EXPECT_NEAR(stem.position[tip].y, 2.1, 1e-3);
  // As thin at the tip as the whole stem is in proportion to its length.
  EXPECT_NEAR(stem.radius[tip], 0.015 * 2.1 / 4, 1e-6);
  EXPECT_NEAR(stem.radius[axes.of(0).front()], 0.1 * 2.1 / 4, 1e-6);
}

TEST(Trim, ChildrenOfAStemThatFitsStandOnItsThinnerBark) {
  GraphBuilder builder = pole("fit");
  builder.component("bead", "simple", {{"shape", "sphere"}, {"size", Value::List{0.001, 0.001, "radius"}}});
  builder.link("pole", "bead", LinkKind::branch);
  const Plant plant = builder.grow();
  const std::vector<Organ> beads = organs_of(plant, "bead");
  ASSERT_EQ(beads.size(), 8U);
  for (const Organ& bead : beads) {
    const Vec3 at = bead.frame.origin;
    const double u = at.y / 2.1;
    const double bark = 2.1 / 4 * (0.1 + u * (0.015 - 0.1));
    EXPECT_NEAR(glm::length(Vec2(at.x, at.z)), bark, 0.002) << u;
    EXPECT_NEAR(glm::length(bead.frame.axes[2]), bark, 0.002) << u;
  }
}

TEST(Trim, KeepsStemsInARing) {
  GraphBuilder builder(builtin_components());
  const Value::Object torus{{"centre", Value::List{0, 0, 0}}, {"radius", 1}, {"tube", 0.3}};
  builder.component("view", "camera").component("body", "trim", {{"body", Value::Object{{"torus", torus}}}});
  builder.component("star", "hydra", {{"number", 4}, {"angle", 90}, {"radius", 1}});
  builder.component("pole", "tree", {{"length", 4}}).link("view", "body").link("body", "star").link("star", "pole");
  const Plant plant = builder.grow();
  ASSERT_EQ(plant.stems.size(), 4U);
  for (const Stem& stem : plant.stems) {
    for (const Vec3 at : stem.skeleton.position) {
      const float ring = glm::length(Vec2(at.x, at.z)) - 1;
      EXPECT_LE(ring * ring + at.y * at.y, 0.3F * 0.3F + 1e-4F);
    }
  }
}

TEST(Trim, NoVertexLiesOutsideByMoreThanTheRadiusThere) {
  for (const char* mode : {"cut", "fit"}) {
    const MeshScene scene = clothed(pole(mode).grow());
    for (const MeshInstances& part : scene.meshes) {
      for (const Vec3 position : part.mesh->positions) EXPECT_LT(position.y, 2.1F + 0.1F + 1e-3F) << mode;
    }
  }
}

TEST(Trim, ACutStemHasAFlatEnd) {
  const MeshScene scene = clothed(pole("cut").grow());
  float height = 0;
  for (const MeshInstances& part : scene.meshes) {
    EXPECT_TRUE(check_mesh(*part.mesh));
    for (const Vec3 position : part.mesh->positions) {
      if (std::abs(position.x) < 0.12F && std::abs(position.z) < 0.12F) height = std::max(height, position.y);
    }
  }
  EXPECT_NEAR(height, 2.1F, 1e-3F);
}

TEST(Trim, StandsInItsFrameAndLiesWithinTheOneAbove) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("outer", "trim", {{"body", Value::Object{{"box", box(-1, 3)}}}});
  builder.component(
      "inner", "trim",
      {{"body", Value::Object{{"box", box(-1, 1)}}}, {"frame", Value::Object{{"translate", Value::List{0, 2.5, 0}}}}});
  builder.component("off", "trim", {{"off", true}});
  builder.component("pole", "tree", {{"length", 9}}).component("high", "tree", {{"length", 9}});
  builder.component("free", "tree", {{"length", 9}});
  builder.link("view", "outer").link("outer", "inner").link("inner", "high");
  builder.link("outer", "pole").link("outer", "off").link("off", "free");
  const Plant plant = builder.grow();
  const auto top = [&](std::string_view id) {
    for (const Stem& stem : plant.stems) {
      if (stem.parts[0].component == id) return stem.skeleton.position.back().y;
    }
    return -1.0F;
  };
  EXPECT_NEAR(top("pole"), 3, 1e-4);
  EXPECT_NEAR(top("high"), 3, 1e-4);  // the inner body ends at 3.5 m
  EXPECT_NEAR(top("free"), 9, 1e-4);
}

TEST(Trim, ChildrenAtTheTipOfACutStemAreGoneAndOfOneThatFitsStandAtItsEnd) {
  for (const char* mode : {"cut", "fit"}) {
    auto builder = pole(mode);
    builder.component("bud", "simple", {{"shape", "sphere"}}).link("pole", "bud");
    const std::vector<Organ> buds = organs_of(builder.grow(), "bud");
    if (std::string_view(mode) == "cut") {
      EXPECT_TRUE(buds.empty());
    } else {
      ASSERT_EQ(buds.size(), 1U);
      EXPECT_NEAR(buds[0].frame.origin.y, 2.1, 0.2);
    }
  }
}

TEST(Trim, TrimsHornsOfEverySection) {
  for (const char* section : {"ring", "box", "outline"}) {
    for (const char* mode : {"cut", "fit"}) {
      GraphBuilder builder(builtin_components());
      builder.component("view", "camera").component("body", "trim", {{"body", Value::Object{{"box", box(-1, 2)}}}});
      Value::Object horn{{"length", 4}, {"radius", 0.2}, {"section", section}, {"ribs", 40}, {"trim", mode}};
      if (std::string_view(section) == "outline") {
        horn.emplace_back("outline", Value::List{Value::List{-1, -1}, Value::List{1, -1}, Value::List{1, 1}});
      }
      builder.component("horn", "horn", horn).link("view", "body").link("body", "horn");
      const MeshScene scene = clothed(builder.grow());
      float height = 0;
      for (const MeshInstances& part : scene.meshes) {
        for (std::size_t k = 0; k < part.frames.size(); ++k) {
          for (const Vec3 position : part.mesh->positions) height = std::max(height, part.frames[k].point(position).y);
        }
      }
      EXPECT_NEAR(height, 2, 0.25) << section << mode;
    }
  }
}

TEST(Trim, TellsWhereNothingIsLeft) {
  const auto errors = errors_of([] { pole("cut", -0.5).grow(); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "components.pole");
  EXPECT_NE(errors[0].message.find("trimming leaves nothing"), std::string::npos);
}

TEST(Trim, SameBytesOnAnyNumberOfThreads) {
  const auto hash = [] {
    auto builder = pole("fit");
    builder.component("leaf", "leaf").link("twig", "leaf", LinkKind::branch, {{"count", 30}});
    return hash_of(builder.grow());
  };
  const std::string one = [&] {
    const ThreadLimit limit(1);
    return hash();
  }();
  for (const int threads : {2, 3, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(hash(), one);
  }
}

TEST(Trim, ABodyBesideOffHoldsAlone) {
  auto builder = pole("cut", 1);
  builder.component("alone", "trim", {{"off", true}, {"body", Value::Object{{"box", box(-1, 3)}}}});
  builder.component("high", "tree", {{"length", 9}});
  EXPECT_NEAR(highest(builder.link("body", "alone").link("alone", "high").grow()), 3, 1e-4);
}

TEST(Trim, RefusesABodyWithoutSizeAndATrimThatSaysNothing) {
  const auto error = [](const Value::Object& trim) {
    GraphBuilder builder(builtin_components());
    const auto errors = errors_of([&] { builder.component("body", "trim", trim); });
    return errors.empty() ? std::string() : errors[0].message;
  };
  EXPECT_NE(error({}), "");
  EXPECT_EQ(error({{"off", false}}), "a trim that is not off has no body");
  EXPECT_NE(error({{"body", Value::Object{{"box", box(2, 2)}}}}), "");
  EXPECT_EQ(error({{"body", Value::Object{{"half_space", Value::Object{{"point", Value::List{0, 1, 0}},
                                                                       {"normal", Value::List{0, 0, 0}}}}}}}),
            "the normal has no length");
}

}  // namespace meristem::trim_test
