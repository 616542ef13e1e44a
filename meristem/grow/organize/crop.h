// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/grow/metamer/metamers.h"
#include "meristem/grow/metamer/resource.h"
#include "meristem/grow/organize/organize.h"

namespace meristem {

/// The fruits of a tree, one on a dormant lateral bud. Buds with enough resource flower in the next iteration. Fruits
/// take resource from the whole tree, so after a large crop few buds flower: trees bear every other year.
class Crop {
 public:
  /// Begins an iteration: the buds that were chosen in the previous iteration and are still dormant bear fruits.
  /// Further calls for the same iteration change nothing.
  void begin(const Metamers& metamers, int iteration);
  /// Returns the share of the tree's resource that the fruits take, 0 to 1. `whole` is the resource without fruits.
  double share_of(double whole, const FruitBearing& bearing) const;
  /// Chooses the buds that will bear in the next iteration, by their resource in this one.
  void choose(const Metamers& metamers, const ResourceFlow& flow, const FruitBearing& bearing, int iteration);
  /// Returns true if the lateral bud of a metamer bears a fruit in this iteration.
  bool bears(MetamerIndex metamer) const { return metamer < bears_.size() && bears_[metamer] != 0; }
  /// Updates the indices after Metamers::remove().
  void remove(const std::vector<std::uint8_t>& gone);
  /// Writes the column `fruit` of the tree's skeleton: 1 at metamers whose lateral bud bears.
  void write(Skeleton& skeleton) const;

 private:
  std::vector<std::uint8_t> bears_;   // by metamer
  std::vector<std::uint8_t> chosen_;  // by metamer, for the next iteration
  double fruits_ = 0;
  int iteration_ = 0;
};

}  // namespace meristem
