// SPDX-License-Identifier: Apache-2.0
// Documents as scenes that move, against the documents at the times of the keys.
#include "meristem/document/grow_moving.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "meristem/document/grow.h"

namespace meristem::grow_moving_test {

Document read(const std::string& text) { return read_document(text, "d.json", builtin_components()); }

const std::string kFlower = R"j({"meristem": 1,
  "animation": {"length": 4, "keys": {
    "stem.length": [[0, 0.05], [4, 0.4]], "star.number": [[0, 0], [4, 5]], "petal.length": [[0, 0.01], [4, 0.08]]}},
  "components": {
    "stem": {"type": "tree", "length": 0.4, "radius": 0.006, "segments": 6},
    "star": {"type": "hydra", "number": 5, "angle": 60, "radius": 0.01},
    "petal": {"type": "leaf", "length": 0.08, "width": 0.04, "rows": 3, "across": 2}
  },
  "links": [["stem", "star"], ["star", "petal"]]})j";

const std::string kTree = R"j({"meristem": 1, "seed": 3,
  "animation": {"length": 4, "steps_per_second": 6, "unfold": 0.5},
  "components": {
    "tree": {"type": "colonize", "crown": {"ellipsoid": {"centre": [0, 1, 0], "radii": [0.5, 0.7, 0.5]}}, "points": 60,
             "step": 0.1, "influence": 0.7, "kill": 0.2},
    "leaf": {"type": "leaf", "length": 0.1, "width": 0.05, "rows": 2, "across": 2}
  },
  "links": [{"from": "tree", "to": "leaf", "kind": "branch", "density": 8}]})j";

const std::string kCrowned = R"j({"meristem": 1,
  "animation": {"length": 1, "keys": {"tree.length": [[0, 0.5], [1, 1]]}},
  "components": {
    "tree": {"type": "tree", "length": 1, "radius": 0.05, "segments": 4,
             "surface": {"style": "blend", "resolution": 20, "crown": {"diameter": 0.5, "resolution": 12}}}
  }})j";

/// The box of all that a moving scene shows at a key.
Box box_at(const MovingScene& moving, std::size_t key) {
  Box box;
  for (std::size_t k = 0; k < moving.motions.size(); ++k) {
    const MeshMotion& motion = moving.motions[k];
    const MeshInstances& instances = moving.scene.meshes[k];
    if (motion.kind == MeshMotion::Kind::shown && motion.shown_at != key) continue;
    const Mesh& mesh = motion.meshes.empty() ? *instances.mesh : *motion.meshes[key];
    const std::vector<Frame>& frames = motion.frames.empty() ? instances.frames : motion.frames[key];
    for (const Frame& frame : frames) {
      if (glm::determinant(frame.axes) == 0) continue;
      for (const auto& [a, b, c] : instances.mesh->triangles) {
        const Vec3 at_a = frame.point(mesh.positions[a]), at_b = frame.point(mesh.positions[b]);
        const Vec3 at_c = frame.point(mesh.positions[c]);
        // A triangle that has not appeared yet is a point at its base.
        if (glm::length(glm::cross(at_b - at_a, at_c - at_a)) < 1e-9F) continue;
        for (const Vec3 position : {at_a, at_b, at_c}) box.add(position);
      }
    }
  }
  return box;
}

void expect_the_document(const std::string& text, std::size_t keys) {
  const Document document = read(text);
  Progress progress;
  const MovingScene moving = grow_moving(document, progress, {.keys = keys});
  ASSERT_EQ(moving.times.size(), keys);
  for (std::size_t key = 1; key < keys; ++key) {
    const Box there = grow_document(document, progress, {.time = moving.times[key]}).meshes.bounds();
    const Box here = box_at(moving, key);
    const float size = glm::length(there.size());
    EXPECT_LT(glm::distance(here.low, there.low), 0.01F * size) << "at " << moving.times[key] << " s";
    EXPECT_LT(glm::distance(here.high, there.high), 0.01F * size) << "at " << moving.times[key] << " s";
  }
}

TEST(GrowMoving, CrownBodiesStayObjectsOfTheirOwn) {
  Progress progress;
  const MovingScene moving = grow_moving(read(kCrowned), progress, {.keys = 2});
  std::vector<std::string> objects;
  for (const MeshInstances& instances : moving.scene.meshes) objects.push_back(object_name(instances));
  EXPECT_NE(std::ranges::find(objects, "tree"), objects.end());
  EXPECT_NE(std::ranges::find(objects, "tree_crown"), objects.end());
}

TEST(GrowMoving, KeysAreTheDocumentAtTheirTimes) { expect_the_document(kFlower, 5); }

TEST(GrowMoving, GrowthIsTheDocumentAtItsTimes) { expect_the_document(kTree, 5); }

TEST(GrowMoving, PartsAreTheSameAtAllTimes) {
  Progress progress;
  const MovingScene moving = grow_moving(read(kFlower), progress, {.keys = 4});
  std::size_t petals = 0;
  for (std::size_t k = 0; k < moving.motions.size(); ++k) {
    EXPECT_NE(moving.motions[k].kind, MeshMotion::Kind::shown) << moving.scene.meshes[k].component;
    if (moving.scene.meshes[k].component == "petal") petals += moving.scene.meshes[k].frames.size();
  }
  EXPECT_EQ(petals, 5U);
}

TEST(GrowMoving, TheSameOnAnyThreads) {
  const auto grown = [](int threads) {
    const ThreadLimit limit(threads);
    Progress progress;
    return grow_moving(read(kTree), progress, {.keys = 3});
  };
  const MovingScene one = grown(1), three = grown(3);
  ASSERT_EQ(one.motions.size(), three.motions.size());
  for (std::size_t k = 0; k < one.motions.size(); ++k) {
    EXPECT_EQ(one.scene.meshes[k].mesh->positions, three.scene.meshes[k].mesh->positions);
    ASSERT_EQ(one.motions[k].meshes.size(), three.motions[k].meshes.size());
    for (std::size_t m = 0; m < one.motions[k].meshes.size(); ++m) {
      EXPECT_EQ(one.motions[k].meshes[m]->positions, three.motions[k].meshes[m]->positions);
    }
  }
}

TEST(GrowMoving, ADocumentWithoutAnAnimationIsRefused) {
  const std::string still = R"j({"meristem": 1, "components": {"b": {"type": "simple"}}})j";
  Progress progress;
  try {
    grow_moving(read(still), progress);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no animation"), std::string::npos);
  }
}

/// The fault of growing this so.
Diagnostic error_of(const Document& document, const MovingOptions& options) {
  Progress progress;
  try {
    grow_moving(document, progress, options);
  } catch (const InputError& error) {
    return error.diagnostics().at(0);
  }
  ADD_FAILURE() << "nothing is wrong";
  return {};
}

TEST(GrowMoving, FaultsHaveTheirPlace) {
  const Diagnostic motion = error_of(read(kTree), {.keys = 4, .limits = {.bytes = 1000}});
  EXPECT_EQ(motion.file, "d.json");
  EXPECT_EQ(motion.line, 2) << "where the animation is";
  Document meshes = read(kFlower);
  meshes.graph.limits.triangles = 5;
  const Diagnostic triangles = error_of(meshes, {.keys = 2});
  EXPECT_EQ(triangles.file, "d.json");
  EXPECT_GT(triangles.line, 3) << triangles.path;
}

}  // namespace meristem::grow_moving_test
