// SPDX-License-Identifier: Apache-2.0
// Randomness by key instead of by state: every random number is a function of (seed, path or purpose, index), so it
// depends neither on the order of calls nor on threads, and a change in one place leaves all other places alone.
//
// Based on: Salmon, Moraes, Dror, Shaw: Parallel random numbers: as easy as 1, 2, 3 (SC 2011), Philox4x32-10.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "meristem/base/vec.h"

namespace meristem {

/// Names one stream of random numbers. Streams with different keys are independent; a key is cheap to copy and derive.
class RandomKey {
 public:
  /// The root stream of a document's seed.
  explicit RandomKey(std::uint64_t seed = 0) : bits_(mixed(seed, 0x6d65726973746d31U)) {}

  /// The stream of a purpose or path element below this one.
  RandomKey child(std::string_view name) const;
  RandomKey child(std::uint64_t index) const { return RandomKey(Raw{mixed(bits_, index)}); }

  /// Uniform in [0, 1), the `index`-th number of this stream; `lane` 0 or 1 gives two independent ones.
  double uniform(std::uint64_t index, unsigned lane = 0) const;
  /// Uniform in [low, high).
  double uniform(std::uint64_t index, double low, double high) const { return low + (high - low) * uniform(index); }
  /// Standard normal (mean 0, deviation 1), by Box and Muller on the two lanes of `index`.
  double normal(std::uint64_t index) const;
  /// Uniform on the unit sphere.
  Vec3 direction(std::uint64_t index) const;

  /// The key as one number, for caches and fingerprints.
  std::uint64_t bits() const { return bits_; }
  bool operator==(const RandomKey&) const = default;

 private:
  struct Raw {
    std::uint64_t bits;
  };
  explicit RandomKey(Raw raw) : bits_(raw.bits) {}
  static std::uint64_t mixed(std::uint64_t bits, std::uint64_t with);

  std::uint64_t bits_;
};

/// The raw generator: four random words from a 128-bit counter and a 64-bit key.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

}  // namespace meristem
