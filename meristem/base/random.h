// SPDX-License-Identifier: Apache-2.0
// Random numbers by key instead of by state. Every number is a function of (seed, path or purpose, index), so it does
// not depend on the order of calls or on threads. A change in one part of a plant leaves the random numbers of all
// other parts unchanged.
//
// Based on: Salmon, Moraes, Dror, Shaw: Parallel random numbers: as easy as 1, 2, 3 (SC 2011), Philox4x32-10.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "meristem/base/vec.h"

namespace meristem {

/// Names one stream of random numbers. Streams with different keys are independent. A key is cheap to copy and derive.
class RandomKey {
 public:
  /// The root stream of a document's seed.
  explicit RandomKey(std::uint64_t seed = 0) : bits_(mixed(seed, 0x6d65726973746d31U)) {}

  /// Returns the stream of a purpose or path element below this stream.
  RandomKey child(std::string_view name) const;
  RandomKey child(std::uint64_t index) const { return RandomKey(Raw{mixed(bits_, index)}); }

  /// Returns the `index`-th number of this stream, uniform in [0, 1). `lane` 0 and 1 give two independent numbers.
  double uniform(std::uint64_t index, unsigned lane = 0) const;
  /// Returns a number that is uniform from `low` to `high`. Rounding may return `high` itself if `low` is not 0.
  double uniform(std::uint64_t index, double low, double high) const { return low + (high - low) * uniform(index); }
  /// Returns a standard normal number (mean 0, standard deviation 1), by Box and Muller on the two lanes of `index`.
  double normal(std::uint64_t index) const;
  /// Returns a unit vector that is uniform on the sphere. It uses both lanes of `index`, so uniform(), normal() and
  /// direction() of one index are not independent.
  Vec3 direction(std::uint64_t index) const;

  /// Returns the key as one number, for caches and fingerprints.
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

/// Runs the raw generator: four random words from a 128-bit counter and a 64-bit key.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

}  // namespace meristem
