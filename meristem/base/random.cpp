// SPDX-License-Identifier: Apache-2.0
// Derives keys and random numbers with the counter-based generator Philox4x32-10 (source in random.h). The key is the
// stream and the counter is the index of the number.
#include "meristem/base/random.h"

#include <algorithm>
#include <cmath>

#include <Random123/philox.h>

#include "meristem/base/hash.h"
#include "meristem/base/math.h"

namespace meristem {

namespace {

std::array<std::uint32_t, 4> words(std::uint64_t key, std::uint64_t index) {
  return philox({static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index >> 32), 0, 0},
                {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)});
}

/// Returns the 53 high bits of two words as a number in [0, 1).
double unit_interval(std::uint32_t high, std::uint32_t low) {
  const std::uint64_t bits = (std::uint64_t{high} << 32 | low) >> 11;
  return static_cast<double>(bits) * 0x1p-53;
}

}  // namespace

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
  const r123::Philox4x32::ctr_type c = {{counter[0], counter[1], counter[2], counter[3]}};
  const r123::Philox4x32::key_type k = {{key[0], key[1]}};
  const auto out = r123::Philox4x32()(c, k);
  return {out[0], out[1], out[2], out[3]};
}

RandomKey RandomKey::child(std::string_view name) const { return child(hash64(name)); }

std::uint64_t RandomKey::mixed(std::uint64_t bits, std::uint64_t with) {
  // The last two counter words of Philox mark derived keys, so that a key never equals a number of its own stream.
  const auto out = philox({static_cast<std::uint32_t>(with), static_cast<std::uint32_t>(with >> 32), 1, 0},
                          {static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32)});
  return std::uint64_t{out[1]} << 32 | out[0];
}

double RandomKey::uniform(std::uint64_t index, unsigned lane) const {
  const auto w = words(bits_, index);
  return lane == 0 ? unit_interval(w[0], w[1]) : unit_interval(w[2], w[3]);
}

double RandomKey::normal(std::uint64_t index) const {
  const auto w = words(bits_, index);
  const double radius = std::sqrt(-2 * math::log(1 - unit_interval(w[0], w[1])));
  return radius * math::cos(2 * kPi * unit_interval(w[2], w[3]));
}

Vec3 RandomKey::direction(std::uint64_t index) const {
  const auto w = words(bits_, index);
  const double y = 2 * unit_interval(w[0], w[1]) - 1;
  const double azimuth = 2 * kPi * unit_interval(w[2], w[3]);
  const double ring = std::sqrt(std::max(0.0, 1 - y * y));
  return Vec3(ring * math::cos(azimuth), y, ring * math::sin(azimuth));
}

}  // namespace meristem
