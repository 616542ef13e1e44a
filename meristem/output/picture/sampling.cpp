// SPDX-License-Identifier: Apache-2.0
// Generates scrambled Sobol points in pairs of dimensions, and maps them to discs, cones and hemispheres (sources in
// the header).
#include "meristem/output/picture/sampling.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "meristem/base/math.h"

namespace meristem {

namespace {

/// The angles of disc_point come from a table, linear between entries. The error is below 2e-7, and it is four times
/// faster than sine and cosine.
constexpr int kDirections = 2048;

struct CircleTable {
  CircleTable() {
    for (int i = 0; i <= kDirections; ++i) {
      const double angle = 2 * kPi * i / kDirections;
      points[i] = Vec2(math::cos(angle), math::sin(angle));
    }
  }
  Vec2 points[kDirections + 1];
};

Vec2 circle_point(float turns) {
  static const CircleTable table;
  const float at = turns * kDirections;
  const int below = std::min(static_cast<int>(at), kDirections - 1);
  return glm::mix(table.points[below], table.points[below + 1], at - static_cast<float>(below));
}

constexpr std::uint32_t reversed_bits(std::uint32_t x) {
  x = (x & 0x55555555U) << 1 | (x >> 1 & 0x55555555U);
  x = (x & 0x33333333U) << 2 | (x >> 2 & 0x33333333U);
  x = (x & 0x0f0f0f0fU) << 4 | (x >> 4 & 0x0f0f0f0fU);
  return __builtin_bswap32(x);
}

/// Flips each bit at random, depending on the bits below it: Owen scrambling of a fraction with reversed bits.
constexpr std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeaU;
  x += seed;
  x *= seed >> 16 | 1;
  x ^= x * 0x05526c56U;
  return x ^ x * 0x53a22864U;
}

/// Returns Sobol's second dimension of an index, with its bits reversed. Its matrix is Pascal's triangle modulo 2: bit
/// j adds all bits whose number contains the bits of j.
constexpr std::uint32_t second_dimension(std::uint32_t x) {
  x ^= x >> 1 & 0x55555555U;
  x ^= x >> 2 & 0x33333333U;
  x ^= x >> 4 & 0x0f0f0f0fU;
  x ^= x >> 8 & 0x00ff00ffU;
  return x ^ x >> 16;
}

/// Returns the lower 16 bits at the even positions.
constexpr std::uint32_t spread_bits(std::uint32_t x) {
  x = (x | x << 8) & 0x00ff00ffU;
  x = (x | x << 4) & 0x0f0f0f0fU;
  x = (x | x << 2) & 0x33333333U;
  return (x | x << 1) & 0x55555555U;
}

}  // namespace

std::uint32_t pixel_number(int x, int y) {
  return spread_bits(static_cast<std::uint32_t>(x)) | spread_bits(static_cast<std::uint32_t>(y)) << 1;
}

SampleStream::SampleStream(std::uint32_t pixel, std::uint32_t sample, std::uint32_t samples)
    : reversed_index_(reversed_bits(pixel * std::bit_ceil(samples) + sample)) {}

Vec2 SampleStream::next() {
  const std::uint32_t seed = mixed_bits(0x9e3779b9U * ++pair_);
  // A different order of the sequence, in which blocks of 2^k indices stay blocks.
  const std::uint32_t index = reversed_bits(scrambled(reversed_index_, seed));
  // Sobol's first dimension is the index with reversed bits, and scrambling works on reversed bits.
  const std::uint32_t x = reversed_bits(scrambled(index, mixed_bits(seed ^ 0x68bc21ebU)));
  const std::uint32_t y = reversed_bits(scrambled(second_dimension(index), mixed_bits(seed ^ 0x02e5be93U)));
  return {unit_float(x), unit_float(y)};
}

Vec2 disc_point(Vec2 sample) { return std::sqrt(sample.x) * circle_point(sample.y); }

Vec3 cosine_direction(Vec3 normal, Vec2 sample) {
  const Vec2 flat = disc_point(sample);
  const float height = std::sqrt(std::max(0.0F, 1 - glm::dot(flat, flat)));
  const Tangents tangents(normal);
  return flat.x * tangents.x + flat.y * tangents.z + height * normal;
}

Vec3 cone_direction(Vec3 axis, double angle, Vec2 sample) {
  const Vec2 flat = static_cast<float>(angle) * disc_point(sample);
  const Tangents tangents(axis);
  return glm::normalize(axis + flat.x * tangents.x + flat.y * tangents.z);
}

Tangents::Tangents(Vec3 normal) {
  const float sign = std::copysign(1.0F, normal.z);
  const float a = -1 / (sign + normal.z);
  const float b = normal.x * normal.y * a;
  x = Vec3(1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
  z = Vec3(b, sign + normal.y * normal.y * a, -normal.y);
}

}  // namespace meristem
