// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/detail/detail_budget.h"

#include <gtest/gtest.h>

#include "meristem/shape/solid/primitives.h"

namespace meristem::detail_budget_test {

constexpr int kLevels = 4;

/// Returns a pole of two nodes with leaves and beads. The leaves have 32 triangles and the size of the pole. The beads
/// have 180 triangles and are hardly visible.
Plant beaded_pole() {
  Plant plant;
  plant.materials.resize(1);
  Skeleton& pole = plant.stems.emplace_back().skeleton;
  pole.add_node(pole.add_node(kNoNode, Vec3(0), 0), Vec3(0, 1, 0), 0);
  pole.radius = {0.1F, 0.1F};
  plant.prototypes = {{"leaf", 0, std::make_shared<const Mesh>(make_sphere(0.2, 4))},
                      {"bead", 0, std::make_shared<const Mesh>(make_sphere(0.002, 10))}};
  for (std::uint32_t k = 0; k < 50; ++k) plant.organs.push_back({Frame{}, k % 2});
  return plant;
}

double triangles_of(const Plant& plant, std::uint32_t prototype) {
  return 25.0 * static_cast<double>(plant.prototypes[prototype].mesh->triangle_count());
}

TEST(DetailBudget, LevelZeroKeepsAll) {
  const Plant plant = beaded_pole();
  const DetailBudget budget(plant, {});
  EXPECT_EQ(budget.of_tubes(0), 1);
  EXPECT_EQ(budget.of_organs("bead", 0), 1);
}

TEST(DetailBudget, TrianglesGoWhereTheyAreSmallest) {
  const Plant plant = beaded_pole();
  const DetailBudget budget(plant, {1});
  EXPECT_EQ(budget.of_tubes(1), 1) << "few triangles cover the pole";
  EXPECT_EQ(budget.of_organs("leaf", 1), 1);
  EXPECT_LT(budget.of_organs("bead", 1), 0.2);
}

TEST(DetailBudget, AllTogetherKeepTheShareOfEachLevel) {
  const Plant plant = beaded_pole();
  const DetailBudget budget(plant, {kLevels});
  const double tubes = 2.0 * plant.stems[0].parts[0].surface.sides;
  const double all = tubes + triangles_of(plant, 0) + triangles_of(plant, 1);
  for (int level = 1; level <= kLevels; ++level) {
    const double kept = budget.of_tubes(level) * tubes + budget.of_organs("leaf", level) * triangles_of(plant, 0) +
                        budget.of_organs("bead", level) * triangles_of(plant, 1);
    EXPECT_NEAR(kept, MeshDetail{level}.kept() * all, 1e-6 * all) << level;
    EXPECT_LE(budget.of_tubes(level), budget.of_tubes(level - 1));
    EXPECT_LE(budget.of_organs("leaf", level), budget.of_organs("leaf", level - 1));
    EXPECT_LE(budget.of_organs("bead", level), budget.of_organs("bead", level - 1));
  }
}

TEST(DetailBudget, LargerInstancesCountByTheirSize) {
  Plant plant = beaded_pole();
  const double before = DetailBudget(plant, {1}).of_organs("bead", 1);
  for (Organ& organ : plant.organs) organ.frame.axes *= organ.prototype == 1 ? 200.0F : 1.0F;
  EXPECT_GT(DetailBudget(plant, {1}).of_organs("bead", 1), 1.3 * before);
}

TEST(DetailBudget, NothingIsDividedWhereThereIsNothing) {
  const Plant plant;
  EXPECT_EQ(DetailBudget(plant, {2}).of_tubes(2), 1);
}

}  // namespace meristem::detail_budget_test
