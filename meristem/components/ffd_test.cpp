// SPDX-License-Identifier: Apache-2.0
// The effect of an ffd on its descendants, for all kinds of components.
#include "meristem/components/ffd.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/scene/mesh_scene.h"
#include "tests/support/build_graph.h"
#include "tests/support/check_mesh.h"
#include "tests/support/space_maps.h"

namespace meristem::ffd_test {

const Value::Object kBend{{"dx", "x + 0.1*y^2"}};
const Value::Object kShear{{"dx", "x + 0.5*y"}, {"dz", "2*z"}};

Value::Object on(const char* part, Value::Object parameters = kBend) {
  parameters.emplace_back("on", part);
  return parameters;
}

/// A stem of four metres with branches and leaves. If `ffd` has parameters, the stem is below an ffd.
GraphBuilder tree_under(const Value::Object& ffd, const Value::Object& surface = {}) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("wind", "ffd", ffd);
  builder.component("trunk", "tree", {{"length", 4}, {"radius", 0.1}, {"surface", surface}});
  builder.component("branch", "tree", {{"length", 1}, {"radius", 0.03}, {"surface", surface}});
  builder.component("leaf", "leaf", {{"length", 0.2}, {"width", 0.1}, {"curl", 0}});
  builder.link("view", "wind").link("wind", "trunk");
  builder.link("trunk", "branch", LinkKind::branch, {{"count", 6}});
  return builder.link("branch", "leaf", LinkKind::branch, {{"count", 8}});
}

Vec3 bent(Vec3 at) { return {at.x + 0.1F * at.y * at.y, at.y, at.z}; }

MeshScene clothed(const Plant& plant) {
  Progress progress;
  return make_mesh_scene(plant, {}, progress);
}

/// Returns all vertices of a scene in world space. Without leaves if the order of organs may differ.
std::vector<Vec3> vertices_of(const MeshScene& scene, bool with_leaves = true) {
  std::vector<Vec3> vertices;
  for (const MeshInstances& instances : scene.meshes) {
    if (instances.component == "leaf" && !with_leaves) continue;
    for (std::size_t k = 0; k < instances.count(); ++k) {
      for (const Vec3 position : instances.mesh->positions) vertices.push_back(instances.frame(k).point(position));
    }
  }
  return vertices;
}

float largest_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  EXPECT_EQ(a.size(), b.size());
  float largest = 0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) largest = std::max(largest, glm::distance(a[k], b[k]));
  return largest;
}

TEST(Ffd, WithoutFunctionsAndOfTheCoordinatesChangesNoByte) {
  const std::string plain = hash_of(tree_under({}).grow());
  EXPECT_EQ(hash_of(tree_under({{"dx", "x"}, {"dy", "y + 0"}, {"dz", "1*z"}}).grow()), plain);
  EXPECT_EQ(hash_of(tree_under(on("axes", {{"dx", "x"}})).grow()), plain);
  GraphBuilder alone = tree_under({});
  EXPECT_EQ(vertices_of(clothed(alone.grow())), vertices_of(clothed(tree_under({{"dx", "x"}}).grow())));
}

TEST(Ffd, OnAxesBendsStemsAndTurnsLeaves) {
  const Plant before = tree_under({}).grow();
  const Plant plant = tree_under(on("axes")).grow();
  ASSERT_EQ(plant.stems.size(), before.stems.size());
  const Skeleton& was = before.stems[0].skeleton;
  const Skeleton& is = plant.stems[0].skeleton;
  for (std::size_t k = 0; k < was.node_count(); ++k) {
    EXPECT_LT(glm::distance(is.position[k], bent(was.position[k])), 1e-5F);
  }
  EXPECT_EQ(is.radius, was.radius);
  EXPECT_EQ(plant.prototypes.size(), before.prototypes.size());
  for (std::size_t k = 0; k < plant.organs.size(); ++k) {
    const Frame& frame = plant.organs[k].frame;
    EXPECT_LT(glm::distance(frame.origin, bent(before.organs[k].frame.origin)), 1e-5F);
    const float length = glm::length(before.organs[k].frame.heading());
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(glm::length(frame.axes[axis]), length, 1e-5F);
  }
}

TEST(Ffd, OnGeometryTakesEveryVertexWhereItSays) {
  // With `error` 0, both stems have equal rings.
  const Value::Object surface{{"error", 0}};
  const MeshScene plain = clothed(tree_under({}, surface).grow());
  std::vector<Vec3> expected;
  for (const Vec3 vertex : vertices_of(plain, false)) expected.push_back(bent(vertex));
  const MeshScene scene = clothed(tree_under(on("geometry"), surface).grow());
  EXPECT_LT(largest_distance(vertices_of(scene, false), expected), 2e-6F);
  std::vector<Vec3> sheared;
  for (const Vec3 vertex : vertices_of(plain)) sheared.emplace_back(vertex.x + 0.5F * vertex.y, vertex.y, 2 * vertex.z);
  EXPECT_LT(largest_distance(vertices_of(clothed(tree_under(kShear, surface).grow())), sheared), 2e-5F);
}

TEST(Ffd, AStraightStemKeepsTheRingsThatItBendsAt) {
  const auto triangles = [](const Value::Object& ffd) {
    GraphBuilder builder(builtin_components());
    builder.component("view", "camera").component("wind", "ffd", ffd);
    builder.component("trunk", "tree", {{"length", 4}, {"radius", 0.1}, {"segments", 40}});
    return clothed(builder.link("view", "wind").link("wind", "trunk").grow()).triangle_count();
  };
  EXPECT_GT(triangles(on("geometry")), 2 * triangles({}));
  EXPECT_NEAR(static_cast<double>(triangles(on("geometry"))), static_cast<double>(triangles(on("axes"))),
              0.3 * static_cast<double>(triangles(on("axes"))));
}

TEST(Ffd, KeepsBodiesClosedAndTheVolumeThatItsDeterminantTells) {
  for (const Value::Object& surface : {Value::Object{{"error", 0}}, Value::Object{{"style", "blend"}}}) {
    const MeshScene plain = clothed(tree_under({}, surface).grow());
    const MeshScene scene = clothed(tree_under(on("geometry"), surface).grow());
    for (std::size_t k = 0; k < 2; ++k) {  // trunk and branches
      const Mesh& before = *plain.meshes[k].mesh;
      const Mesh& after = *scene.meshes[k].mesh;
      ASSERT_NE(scene.meshes[k].component, "leaf");
      EXPECT_EQ(euler_number(after), euler_number(before));
      EXPECT_NEAR(signed_volume(after), signed_volume(before), 0.02 * signed_volume(before));
    }
  }
}

TEST(Ffd, DeformsBlendedBodies) {
  const Value::Object surface{{"style", "blend"}, {"resolution", 60}};
  std::vector<Vec3> expected;
  for (const Vec3 vertex : vertices_of(clothed(tree_under({}, surface).grow()), false))
    expected.push_back(bent(vertex));
  const MeshScene scene = clothed(tree_under(on("geometry"), surface).grow());
  EXPECT_LT(largest_distance(vertices_of(scene, false), expected), 2e-6F);
}

TEST(Ffd, DeformsSurfacesThroughSections) {
  const auto grown = [](const Value::Object& ffd) {
    GraphBuilder builder(builtin_components());
    builder.component("view", "camera").component("wind", "ffd", ffd);
    const Value::Object up{{"translate", Value::List{0, 1, 0}}};
    for (const char* id : {"a", "b", "c"}) {
      builder.component(id, "simple", {{"shape", "tube"}, {"size", Value::List{0.4, 0.4, 0.4}}, {"frame", up}});
    }
    return builder.link("view", "wind").link("wind", "a").link("a", "b").link("b", "c").grow();
  };
  const std::vector<Vec3> before = vertices_of(clothed(grown({})));
  ASSERT_FALSE(before.empty());
  std::vector<Vec3> expected;
  for (const Vec3 vertex : before) expected.push_back(bent(vertex));
  EXPECT_LT(largest_distance(vertices_of(clothed(grown(on("geometry")))), expected), 1e-2F);
  // On axes, the cross-sections keep their shape: each ring is as wide as before.
  EXPECT_GT(largest_distance(vertices_of(clothed(grown(on("axes")))), before), 0.1F);
}

TEST(Ffd, StandsInItsOwnFrame) {
  GraphBuilder builder(builtin_components());
  const Value::Object lying{{"rotate", Value::List{90, 0, 0}}, {"translate", Value::List{0, 1, 0}}};
  builder.component("view", "camera").component("wind", "ffd", {{"dx", "x + 0.1*y^2"}, {"frame", lying}});
  builder.component("box", "simple", {{"frame", Value::Object{{"translate", Value::List{0, 2, 0}}}}});
  const std::vector<Organ> organs = organs_of(builder.link("view", "wind").link("wind", "box").grow(), "box");
  ASSERT_EQ(organs.size(), 1U);
  EXPECT_NEAR(organs[0].frame.origin.x, 0.4F, 1e-3F);  // an affine map moves the box
  EXPECT_NEAR(std::abs(organs[0].frame.origin.z), 2, 1e-5F);
  EXPECT_NEAR(organs[0].frame.origin.y, 1, 1e-5F);
}

TEST(Ffd, NestsWithTheInnerOneFirst) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera")
      .component("outer", "ffd", {{"dx", "2*x"}})
      .component("inner", "ffd", {{"dx", "x + 1"}});
  builder.component("box", "simple");
  builder.link("view", "outer").link("outer", "inner").link("inner", "box");
  EXPECT_NEAR(organs_of(builder.grow(), "box")[0].frame.origin.x, 2, 1e-6F);
}

TEST(Ffd, EachInstanceHasItsOwn) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("star", "hydra", {{"number", 3}, {"angle", 0}});
  builder.component("shift", "ffd", {{"dy", "y + i + t"}}).component("box", "simple");
  builder.link("view", "star").link("star", "shift").link("shift", "box");
  const std::vector<Organ> organs = organs_of(builder.grow(10), "box");
  ASSERT_EQ(organs.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(organs[k].frame.origin.y, 10 + static_cast<float>(k), 1e-5F);
  }
}

TEST(Ffd, OffLetsWhatHangsThereStandRigidly) {
  auto builder = tree_under(on("geometry"));
  builder.component("end", "ffd", {{"off", true}}).component("fruit", "simple");
  builder.link("trunk", "end").link("end", "fruit");
  auto plain = tree_under({});
  plain.component("end", "ffd").component("fruit", "simple").link("trunk", "end").link("end", "fruit");
  const Plant with = builder.grow(), without = plain.grow();
  const Organ found = organs_of(with, "fruit").at(0), was = organs_of(without, "fruit").at(0);
  EXPECT_EQ(prototypes_of(with, "fruit").size(), 1U);
  EXPECT_LT(glm::distance(found.frame.origin, bent(was.frame.origin)), 1e-5F);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(glm::length(found.frame.axes[axis]), glm::length(was.frame.axes[axis]), 1e-5F);
  EXPECT_GT(found.frame.heading().x, 0.3F * glm::length(found.frame.heading()));  // it leans with the tip of the trunk
}

TEST(Ffd, StandsAbovePlantsThatGrow) {
  const auto grown = [](const Value::Object& ffd) {
    GraphBuilder builder(builtin_components());
    builder.component("view", "camera").component("wind", "ffd", ffd);
    builder.component("oak", "organize", {{"iterations", 8}});
    return builder.link("view", "wind").link("wind", "oak").grow();
  };
  const Plant before = grown({}), plant = grown(on("axes"));
  ASSERT_EQ(plant.stems.size(), 1U);
  const Skeleton& was = before.stems[0].skeleton;
  ASSERT_EQ(plant.stems[0].skeleton.node_count(), was.node_count());
  for (std::size_t k = 0; k < was.node_count(); ++k) {
    EXPECT_LT(glm::distance(plant.stems[0].skeleton.position[k], bent(was.position[k])), 1e-4F);
  }
  // The tree remains the individual at this place.
  ASSERT_EQ(plant.individuals.size(), 1U);
  EXPECT_EQ(plant.individuals[0].component, "oak");
}

TEST(Ffd, MovesTheFeetOfPlants) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("hill", "ffd", {{"dy", "y + 0.5*x"}});
  builder.component("field", "field", {{"rows", 1}, {"plants", 4}}).component("box", "simple");
  builder.link("view", "hill").link("hill", "field").link("field", "box");
  const Plant plant = builder.grow();
  ASSERT_EQ(plant.individuals.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 foot = plant.individuals[k].foot;
    EXPECT_NEAR(foot.y, 0.5F * foot.x, 1e-6F);
  }
}

TEST(Ffd, HasTheSameBytesOnAnyNumberOfThreadsAndWithACache) {
  Scene scene;
  scene.fingerprint = 1;
  for (const char* part : {"axes", "geometry"}) {
    const std::string one = [&] {
      const ThreadLimit limit(1);
      return hash_of(tree_under(on(part)).grow());
    }();
    for (const int threads : {2, 3, 8}) {
      const ThreadLimit limit(threads);
      EXPECT_EQ(hash_of(tree_under(on(part)).grow()), one);
    }
    Cache cache;
    tree_under({}).grow(0, scene, &cache);
    EXPECT_EQ(hash_of(tree_under(on(part)).grow(0, scene, &cache)), one);
    EXPECT_EQ(hash_of(tree_under(on(part)).grow(0, scene, &cache)), one);
    EXPECT_EQ(hash_of(tree_under({}).grow(0, scene, &cache)), hash_of(tree_under({}).grow()));
  }
}

TEST(Ffd, ThatFoldsSpaceOverIsToldWhereAndForWhat) {
  for (const char* part : {"axes", "geometry"}) {
    const std::vector<Diagnostic> errors = errors_of([&] { tree_under(on(part, {{"dy", "y - 0.2*y^2"}})).grow(); });
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].path, "components.wind");
    EXPECT_NE(errors[0].message.find("folds space over where '"), std::string::npos) << errors[0].message;
    EXPECT_NE(errors[0].message.find("determinant"), std::string::npos);
  }
}

TEST(Ffd, RefusesWhatIsNoFunctionOfSpace) {
  const auto error = [](const Value& dx) {
    const auto errors = errors_of([&] { tree_under({{"dx", dx}}); });
    return errors.empty() ? Diagnostic{} : errors[0];
  };
  EXPECT_EQ(error("x + w").path, "components.wind.dx");
  EXPECT_NE(error("x + w").message.find("'w'"), std::string::npos);
  EXPECT_EQ(error(true).path, "components.wind.dx");
  const auto errors = errors_of([] { tree_under({{"dx", "x / (y - y)"}}).grow(); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].message.find("no finite value where 'trunk' stands at [0, 0, 0]"), std::string::npos)
      << errors[0].message;
}

}  // namespace meristem::ffd_test
