// SPDX-License-Identifier: Apache-2.0
// Where the samples of a pixel lie: well-spread points that are a function of pixel, sample and dimension alone, so a
// picture does not depend on threads. Every pair of dimensions takes the same low-discrepancy points, in its own order
// and shifted by its own offset.
//
// Based on: M. Roberts: The unreasonable effectiveness of quasirandom sequences (2018), the R2 sequence; A. Kensler:
// Correlated multi-jittered sampling (2013), the permutation; R. Cranley and T. Patterson (1976), the shift.
#pragma once

#include <cstdint>

#include "meristem/base/vec.h"

namespace meristem {

/// 32 well-mixed bits.
constexpr std::uint32_t mixed_bits(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352dU;
  x ^= x >> 15;
  x *= 0x846ca68bU;
  return x ^ (x >> 16);
}

/// The number in [0, 1) of the upper 24 bits.
constexpr float unit_float(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24F; }

/// The position of `index` in a permutation of [0, count) chosen by `seed`.
std::uint32_t permuted(std::uint32_t index, std::uint32_t count, std::uint32_t seed);

/// The numbers of one path: the `sample`-th of `samples` through `pixel`.
class SampleStream {
 public:
  SampleStream(std::uint32_t pixel, std::uint32_t sample, std::uint32_t samples)
      : seed_(mixed_bits(pixel + 0x9e3779b9U)), sample_(sample), samples_(samples) {}

  /// The next two dimensions, each uniform in [0, 1).
  Vec2 next();

 private:
  std::uint32_t seed_;
  std::uint32_t sample_;
  std::uint32_t samples_;
  std::uint32_t pair_ = 0;
};

/// A point of the unit disc, uniform by area for uniform `sample`.
Vec2 disc_point(Vec2 sample);

/// A direction about the unit vector `normal`, with density cosine / pi.
Vec3 cosine_direction(Vec3 normal, Vec2 sample);

/// A uniform direction within `angle` (radians, small) of the unit vector `axis`.
Vec3 cone_direction(Vec3 axis, double angle, Vec2 sample);

/// Two unit vectors that make a right-handed frame with the unit vector `normal` (T. Duff and others, 2017).
struct Tangents {
  explicit Tangents(Vec3 normal);
  Vec3 x, z;
};

}  // namespace meristem
