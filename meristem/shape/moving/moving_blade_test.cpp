// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/moving/moving_blade.h"

#include <gtest/gtest.h>

#include "meristem/shape/leaf/leaf_blade.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem::moving_blade_test {

Mesh blade_of(double length, double curl, int rows) {
  LeafBlade blade;
  blade.length = length;
  blade.width = 0.05;
  blade.curl = curl;
  blade.rows = rows;
  blade.across = 4;
  blade.petiole = 0.01;
  return make_leaf_blade(blade);
}

TEST(MovingBlade, OneThatIsCutAlikeIsItself) {
  const Mesh blade = blade_of(0.1, 0.4, 6);
  const auto made = as_model_is_cut(blade, blade);
  ASSERT_TRUE(made);
  ASSERT_EQ(made->vertex_count(), blade.vertex_count());
  for (std::size_t k = 0; k < blade.vertex_count(); ++k) {
    EXPECT_LT(glm::distance(made->positions[k], blade.positions[k]), 1e-5F);
  }
}

TEST(MovingBlade, ACoarserOneLendsItsSurface) {
  const Mesh coarse = blade_of(0.05, 0.6, 5), fine = blade_of(0.1, 0, 9);
  ASSERT_NE(coarse.vertex_count(), fine.vertex_count());
  const auto made = as_model_is_cut(coarse, fine);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->vertex_count(), fine.vertex_count());
  Box box, own;
  for (const Vec3 position : made->positions) box.add(position);
  for (const Vec3 position : coarse.positions) own.add(position);
  EXPECT_LT(glm::distance(box.low, own.low), 0.005F);
  EXPECT_LT(glm::distance(box.high, own.high), 0.005F);
}

TEST(MovingBlade, BodiesAreNoBlades) { EXPECT_FALSE(as_model_is_cut(make_cylinder(1, 1, 6), make_cylinder(1, 1, 9))); }

}  // namespace meristem::moving_blade_test
