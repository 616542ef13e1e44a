// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/field/kept_out.h"

#include <cmath>

#include <gtest/gtest.h>

#include "meristem/scene/crown/solid_crowns.h"

namespace meristem::kept_out_test {

/// Returns the way of a stem that would grow straight without the body.
std::vector<Vec3> way_past(const KeptOut& body, Vec3 position, Vec3 heading, double step, int steps,
                           double radius = 0) {
  std::vector<Vec3> way{position};
  for (int k = 0; k < steps; ++k) {
    const Vec3 open = body.open_heading({position, heading, step, radius});
    EXPECT_NEAR(glm::length(open), 1, 1e-5);
    position += static_cast<float>(step) * open;
    way.push_back(position);
  }
  return way;
}

TEST(KeptOut, AConvexBodyIsNeverEntered) {
  const auto ball = std::make_shared<EllipsoidCrown>(Vec3(0), Vec3(1));
  const auto box = std::make_shared<BoxCrown>(Box{{-1, -1, -1}, {1, 1, 1}});
  for (const double reach : {0.05, 0.4, 3.0}) {
    for (const double step : {0.01, 0.2}) {
      for (const float aside : {0.0F, 0.02F, 0.6F}) {
        for (const Vec3 at : way_past(KeptOut(ball, Frame{}, reach), {-4, aside, 0}, {1, 0, 0}, step, 400)) {
          EXPECT_GE(glm::length(at), 1 - 1e-4);
        }
        for (const Vec3 at : way_past(KeptOut(box, Frame{}, reach), {-4, aside, 0}, {1, 0, 0}, step, 400)) {
          EXPECT_GE(box->distance(at), -1e-4);
        }
      }
    }
  }
}

TEST(KeptOut, TheDistanceFallsNoFasterThanItsExponential) {
  const auto wall = std::make_shared<BoxCrown>(Box{{0, -100, -100}, {1, 100, 100}});
  const double reach = 0.5, step = 0.01;
  const std::vector<Vec3> way = way_past(KeptOut(wall, Frame{}, reach), {-0.5F, 0, 0}, {1, 0, 0}, step, 100);
  for (std::size_t k = 1; k < way.size(); ++k) {
    EXPECT_NEAR(-way[k].x, 0.5 * std::pow(1 - step / reach, static_cast<double>(k)), 1e-4) << k;
  }
}

TEST(KeptOut, FarAwayNothingHappensAndTheStemPassesWithAllOfItsThickness) {
  const auto ball = std::make_shared<EllipsoidCrown>(Vec3(0), Vec3(1));
  const KeptOut body(ball, Frame{}, 0.3);
  const Vec3 slanted = glm::normalize(Vec3(1, 0.2F, 0));
  EXPECT_EQ(body.open_heading({{-4, 0, 0}, slanted, 0.01, 0}), slanted);
  EXPECT_EQ(body.open_heading({{-1.1F, 0, 0}, {-1, 0, 0}, 0.01, 0}), Vec3(-1, 0, 0));  // it leads away from the body
  for (const Vec3 at : way_past(body, {-4, 0.1F, 0}, {1, 0, 0}, 0.02, 400, 0.25)) EXPECT_GE(glm::length(at), 1.2499);
}

TEST(KeptOut, FromWithinItLeadsOut) {
  const auto ball = std::make_shared<EllipsoidCrown>(Vec3(0), Vec3(1));
  const std::vector<Vec3> way = way_past(KeptOut(ball, Frame{}, 0.2), {-0.5F, 0, 0}, {0, 1, 0}, 0.02, 200);
  EXPECT_GE(glm::length(way.back()), 1 - 1e-4);
}

TEST(KeptOut, ItsFrameTurnsMovesAndScalesTheBody) {
  const auto box = std::make_shared<BoxCrown>(Box{{0, 0, 0}, {1, 1, 1}});
  const KeptOut body(box, Frame{2.0F * rotation({0, 1, 0}, kPi / 2), {10, 0, 0}}, 0.1);
  EXPECT_EQ(body.open_heading({{0.5F, 0.5F, -0.05F}, {0, 0, 1}, 0.01, 0}), Vec3(0, 0, 1));
  // From (10, 0, 0), the box extends 2 m along y, -z and +x.
  const Vec3 aside = body.open_heading({{11, 1, 0.05F}, {0, 0, -1}, 0.01, 0});
  EXPECT_NEAR(aside.z, -0.5, 1e-3);
}

}  // namespace meristem::kept_out_test
