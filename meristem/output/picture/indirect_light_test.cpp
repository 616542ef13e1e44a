// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/indirect_light.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "meristem/base/random.h"

namespace meristem::indirect_light_test {

constexpr int kWidth = 24;
constexpr float kAngle = 0.001F;

/// Returns what a ray sees of a level surface of this albedo, 10 m away, in even light.
Seen level_surface(Vec3 albedo, Vec3 light) {
  Seen seen;
  seen.sight = Sight::surface;
  seen.normal = kUp;
  seen.distance = 10;
  seen.albedo = albedo;
  seen.indirect = albedo * light;
  return seen;
}

/// Returns squares with samples from `seen`.
std::vector<IndirectLight> film(int samples, const std::function<Seen(int x, int y, int sample)>& seen) {
  std::vector<IndirectLight> squares(std::size_t{kWidth} * kWidth);
  for (int y = 0; y < kWidth; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      IndirectLight& square = squares[y * kWidth + x];
      for (int s = 0; s < samples; ++s) {
        square.add(seen(x, y, s));
      }
    }
  }
  return squares;
}

/// Returns a noisy factor with mean 1: 0 for most samples, and 4 for the others.
float chance(int x, int y, int sample) { return RandomKey(5).child(x).child(y).uniform(sample) < 0.25 ? 4 : 0; }

const PerLayer<Vec3>& at(const std::vector<PerLayer<Vec3>>& gathered, int x, int y) { return gathered[y * kWidth + x]; }

TEST(IndirectLight, WhatAlbedosHideIsFound) {
  const auto seen = [](int x, int y, int) {
    return level_surface((x + y) % 2 == 0 ? Vec3(0.1F, 0.5F, 0.2F) : Vec3(0.2F, 0.3F, 0.1F), {1, 2, 3});
  };
  for (const PerLayer<Vec3>& square : gathered_irradiance(film(8, seen), kWidth, kAngle)) {
    EXPECT_NEAR(square[0].r, 1, 1e-5);
    EXPECT_NEAR(square[0].g, 2, 1e-5);
    EXPECT_NEAR(square[0].b, 3, 1e-5);
    EXPECT_EQ(square[1], Vec3(0));
  }
}

TEST(IndirectLight, NoiseIsGatheredAway) {
  const auto seen = [](int x, int y, int s) { return level_surface(Vec3(0.3F), Vec3(chance(x, y, s))); };
  double squared = 0;
  const std::vector<PerLayer<Vec3>> gathered = gathered_irradiance(film(8, seen), kWidth, kAngle);
  for (const PerLayer<Vec3>& square : gathered) {
    squared += std::pow(square[0].g - 1, 2);
  }
  // A square alone has a standard deviation of 0.61.
  EXPECT_LT(std::sqrt(squared / static_cast<double>(gathered.size())), 0.12);
}

TEST(IndirectLight, SurfacesThatFaceAnotherWayLieDeeperOrAreBrighterGiveLittle) {
  const auto difference = [](const std::function<void(Seen&)>& change) {
    const auto seen = [&](int x, int, int) {
      Seen surface = level_surface(Vec3(0.3F), Vec3(x < kWidth / 2 ? 0 : 1));
      if (x < kWidth / 2) change(surface);
      return surface;
    };
    const std::vector<PerLayer<Vec3>> gathered = gathered_irradiance(film(8, seen), kWidth, kAngle);
    return at(gathered, kWidth / 2, 9)[0].g - at(gathered, kWidth / 2 - 1, 9)[0].g;
  };
  EXPECT_LT(difference([](Seen&) {}), 0.35F);
  EXPECT_GT(difference([](Seen& surface) { surface.normal = {1, 0, 0}; }), 0.8F);
  EXPECT_GT(difference([](Seen& surface) { surface.distance = 11; }), 0.75F);
  EXPECT_GT(difference([](Seen& surface) { surface.albedo = Vec3(0.05F); }), 0.7F);
}

TEST(IndirectLight, GroundAndWhatStandsOnItGatherByThemselves) {
  // Ground and objects are both visible in every square, as behind grass.
  const auto seen = [](int, int, int s) {
    Seen one = level_surface(Vec3(0.3F), Vec3(s % 2 == 0 ? 1 : 5));
    if (s % 2 == 0) one.sight = Sight::ground;
    return one;
  };
  for (const PerLayer<Vec3>& square : gathered_irradiance(film(8, seen), kWidth, kAngle)) {
    EXPECT_NEAR(square[0].g, 5, 1e-5);
    EXPECT_NEAR(square[1].g, 1, 1e-5);
  }
}

TEST(IndirectLight, ManySamplesSpeakForThemselves) {
  // The light changes from square to square.
  const auto found = [](int samples) {
    const auto seen = [](int x, int y, int) { return level_surface(Vec3(0.3F), Vec3((x + y) % 2 == 0 ? 0.5F : 1.5F)); };
    return at(gathered_irradiance(film(samples, seen), kWidth, kAngle), 12, 12)[0].g;
  };
  EXPECT_NEAR(found(4), 1, 0.1);
  EXPECT_NEAR(found(4096), 0.5, 0.01);
}

TEST(IndirectLight, NothingIsDark) {
  const auto seen = [](int, int, int) { return Seen(); };
  for (const PerLayer<Vec3>& square : gathered_irradiance(film(4, seen), kWidth, kAngle)) {
    EXPECT_EQ(square[0], Vec3(0));
    EXPECT_EQ(square[1], Vec3(0));
  }
}

}  // namespace meristem::indirect_light_test
