// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/implicit/body_points.h"

#include <cmath>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "meristem/base/progress.h"

namespace meristem::body_points_test {

const RandomKey kKey = RandomKey(7).child("places");

ImplicitBody pear() {
  ImplicitBody body = ImplicitBody::sphere({10, 2, -5}, 1);
  body.blend(ImplicitBody::sphere({10, 3.4, -5}, 0.6), BlendKind::poly, 0.4);
  body.subtract(ImplicitBody::sphere({11, 2, -5}, 0.5));
  return body;
}

std::vector<BodyPoint> places(const ImplicitBody& body, BodyGrid grid, RandomKey key = kKey) {
  Progress progress;
  return places_in(body, grid, key, progress);
}

TEST(BodyPoints, FillABallAsDenselyAsAsked) {
  // 4.19 m³ at 1,000 points per cubic metre. A cell at the surface has a point with the probability of its share inside
  // the ball.
  const auto found = places(ImplicitBody::sphere({0, 0, 0}, 1), {.spacing = 0.1});
  EXPECT_NEAR(static_cast<double>(found.size()), 4188.8, 60);
}

TEST(BodyPoints, LieInTheBodyAndHeadOutOfIt) {
  const ImplicitBody body = pear();
  const auto found = places(body, {.spacing = 0.1});
  ASSERT_GT(found.size(), 1000U);
  for (const BodyPoint& place : found) {
    const double here = body.value(DVec3(place.position));
    EXPECT_LT(here, 1e-4);
    EXPECT_NEAR(glm::length(place.outward), 1, 1e-4);
    EXPECT_GT(body.value(DVec3(place.position + 0.01F * place.outward)), here);
  }
}

TEST(BodyPoints, AreThoseThatAllCellsByThemselvesWouldGive) {
  const ImplicitBody body = pear();
  const double spacing = 0.2;
  std::set<std::tuple<int, int, int>> cells;
  for (const BodyPoint& place : places(body, {.spacing = spacing})) {
    EXPECT_TRUE(cells.emplace(place.cell.x, place.cell.y, place.cell.z).second) << "one cell has two places";
    const DVec3 in_cell = DVec3(place.position) / spacing - DVec3(place.cell);
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(in_cell[k] > -1e-4 && in_cell[k] < 1 + 1e-4);
  }
  // Cells whose middle lies deep in the body always have a point, and cells far outside never have one.
  for (int x = 35; x < 65; ++x) {
    for (int y = 0; y < 25; ++y) {
      for (int z = -35; z < -15; ++z) {
        const double middle = body.value(spacing * (DVec3(x, y, z) + 0.5));
        if (std::abs(middle) > spacing) {
          EXPECT_EQ(cells.contains({x, y, z}), middle < 0);
        }
      }
    }
  }
}

TEST(BodyPoints, KeepToTheDepth) {
  const ImplicitBody body = ImplicitBody::sphere({0, 0, 0}, 1);
  const auto found = places(body, {.spacing = 0.1, .depth = 0.2});
  for (const BodyPoint& place : found) EXPECT_GT(body.value(DVec3(place.position)), -0.2 - 1e-4);
  const double shell = 4 * kPi / 3 * (1 - 0.8 * 0.8 * 0.8);
  EXPECT_NEAR(static_cast<double>(found.size()), 1000 * shell, 60);
}

TEST(BodyPoints, StayWhereTheBodyGrowsElsewhere) {
  ImplicitBody body = ImplicitBody::sphere({0, 0, 0}, 1);
  const auto before = places(body, {.spacing = 0.1});
  body.unite(ImplicitBody::sphere({5, 0, 0}, 1));
  const auto after = places(body, {.spacing = 0.1});
  std::set<std::tuple<float, float, float>> all;
  for (const BodyPoint& place : after) all.emplace(place.position.x, place.position.y, place.position.z);
  for (const BodyPoint& place : before) {
    EXPECT_TRUE(all.contains({place.position.x, place.position.y, place.position.z}));
  }
}

TEST(BodyPoints, StopOnePastTheMost) {
  EXPECT_EQ(places(ImplicitBody::sphere({0, 0, 0}, 1), {.spacing = 0.01, .max = 100}).size(), 101U);
}

TEST(BodyPoints, NothingHasNone) { EXPECT_TRUE(places(ImplicitBody(), {.spacing = 0.1}).empty()); }

}  // namespace meristem::body_points_test
