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
  /// Adds what a cut at a metamer's end took.
  void add(std::size_t metamers, MetamerIndex metamer, const OperationRecord& record);
  /// Follows Metamers::remove().
  void remove(const std::vector<std::uint8_t>& gone);
  /// Writes the columns of the tree's skeleton.
  void write(Skeleton& skeleton) const;

 private:
  struct Wound {
    float at = 0;  // iteration; 0: never
    float metamers = 0, length = 0, wood = 0, light = 0;
  };
  std::vector<Wound> wounds_;  // of the first metamers; the rest has none
};

}  // namespace meristem
