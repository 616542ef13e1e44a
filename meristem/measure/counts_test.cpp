// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/counts.h"

#include <memory>

#include <gtest/gtest.h>

#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem::counts_test {

TEST(Counts, AddUpStemsAndOrgans) {
  Plant plant;
  plant.materials.resize(1);
  // Two stems, one with a lateral.
  for (int i = 0; i < 2; ++i) {
    Stem stem;
    stem.parts[0].component = "tree";
    const NodeIndex base = stem.skeleton.add_node(kNoNode, {i, 0, 0}, 0);
    stem.skeleton.add_node(base, {i, 2, 0}, 0);
    if (i == 1) stem.skeleton.axis[stem.skeleton.add_node(base, {i, 1, 1}, 0)] = 1;
    stem.skeleton.radius.assign(stem.skeleton.node_count(), 0.1F);
    plant.stems.push_back(stem);
  }
  plant.prototypes = {{"fruit", 0, std::make_shared<const Mesh>(make_box({0.1F, 0.1F, 0.1F}))}};
  plant.organs.resize(3);
  plant.organs[2].frame.origin = {0, -0.5F, 0};

  Progress progress;
  const MeshScene scene = make_mesh_scene(plant, {}, progress);
  const PlantCounts counts = count(plant, scene);
  EXPECT_EQ(counts.nodes, 5U);
  EXPECT_EQ(counts.axes, 3U);
  EXPECT_EQ(counts.organs, 3U);
  EXPECT_EQ(counts.instances, 2U + 3U);
  EXPECT_EQ(counts.triangles, scene.triangle_count());
  // The height reaches from the lowest fruit to the end of the rounded tip.
  EXPECT_NEAR(counts.height, 0.5 + 2 + 0.1, 1e-6);
}

TEST(Counts, AnEmptyPlantHasNothing) {
  const PlantCounts counts = count({}, {});
  EXPECT_EQ(counts.nodes + counts.axes + counts.organs + counts.triangles + counts.instances, 0U);
  EXPECT_EQ(counts.height, 0);
}

}  // namespace meristem::counts_test
