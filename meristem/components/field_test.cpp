// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/field.h"

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"

namespace meristem::field_test {

std::vector<Organ> plants_of(const Value::Object& field) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("field", "field", field).component("plant", "simple");
  builder.link("view", "field").link("field", "plant");
  return organs_of(builder.grow(), "plant");
}

TEST(Field, PlantsStandInRowsAboutItsMiddle) {
  const auto plants = plants_of({{"rows", 3}, {"plants", 4}, {"row_spacing", 2}, {"spacing", 0.5}, {"turned", false}});
  ASSERT_EQ(plants.size(), 12U);
  EXPECT_EQ(plants.front().frame.origin, Vec3(-0.75F, 0, -2));
  EXPECT_EQ(plants[1].frame.origin, Vec3(-0.25F, 0, -2));
  EXPECT_EQ(plants.back().frame.origin, Vec3(0.75F, 0, 2));
  for (const Organ& plant : plants) EXPECT_EQ(glm::normalize(plant.frame.heading()), kUp);
}

TEST(Field, PlantsAreOffByAtMostTheirScatter) {
  const Value::Object even{{"rows", 20}, {"plants", 20}, {"row_spacing", 1}, {"spacing", 0.5}};
  Value::Object scattered = even;
  scattered.emplace_back("scatter", 0.2);
  const auto before = plants_of(even), after = plants_of(scattered);
  float farthest = 0;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const Vec3 moved = glm::abs(after[k].frame.origin - before[k].frame.origin);
    EXPECT_LE(moved.x, 0.1F + 1e-6F);
    EXPECT_LE(moved.z, 0.2F + 1e-6F);
    farthest = std::max(farthest, moved.z);
  }
  EXPECT_GT(farthest, 0.18F);
}

TEST(Field, StaggeredRowsLieBetweenTheirNeighboursPlants) {
  const auto plants = plants_of({{"rows", 2}, {"plants", 2}, {"spacing", 1}, {"stagger", true}});
  EXPECT_NEAR(plants[2].frame.origin.x - plants[0].frame.origin.x, 0.5, 1e-6);
}

TEST(Field, GapsLeaveTheirShareOfPlacesEmpty) {
  const auto plants = plants_of({{"rows", 100}, {"plants", 100}, {"gaps", 0.1}});
  // Four standard deviations of 10,000 random numbers.
  EXPECT_NEAR(static_cast<double>(plants.size()), 9000, 4 * 30);
}

TEST(Field, TooManyPlantsAreAFaultBeforeTheirMemoryIsSpent) {
  const auto errors = errors_of([] { plants_of({{"rows", 100'000}, {"plants", 100'000}}); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].text().find("instances"), std::string::npos);
}

}  // namespace meristem::field_test
