// SPDX-License-Identifier: Apache-2.0
// Draws clouds as noise of several sizes on a plane one unit above. There is cloud where the noise exceeds a bound. A
// cloud is lit where it gets thinner toward the sun, which gives it a bright and a grey side. Clouds do not change the
// light of the sky on surfaces.
#include "meristem/output/picture/clouds.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/frame.h"
#include "meristem/base/noise.h"

namespace meristem {

namespace {

constexpr int kOctaves = 6;
constexpr double kSize = 0.9;     // size of the largest clouds, in heights of the layer
constexpr double kBillow = 0.35;  // how far small shapes displace large ones
constexpr double kEdge = 0.28;    // noise from the rim of a cloud to where it hides the sky
constexpr double kShadeDistance = 0.12;
constexpr float kLowest = 0.03F, kClear = 0.22F;  // heights of directions between which clouds emerge from the haze

double layered_noise(double x, double z) {
  static const RandomKey key = RandomKey(7).child("clouds");
  double sum = 0;
  double weight = 0.5;
  for (int octave = 0; octave < kOctaves; ++octave) {
    sum += weight * gradient_noise(key.child(static_cast<std::uint64_t>(octave)), x + 0.37, z + 0.61);
    x *= 2.03;
    z *= 2.03;
    weight *= 0.52;
  }
  return sum;
}

double smooth(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace

Clouds::Clouds(double share, Vec3 sun_direction, Vec3 lit, Vec3 shaded) : share_(share), lit_(lit), shaded_(shaded) {
  const Vec3 level = normalized_or(Vec3(sun_direction.x, 0, sun_direction.z), Vec3(0));
  to_sun_x_ = kShadeDistance * level.x;
  to_sun_z_ = kShadeDistance * level.z;
}

/// Returns the thickness of the clouds over a point of the layer: 0 for no cloud, 1 if they hide the sky.
double Clouds::thickness(double x, double z) const {
  const double aside = kBillow * layered_noise(2 * x + 11.3, 2 * z - 4.7);
  const double noise = 0.5 + layered_noise(x / kSize + aside, z / kSize - aside);
  const double bound = 1 - share_;
  return smooth(bound, bound + kEdge, noise);
}

Vec3 Clouds::over(Vec3 direction, Vec3 sky) const {
  if (share_ <= 0 || direction.y <= kLowest) return sky;
  const double x = direction.x / direction.y, z = direction.z / direction.y;
  const double here = thickness(x, z);
  if (here <= 0) return sky;
  const double toward_sun = thickness(x + to_sun_x_, z + to_sun_z_);
  const auto light = static_cast<float>(std::clamp(0.62 + 0.9 * (here - toward_sun) - 0.35 * here, 0.0, 1.0));
  const auto hidden = static_cast<float>(0.94 * here * smooth(kLowest, kClear, direction.y));
  return glm::mix(sky, glm::mix(shaded_, lit_, light), hidden);
}

}  // namespace meristem
