// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/mesh/coarsen.h"

#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>

#include "meristem/shape/leaf/leaf_blade.h"
#include "meristem/shape/leaf/needles.h"
#include "meristem/shape/mesh/even_order.h"
#include "meristem/shape/mesh/shading.h"
#include "meristem/shape/solid/primitives.h"
#include "tests/support/check_mesh.h"

namespace meristem::coarsen_test {

bool is_vertex_of(const Mesh& mesh, Vec3 position, Vec2 uv) {
  for (std::size_t k = 0; k < mesh.vertex_count(); ++k) {
    if (mesh.positions[k] == position && mesh.uvs[k] == uv) return true;
  }
  return false;
}

TEST(Coarsened, BladesKeepPlacesAndUvsOfWhatStays) {
  const Mesh blade = make_leaf_blade({.curl = 0.5, .rows = 8, .across = 4});
  for (const std::size_t triangles : {20, 8, 2}) {
    const Mesh coarse = coarsened(blade, triangles);
    EXPECT_LE(coarse.triangle_count(), triangles);
    EXPECT_TRUE(check_mesh(coarse, {.closed = false}));
    for (std::size_t k = 0; k < coarse.vertex_count(); ++k) {
      EXPECT_TRUE(is_vertex_of(blade, coarse.positions[k], coarse.uvs[k]));
    }
  }
}

TEST(Coarsened, AFlatBladeKeepsNineTenthsOfItsAreaInAQuarterOfItsTriangles) {
  const Mesh blade = make_leaf_blade({.rows = 10});
  EXPECT_GE(surface_area(coarsened(blade, blade.triangle_count() / 4)), 0.9 * surface_area(blade));
}

TEST(Coarsened, AStalkGoesBeforeItsBlade) {
  const LeafBlade bare{.length = 0.06, .width = 0.04, .rows = 3};
  LeafBlade stalked = bare;
  stalked.petiole = 0.025;
  stalked.petiole_radius = 0.0007;
  const Mesh coarse = coarsened(make_leaf_blade(stalked), 4);
  EXPECT_LE(coarse.triangle_count(), 4U);
  EXPECT_GE(surface_area(coarse), 0.7 * surface_area(make_leaf_blade(bare)));
}

TEST(Coarsened, FewerNeedlesAreWider) {
  const Mesh shoot = make_needles({.count = 80});
  const double area = surface_area(shoot);
  for (const std::size_t triangles : {80, 40}) {
    const Mesh coarse = coarsened(shoot, triangles);
    EXPECT_LE(coarse.triangle_count(), triangles);
    EXPECT_GE(coarse.triangle_count(), triangles * 9 / 10);
    EXPECT_NEAR(surface_area(coarse), area, 0.1 * area) << triangles;
  }
  EXPECT_NEAR(surface_area(coarsened(shoot, 20)), 0.5 * area, 0.1 * area) << "eight times as wide would be too much";
}

TEST(Coarsened, ClosedMeshesStayClosed) {
  const Mesh ball = make_sphere(0.1, 12);
  const Mesh coarse = coarsened(ball, ball.triangle_count() / 4);
  EXPECT_LE(coarse.triangle_count(), ball.triangle_count() / 4 + 2);
  EXPECT_TRUE(check_mesh(coarse, {.closed = true}));
}

TEST(Coarsened, FlatBodiesStayFlatAndClosed) {
  Progress progress;
  const Mesh ball = flat_shaded(make_sphere(0.1, 12), progress);
  const Mesh coarse = coarsened(ball, ball.triangle_count() / 4);
  EXPECT_LE(coarse.triangle_count(), ball.triangle_count() / 4 + 2);
  EXPECT_EQ(coarse.vertex_count(), 3 * coarse.triangle_count());
  EXPECT_TRUE(check_mesh(coarse, {.closed = true}));
}

TEST(Coarsened, WhatIsCoarseEnoughStaysAsItIs) {
  const Mesh blade = make_leaf_blade({});
  EXPECT_EQ(coarsened(blade, blade.triangle_count()).triangles, blade.triangles);
}

TEST(EvenOrder, EachBeginningIsSpreadEvenly) {
  constexpr std::size_t kCount = 4096;
  const std::vector<std::uint32_t> order = even_order(kCount, RandomKey(3));
  for (std::size_t shown = 4; shown <= kCount; shown *= 4) {
    // Exactly one index of each run is among the first ones.
    std::vector<int> of_run(shown, 0);
    for (std::size_t k = 0; k < shown; ++k) ++of_run[order[k] / (kCount / shown)];
    EXPECT_EQ(std::count(of_run.begin(), of_run.end(), 1), static_cast<std::ptrdiff_t>(shown));
  }
  // The chosen ones are not always the same of each pair: as many even as odd indices.
  const auto even = std::count_if(order.begin(), order.begin() + kCount / 2, [](auto k) { return k % 2 == 0; });
  EXPECT_NEAR(static_cast<double>(even), kCount / 4, 4 * 23);  // four standard deviations of a binomial distribution
}

/// Returns how often an item wins, computed for this item alone: its half of each group against the other half.
int rounds_of(std::uint64_t thing, std::size_t count, const RandomKey& key) {
  for (unsigned round = 0; (std::uint64_t{1} << round) < count; ++round) {
    const std::uint64_t pair = thing >> (round + 1);
    const bool is_alone = (2 * pair + 1) << round >= count;
    const bool later_wins = !is_alone && key.child(std::uint64_t{round}).uniform(pair) < 0.5;
    if (((thing >> round & 1) != 0) != later_wins) return static_cast<int>(round);
  }
  return 64;
}

TEST(EvenOrder, GoesByRoundsWonAndThenByLot) {
  const RandomKey key(5);
  for (const std::size_t count : {2U, 3U, 64U, 100U, 129U}) {
    const auto rank = [&](std::uint32_t thing) {
      return std::tuple(-rounds_of(thing, count, key), key.uniform(thing, 1), thing);
    };
    const std::vector<std::uint32_t> order = even_order(count, key);
    EXPECT_TRUE(std::ranges::is_sorted(order, {}, rank)) << count;
  }
}

TEST(EvenOrder, HasAllOfAnyCount) {
  for (std::uint32_t count = 0; count < 40; ++count) {
    std::vector<std::uint32_t> order = even_order(count, RandomKey(1));
    std::sort(order.begin(), order.end());
    ASSERT_EQ(order.size(), count);
    for (std::uint32_t k = 0; k < count; ++k) EXPECT_EQ(order[k], k);
  }
}

TEST(QuicklyCoarsened, ABladeHasTheTrianglesThatItMayAndMostOfItsArea) {
  const Mesh blade = make_leaf_blade({.curl = 0.5, .rows = 40, .across = 20});
  for (const std::size_t triangles : {200, 20, 6}) {
    const Mesh coarse = quickly_coarsened(blade, triangles);
    EXPECT_LE(coarse.triangle_count(), triangles);
    EXPECT_GE(coarse.triangle_count(), 2U);
    EXPECT_GE(surface_area(coarse), 0.5 * surface_area(blade)) << triangles;
    for (std::size_t k = 0; k < coarse.vertex_count(); ++k) {
      EXPECT_TRUE(is_vertex_of(blade, coarse.positions[k], coarse.uvs[k]));
    }
  }
}

TEST(QuicklyCoarsened, AStalkThatIsLeftOutDoesNotPullTheBlade) {
  const Mesh leaf =
      make_leaf_blade({.length = 1, .width = 0.6, .petiole = 0.5, .petiole_radius = 0.005, .rows = 40, .across = 20});
  const Mesh coarse = quickly_coarsened(leaf, 100);
  EXPECT_LE(coarse.triangle_count(), 100U);
  for (const Vec3& position : coarse.positions) EXPECT_GE(position.y, 0.499F);
}

TEST(QuicklyCoarsened, MeshesOfAnySizeBecomeCoarser) {
  const Mesh ball = make_sphere(1, 100);
  ASSERT_GT(ball.triangle_count(), 9000U);
  const Mesh coarse = quickly_coarsened(ball, 100);
  EXPECT_LE(coarse.triangle_count(), 100U);
  EXPECT_GE(surface_area(coarse), 0.5 * surface_area(ball));
}

TEST(QuicklyCoarsened, FewerNeedlesAreWider) {
  const Mesh shoot = make_needles({.count = 80});
  const Mesh coarse = quickly_coarsened(shoot, 80);
  EXPECT_LE(coarse.triangle_count(), 80U);
  EXPECT_NEAR(surface_area(coarse), surface_area(shoot), 0.1 * surface_area(shoot));
}

}  // namespace meristem::coarsen_test
