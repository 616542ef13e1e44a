// SPDX-License-Identifier: Apache-2.0
// Sample positions of pixels, as a function of pixel, sample and dimension alone, so a picture does not depend on
// threads. All pixels share one sequence. Each pixel uses a block of it, and neighbouring pixels use neighbouring
// blocks. Every pair of dimensions runs through the sequence in its own order. The samples of a pixel are therefore
// spread evenly, also the first 1, 2, 4, 8... of them. The samples of neighbours fill each other's gaps, so the
// remaining noise is a fine grain.
//
// Based on: B. Burley: Practical hash-based Owen scrambling (2020), of the sequence of I. Sobol; N. Vegdahl: Building a
// better LK hash (2021); A. Ahmed and P. Wonka: Screen-space blue-noise diffusion of Monte Carlo sampling error via
// hierarchical ordering of pixels (2020).
#pragma once

#include <cstdint>

#include "meristem/base/vec.h"

namespace meristem {

/// Returns 32 well-mixed bits.
constexpr std::uint32_t mixed_bits(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352dU;
  x ^= x >> 15;
  x *= 0x846ca68bU;
  return x ^ (x >> 16);
}

/// Returns the upper 24 bits as a number in [0, 1).
constexpr float unit_float(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24F; }

/// Returns the number of a pixel along a curve that keeps neighbours together: the bits of x and y (below 2^16) in
/// alternation.
std::uint32_t pixel_number(int x, int y);

/// The random numbers of one path: sample number `sample` of `samples` through the pixel with this number.
class SampleStream {
 public:
  SampleStream(std::uint32_t pixel, std::uint32_t sample, std::uint32_t samples);

  /// Returns the next two dimensions, each uniform in [0, 1).
  Vec2 next();

 private:
  std::uint32_t reversed_index_;
  std::uint32_t pair_ = 0;
};

/// Returns a point of the unit disc, uniform by area for uniform `sample`.
Vec2 disc_point(Vec2 sample);

/// Returns a direction about the unit vector `normal`, with density cosine / pi.
Vec3 cosine_direction(Vec3 normal, Vec2 sample);

/// Returns a uniform direction within `angle` (radians, small) of the unit vector `axis`.
Vec3 cone_direction(Vec3 axis, double angle, Vec2 sample);

/// Two unit vectors that make a right-handed frame with the unit vector `normal` (T. Duff and others, 2017).
struct Tangents {
  explicit Tangents(Vec3 normal);
  Vec3 x, z;
};

}  // namespace meristem
