// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/light/shadow_grid.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"

namespace meristem::shadow_grid_test {

constexpr float kVoxel = 0.5F;  // exact in binary, so that positions are exact

/// Returns the centre of the voxel at this offset from the origin's voxel.
Vec3 voxel(int x, int y, int z) {
  return kVoxel * (Vec3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)) + 0.5F);
}

ShadowParameters form(Vec3 toward_light = kUp) {
  return {.voxel = kVoxel, .amount = 0.25, .base = 2, .depth = 3, .toward_light = toward_light, .reach = 2};
}

/// Makes shaders within a few metres of `middle`.
std::vector<ShadeSource> crowd(int count, Vec3 middle) {
  const RandomKey key = RandomKey(5).child("crowd");
  std::vector<ShadeSource> shaders;
  for (int k = 0; k < count; ++k) {
    const auto at = [&](std::uint64_t i) {
      return static_cast<float>(8 * key.uniform(4 * static_cast<std::uint64_t>(k) + i) - 4);
    };
    shaders.push_back({middle + Vec3(at(0), at(1), at(2)), 0.1 + std::abs(at(3))});
  }
  return shaders;
}

/// Returns the sum over the cube of voxels with this half-width around the origin's voxel.
double sum_around(const ShadowGrid& grid, int half) {
  double sum = 0;
  for (int x = -half; x <= half; ++x) {
    for (int y = -half; y <= half; ++y) {
      for (int z = -half; z <= half; ++z) sum += grid.shade(voxel(x, y, z));
    }
  }
  return sum;
}

TEST(ShadowGrid, AShaderDarkensASquareOfEachLayerBelow) {
  ShadowGrid grid(form());
  grid.add(voxel(0, 0, 0));
  for (int q = 0; q <= 4; ++q) {
    for (int x = -5; x <= 5; ++x) {
      for (int z = -5; z <= 5; ++z) {
        const bool is_in = q <= 3 && std::abs(x) <= q && std::abs(z) <= q;
        EXPECT_EQ(grid.shade(voxel(x, -q, z)), is_in ? 0.25 / (1 << q) : 0) << x << ' ' << -q << ' ' << z;
      }
    }
  }
  EXPECT_EQ(grid.shade(voxel(0, 1, 0)), 0) << "above";
  // Layers of 1, 9, 25 and 49 voxels, each with half the shade of the previous one.
  EXPECT_DOUBLE_EQ(sum_around(grid, 6), 0.25 * (1 + 9 / 2.0 + 25 / 4.0 + 49 / 8.0));
}

TEST(ShadowGrid, WeightsScaleTheShade) {
  ShadowGrid grid(form());
  grid.add(voxel(2, 1, -7), 1.5);
  grid.add(voxel(2, 1, -7), 0.25);
  EXPECT_DOUBLE_EQ(grid.shade(voxel(2, 1, -7)), 1.75 * 0.25);
  EXPECT_DOUBLE_EQ(grid.shade(voxel(3, 0, -8)), 1.75 * 0.125);
}

TEST(ShadowGrid, DoesNotKnowTheOrderOfShaders) {
  const std::vector<ShadeSource> shaders = crowd(300, Vec3(0));
  ShadowGrid forward(form());
  for (const ShadeSource& shader : shaders) forward.add(shader.position, shader.weight);
  ShadowGrid backward(form());
  for (auto shader = shaders.rbegin(); shader != shaders.rend(); ++shader) {
    backward.add(shader->position, shader->weight);
  }
  EXPECT_EQ(forward.bytes(), backward.bytes());
  for (int x = -12; x <= 12; ++x) {
    for (int y = -12; y <= 12; ++y) {
      for (int z = -12; z <= 12; ++z) {
        ASSERT_EQ(forward.shade(voxel(x, y, z)), backward.shade(voxel(x, y, z)));
        ASSERT_EQ(forward.brighter_way(voxel(x, y, z)), backward.brighter_way(voxel(x, y, z)));
      }
    }
  }
}

TEST(ShadowGrid, RemovingIsTheExactInverse) {
  const std::vector<ShadeSource> stay = crowd(40, Vec3(0));
  const std::vector<ShadeSource> leave = crowd(500, Vec3(3));
  ShadowGrid before(form());
  for (const ShadeSource& shader : stay) before.add(shader.position, shader.weight);
  ShadowGrid after = before;
  for (const ShadeSource& shader : leave) after.add(shader.position, shader.weight);
  EXPECT_GT(after.bytes(), before.bytes());
  for (const ShadeSource& shader : leave) after.remove(shader.position, shader.weight);
  EXPECT_EQ(after.bytes(), before.bytes());
  for (int x = -16; x <= 16; ++x) {
    for (int y = -16; y <= 16; ++y) {
      for (int z = -16; z <= 16; ++z) ASSERT_EQ(after.shade(voxel(x, y, z)), before.shade(voxel(x, y, z)));
    }
  }
  for (const ShadeSource& shader : stay) after.remove(shader.position, shader.weight);
  EXPECT_TRUE(after.empty());
  EXPECT_EQ(after.bytes(), 0U);
}

TEST(ShadowGrid, LeansAwayFromTheLight) {
  // The sun is in the south (+z) at 45°: each layer is one voxel lower and one voxel farther north.
  const float root = std::sqrt(0.5F);
  ShadowGrid grid(form({0, root, root}));
  grid.add(voxel(0, 0, 0));
  for (int q = 0; q <= 3; ++q) {
    for (int x = -4; x <= 4; ++x) {
      for (int z = -8; z <= 4; ++z) {
        const bool is_in = std::abs(x) <= q && std::abs(z + q) <= q;
        EXPECT_EQ(grid.shade(voxel(x, -q, z)), is_in ? 0.25 / (1 << q) : 0) << x << ' ' << -q << ' ' << z;
      }
    }
  }
}

TEST(ShadowGrid, LayersLieAcrossLightFromTheHorizon) {
  ShadowGrid grid(form({1, 0, 0}));  // a rising sun: shade to the west
  grid.add(voxel(0, 0, 0));
  EXPECT_EQ(grid.shade(voxel(-2, 2, -2)), 0.0625);
  EXPECT_EQ(grid.shade(voxel(-2, -2, 2)), 0.0625);
  EXPECT_EQ(grid.shade(voxel(-1, 2, 0)), 0);
  EXPECT_EQ(grid.shade(voxel(1, 0, 0)), 0);
  EXPECT_DOUBLE_EQ(sum_around(grid, 6), 0.25 * (1 + 9 / 2.0 + 25 / 4.0 + 49 / 8.0));
}

TEST(ShadowGrid, TurnsWithTheLight) {
  // A quarter turn about the vertical maps x to z and z to -x.
  const double up = radians(40);
  const Vec3 light(static_cast<float>(0.6 * math::cos(up)), static_cast<float>(math::sin(up)),
                   static_cast<float>(-0.8 * math::cos(up)));
  ShadowGrid grid(form(light));
  ShadowGrid turned(form({-light.z, light.y, light.x}));
  const int places[][3] = {{0, 0, 0}, {1, 2, -3}, {-4, 1, 2}, {3, -2, 0}, {9, 5, 7}};
  for (const auto& [x, y, z] : places) {
    grid.add(voxel(x, y, z), 1 + x);
    turned.add(voxel(-z, y, x), 1 + x);
  }
  int shaded = 0;
  for (int x = -14; x <= 14; ++x) {
    for (int y = -8; y <= 8; ++y) {
      for (int z = -14; z <= 14; ++z) {
        ASSERT_EQ(grid.shade(voxel(x, y, z)), turned.shade(voxel(-z, y, x)));
        const Vec3 way = grid.brighter_way(voxel(x, y, z));
        ASSERT_LT(glm::distance(Vec3(-way.z, way.y, way.x), turned.brighter_way(voxel(-z, y, x))), 1e-6F);
        if (grid.shade(voxel(x, y, z)) > 0) ++shaded;
      }
    }
  }
  EXPECT_GT(shaded, 200);
}

TEST(ShadowGrid, TheBrighterWayLeadsOutOfTheShade) {
  ShadowGrid grid(form());
  EXPECT_EQ(grid.brighter_way(voxel(0, 0, 0)), Vec3(0)) << "there is no shade";
  grid.add(voxel(0, 0, 0));
  // Beside the pyramid, away from it. Above it, up. Inside, on its axis, away from the shader.
  EXPECT_GT(grid.brighter_way(voxel(3, -2, 0)).x, 0.5F);
  EXPECT_LT(grid.brighter_way(voxel(0, -2, -3)).z, -0.5F);
  EXPECT_GT(grid.brighter_way(voxel(0, 1, 0)).y, 0.5F);
  const Vec3 inside = grid.brighter_way(voxel(0, -2, 0));
  EXPECT_NEAR(inside.x, 0, 1e-12);
  EXPECT_NEAR(inside.z, 0, 1e-12);
  EXPECT_LT(inside.y, -0.1F);
  EXPECT_EQ(grid.brighter_way(voxel(0, 4, 0)), Vec3(0)) << "out of reach";
}

TEST(ShadowGrid, TheBrighterWayIsTheMeanOfNeighboursByTheirShade) {
  ShadowParameters alone = form();
  alone.depth = 0;
  alone.reach = 1;
  ShadowGrid grid(alone);
  grid.add(voxel(1, 0, 0), 3);
  grid.add(voxel(0, -1, 0), 1);
  EXPECT_LT(glm::distance(grid.brighter_way(voxel(0, 0, 0)), Vec3(-0.75F, 0.25F, 0)), 1e-6F);
  grid.add(voxel(-1, 0, 0), 3);
  grid.add(voxel(0, 1, 0), 1);
  EXPECT_EQ(grid.brighter_way(voxel(0, 0, 0)), Vec3(0)) << "as much on every side";
  EXPECT_EQ(grid.brighter_way(voxel(3, 0, 0)), Vec3(0));
  alone.reach = 2;
  ShadowGrid wider(alone);
  wider.add(voxel(1, 0, 0));
  EXPECT_EQ(wider.brighter_way(voxel(3, 0, 0)), Vec3(1, 0, 0));
}

TEST(ShadowGrid, IsTheSameFarFromTheOrigin) {
  ShadowGrid here(form());
  ShadowGrid there(form());
  const Vec3 far(-1048576, 524288, 2097152);  // a whole number of bricks away; floats have a resolution of 0.25 m there
  const int places[][3] = {{0, 0, 0}, {1, 2, -3}, {-4, 1, 2}};
  for (const auto& [x, y, z] : places) {
    here.add(voxel(x, y, z));
    there.add(voxel(x, y, z) + far);
  }
  EXPECT_EQ(here.bytes(), there.bytes());
  for (int x = -8; x <= 8; ++x) {
    for (int y = -8; y <= 8; ++y) {
      EXPECT_EQ(here.shade(voxel(x, y, 0)), there.shade(voxel(x, y, 0) + far));
      EXPECT_EQ(here.brighter_way(voxel(x, y, 0)), there.brighter_way(voxel(x, y, 0) + far));
    }
  }
}

TEST(ShadowGrid, TakesMemoryForShadeAlone) {
  ShadowGrid grid(form());
  EXPECT_EQ(grid.bytes(), 0U);
  grid.add(voxel(0, 0, 0));
  const std::size_t one = grid.bytes();
  grid.add(voxel(0, 0, 1'000'000));
  EXPECT_EQ(grid.bytes(), 2 * one);
  EXPECT_LE(one, 8U * 5000) << "at most eight bricks";
}

TEST(ShadowGrid, CastsNothingWithAnAmountOfZero) {
  ShadowParameters clear = form();
  clear.amount = 0;
  ShadowGrid grid(clear);
  grid.add(voxel(0, 0, 0));
  EXPECT_EQ(grid.shade(voxel(0, 0, 0)), 0);
  EXPECT_TRUE(grid.empty());
}

TEST(ShadowGrid, RefusesWhatIsNoPlaceOrWeight) {
  ShadowGrid grid(form());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(grid.add({0, nan, 0}), std::invalid_argument);
  EXPECT_THROW(grid.add({0, 0, 1e12F}), std::invalid_argument);
  EXPECT_THROW(grid.add(Vec3(0), nan), std::invalid_argument);
  EXPECT_THROW(grid.add(Vec3(0), 1e9), std::invalid_argument);
  EXPECT_THROW(grid.shade({nan, 0, 0}), std::invalid_argument);
  EXPECT_TRUE(grid.empty());
}

TEST(ShadowGrid, RefusesFormsOutOfRange) {
  const auto is_refused = [](void (*spoil)(ShadowParameters&)) {
    ShadowParameters spoilt = form();
    spoil(spoilt);
    try {
      const ShadowGrid grid(spoilt);
      return false;
    } catch (const std::invalid_argument&) {
      return true;
    }
  };
  EXPECT_FALSE(is_refused([](ShadowParameters&) {}));
  EXPECT_TRUE(is_refused([](ShadowParameters& f) { f.voxel = 0; }));
  EXPECT_TRUE(is_refused([](ShadowParameters& f) { f.amount = -1; }));
  EXPECT_TRUE(is_refused([](ShadowParameters& f) { f.base = 0.5; }));
  EXPECT_TRUE(is_refused([](ShadowParameters& f) { f.depth = 65; }));
  EXPECT_TRUE(is_refused([](ShadowParameters& f) { f.reach = 5; }));
  EXPECT_TRUE(is_refused([](ShadowParameters& f) { f.toward_light = {0, 0, 0}; }));
}

TEST(ShadowGrid, ManyAtOnceCastWhatTheyCastOneByOne) {
  // Some shaders share a voxel, and some are removed in the same call, on any number of threads.
  std::vector<ShadeSource> shaders = crowd(2000, Vec3(0));
  for (std::size_t k = 0; k < 500; ++k) shaders.push_back({shaders[k].position, -shaders[k].weight});
  for (std::size_t k = 500; k < 700; ++k) shaders.push_back(shaders[k]);
  ShadowGrid wanted(form());
  for (const ShadeSource& shader : shaders) wanted.add(shader.position, shader.weight);
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    ShadowGrid grid(form());
    grid.cast(shaders, Progress());
    EXPECT_EQ(grid.bytes(), wanted.bytes());
    for (const ShadeSource& shader : shaders) {
      ASSERT_EQ(grid.shade(shader.position), wanted.shade(shader.position));
      ASSERT_EQ(grid.brighter_way(shader.position), wanted.brighter_way(shader.position));
    }
  }
}

TEST(ShadowGrid, ManyPlacesAreAskedAsEachAlone) {
  ShadowGrid grid(form());
  std::vector<Vec3> places;
  for (const ShadeSource& shader : crowd(300, Vec3(0))) {
    grid.add(shader.position, shader.weight);
    places.push_back(shader.position);
    places.push_back(50.0F * shader.position);
  }
  std::vector<double> found(places.size());
  ShadowGrid::Recent recent;
  grid.shade(places, found, recent);
  for (std::size_t k = 0; k < places.size(); ++k) EXPECT_EQ(found[k], grid.shade(places[k]));
}

TEST(ShadowGrid, CastsNoMoreThanItMayHold) {
  const std::vector<ShadeSource> shaders = crowd(2000, Vec3(0));
  ShadowGrid whole(form());
  whole.cast(shaders, Progress());
  ShadowGrid enough(form());
  EXPECT_NO_THROW(enough.cast(shaders, Progress(), whole.bytes()));
  for (const int threads : {1, 8}) {
    const ThreadLimit limit(threads);
    ShadowGrid too_small(form());
    EXPECT_THROW(too_small.cast(shaders, Progress(), whole.bytes() - 1), ShadowGrid::TooMuchMemory);
  }
}

TEST(ShadowGrid, BricksComeAndGoInAnyOrder) {
  // Many distant bricks, so that lookups share probe sequences in the table.
  const RandomKey key(9);
  ShadowGrid grid(form());
  std::vector<Vec3> places;
  for (std::uint64_t k = 0; k < 600; ++k) places.push_back(200.0F * key.direction(k));
  for (const Vec3 position : places) grid.add(position);
  for (std::size_t k = 0; k < places.size(); k += 2) grid.remove(places[k]);
  ShadowGrid wanted(form());
  for (std::size_t k = 1; k < places.size(); k += 2) wanted.add(places[k]);
  EXPECT_EQ(grid.bytes(), wanted.bytes());
  for (const Vec3 position : places) ASSERT_EQ(grid.shade(position), wanted.shade(position));
  for (std::size_t k = 1; k < places.size(); k += 2) grid.remove(places[k]);
  EXPECT_TRUE(grid.empty());
}

}  // namespace meristem::shadow_grid_test
