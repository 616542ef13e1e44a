// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/grow/metamer/metamers.h"
#include "meristem/plant/operation_record.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// What was cut off at the ends of a tree's metamers, by metamer.
class CutWounds {
 public:
  /// Adds what a cut at a metamer's end took, through wood with this cross-section (square metres).
  void add(std::size_t metamers, MetamerIndex metamer, const OperationRecord& record, double section);
  /// Follows Metamers::remove().
  void remove(const std::vector<std::uint8_t>& gone);
  /// Lets wood swell about its cuts, as callus grows over them: the tree's skeleton, which has its radii, gains this
  /// share of the sections of all cuts, and toward the root half of it within kCallusReach radii. So stems that are cut
  /// back to the same place again and again grow heads.
  void swell(double callus, Skeleton& skeleton) const;
  static constexpr double kCallusReach = 2;
  /// Writes the columns of the tree's skeleton.
  void write(Skeleton& skeleton) const;

 private:
  struct Wound {
    float at = 0;  // iteration; 0: never
    float metamers = 0, length = 0, wood = 0, light = 0;
    double section = 0;  // square metres
  };
  std::vector<Wound> wounds_;  // of the first metamers; the rest has none
};

}  // namespace meristem
