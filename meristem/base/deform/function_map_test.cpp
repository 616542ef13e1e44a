// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/deform/function_map.h"

#include <cmath>

#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "tests/support/space_maps.h"

namespace meristem::function_map_test {

TEST(FunctionMap, WithoutFunctionsIsTheIdentity) { expect_identity(functions("", "", "")); }
TEST(FunctionMap, OfTheCoordinatesIsTheIdentity) { expect_identity(functions("x", "y", "z")); }

TEST(FunctionMap, OfLinearFunctionsIsTheirMatrix) {
  const FunctionMap map = functions("2*x - y + 0.5*z + 1", "0.25*x + y", "z - 3*y + x/4");
  const DMat3 matrix(DVec3(2, 0.25, 0.25), DVec3(-1, 1, -3), DVec3(0.5, 0, 1));
  for (const DVec3& point : scattered_points()) {
    const Mapped mapped = mapped_by(map, point);
    EXPECT_LT(glm::distance(mapped.point, matrix * point + DVec3(1, 0, 0)), 1e-14);
    EXPECT_EQ(mapped.jacobian, matrix);
  }
}

TEST(FunctionMap, ItsJacobianIsThatOfDifferences) {
  expect_jacobian_of_differences(functions("x*cos(20*y) - z*sin(20*y)", "y + 0.1*x*x", "x*sin(20*y) + z*cos(20*y)"));
  expect_jacobian_of_differences(functions("x + 0.3*noise(x, y, z)", "", "z*(1 + 0.2*y)"));
}

TEST(FunctionMap, AFunctionOfOneCoordinateLeavesTheOthers) {
  const Mapped mapped = mapped_by(functions("", "y^2", ""), {0.1, 3, 0.2});
  EXPECT_EQ(mapped.point, DVec3(0.1, 9, 0.2));
  EXPECT_EQ(mapped.jacobian, DMat3(DVec3(1, 0, 0), DVec3(0, 6, 0), DVec3(0, 0, 1)));
}

TEST(FunctionMap, ItsOtherVariablesAndChanceAreTheSameAtAllPoints) {
  const ExpressionNames names{{"x", "y", "z", "t"}, {}};
  const FunctionMap map({Expression::compile("x + t + rand()", names), std::nullopt, std::nullopt}, {40}, RandomKey(5));
  const double shift = mapped_by(map, {0, 0, 0}).point.x;
  EXPECT_GT(shift, 40);
  EXPECT_LT(shift, 41);
  for (const DVec3& point : scattered_points()) EXPECT_NEAR(mapped_by(map, point).point.x, point.x + shift, 1e-12);
}

TEST(FunctionMap, APointsPlaceInABatchDoesNotMatter) {
  expect_same_in_batches(functions("x + 0.1*y^2", "", "z*exp(x)"));
}

TEST(FunctionMap, HasANumberForAllThatItDependsOn) {
  const std::uint64_t own = fingerprint_of(functions("x + y", "", ""));
  EXPECT_EQ(own, fingerprint_of(functions("x+y", "", "")));
  EXPECT_NE(own, fingerprint_of(functions("", "x + y", "")));
  EXPECT_NE(own, fingerprint_of(functions("x - y", "", "")));
}

}  // namespace meristem::function_map_test
