// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/revolution.h"

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"
#include "tests/support/check_mesh.h"

namespace meristem::revolution_test {

GraphBuilder one(const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  return builder.component("view", "camera").component("body", "revolution", parameters).link("view", "body");
}

Value pairs(std::initializer_list<std::pair<double, double>> points) {
  Value::List list;
  for (const auto& [x, y] : points) list.emplace_back(Value::List{x, y});
  return list;
}

TEST(RevolutionComponent, IsABodyAlsoByItsDefaults) {
  const Plant plant = one({}).grow();
  EXPECT_TRUE(check_mesh(*plant.prototypes.at(0).mesh));
}

TEST(RevolutionComponent, FlatBodiesHaveOneNormalPerFace) {
  const Plant plant = one({{"shading", "flat"}}).grow();
  const Mesh& mesh = *plant.prototypes.at(0).mesh;
  EXPECT_EQ(mesh.vertex_count(), 3 * mesh.triangle_count());
  for (const auto& [a, b, c] : mesh.triangles) {
    EXPECT_EQ(mesh.normals[a], mesh.normals[b]);
    EXPECT_EQ(mesh.normals[a], mesh.normals[c]);
  }
}

TEST(RevolutionComponent, ChildrenStandAtTheTip) {
  auto builder = one({{"silhouette", pairs({{0, 0.5}, {1, 1}, {0, 3}})}, {"kind", "linear"}});
  const Plant plant = builder.component("child", "simple").link("body", "child").grow();
  EXPECT_EQ(organs_of(plant, "child").at(0).frame.origin, Vec3(0, 3, 0));
}

TEST(RevolutionComponent, InstancesOfAllSizesShareOneMesh) {
  auto builder = one({{"frame", Value::Object{{"scale", Value::List{"1 + i", "rand(1, 2)", "1 + i"}}}}});
  for (int k = 0; k < 9; ++k) builder.link("view", "body");
  const Plant plant = builder.grow();
  EXPECT_EQ(plant.organs.size(), 10U);
  EXPECT_EQ(plant.prototypes.size(), 1U);
}

TEST(RevolutionComponent, AQuarterTurnIsAWedge) {
  const auto volume = [](double sweep) { return signed_volume(*one({{"sweep", sweep}}).grow().prototypes.at(0).mesh); };
  EXPECT_NEAR(volume(90) / volume(360), 0.25, 1e-5);
}

TEST(RevolutionComponent, FaultySilhouettesAreRejectedAtTheirPlace) {
  const auto path_of = [](const Value& silhouette) {
    const auto errors = errors_of([&] { one({{"silhouette", silhouette}}); });
    return errors.size() == 1 ? errors[0].path : "not one fault";
  };
  EXPECT_EQ(path_of(pairs({{1, 0}})), "components.body.silhouette");
  EXPECT_EQ(path_of(pairs({{0, 0}, {-1, 1}, {0, 2}})), "components.body.silhouette[1][0]");
  EXPECT_EQ(path_of(pairs({{0, 0}, {0, 2}})), "components.body.silhouette");
  EXPECT_EQ(path_of(pairs({{0, 0}, {1, 1}, {1, 1}, {0, 2}})), "components.body.silhouette[2]");
  EXPECT_EQ(path_of(pairs({{0, 2}, {1, 1}, {0, 0}})), "components.body.silhouette");
  EXPECT_EQ(errors_of([] { one({{"sweep", 0}}); }).at(0).path, "components.body.sweep");
  EXPECT_EQ(errors_of([] { one({{"segments", "2 + i"}}); }).at(0).path, "components.body.segments");
  EXPECT_EQ(errors_of([] { one({{"kind", "liner"}}); }).at(0).nearest, "linear");
}

}  // namespace meristem::revolution_test
