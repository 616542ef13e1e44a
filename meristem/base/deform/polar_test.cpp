// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/deform/polar.h"

#include <cmath>

#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "meristem/base/frame.h"

namespace meristem::polar_test {

void expect_near(const DMat3& a, const DMat3& b, double tolerance) {
  for (int k = 0; k < 3; ++k) EXPECT_LT(glm::distance(a[k], b[k]), tolerance);
}

const DMat3 kTurn = exact_rotation(glm::normalize(DVec3(1, 2, -0.5)), 1.9);

TEST(NearestRotation, OfTheIdentityIsTheIdentity) { EXPECT_EQ(nearest_rotation(DMat3(1)), DMat3(1)); }

TEST(NearestRotation, OfARotationIsThatRotation) { expect_near(nearest_rotation(kTurn), kTurn, 1e-15); }

TEST(NearestRotation, TakesEveryStretchAway) {
  for (const DVec3& stretch : {DVec3(2, 2, 2), DVec3(1, 5, 0.2), DVec3(1e-3, 1, 1e4), DVec3(1e-9, 1, 1)}) {
    const DMat3 turn = exact_rotation(glm::normalize(DVec3(0.3, -1, 2)), 0.8);
    const DMat3 along(DVec3(stretch.x, 0, 0), DVec3(0, stretch.y, 0), DVec3(0, 0, stretch.z));
    const DMat3 symmetric = turn * along * glm::transpose(turn);
    expect_near(nearest_rotation(kTurn * symmetric), kTurn, 1e-6);
  }
}

TEST(NearestRotation, IsARotationForAnyMatrixOfPositiveDeterminant) {
  const DMat3 shear(DVec3(1, 0.4, 0), DVec3(3, 1.3, 0.2), DVec3(-1, 0, 2));
  ASSERT_GT(glm::determinant(shear), 0);
  const DMat3 rotation = nearest_rotation(shear);
  expect_near(rotation * glm::transpose(rotation), DMat3(1), 1e-14);
  EXPECT_NEAR(glm::determinant(rotation), 1, 1e-14);
  // The rest, without the rotation, is symmetric.
  const DMat3 stretch = glm::transpose(rotation) * shear;
  expect_near(stretch, glm::transpose(stretch), 1e-13);
}

}  // namespace meristem::polar_test
