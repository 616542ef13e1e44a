// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/grow/metamer/metamers.h"
#include "meristem/plant/pipe_radii.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// The shoots that a tree has lost as it grew, shed or cut, for those who ask how it stood before.
class FallenShoots {
 public:
  /// Takes note of a metamer and all that it bears, which are about to be cut off in an iteration.
  void note(const Metamers& metamers, MetamerIndex first, int iteration);
  /// Metamers have been cleared away: those whose mark in `gone`, one per metamer, is not 0.
  void forget(const std::vector<std::uint8_t>& gone);

  /// The skeleton that these metamers have made, with the shoots that have fallen in the order in which all have come.
  /// They hang where they hung, by the angles that they had, with the pipe model's radii. The column `falls` (see
  /// growth_in_time.h) says in which iteration they went; their other columns but `metamer` and `bud_angle` are 0.
  Skeleton with_fallen(Skeleton standing, const PipeModel& model);

 private:
  struct Fallen {
    std::uint32_t number = 0;  // of all metamers, in the order in which they came
    std::uint32_t parent = 0;
    Vec3 internode{0};
    float birth = 0;
    float falls = 0;
    float on_axis = 0;  // its number there
    float bud_angle = 0;
    std::uint16_t order = 0;
    bool begins_axis = false;
  };

  void number_all(std::size_t count);

  std::vector<std::uint32_t> numbers_;  // of the metamers that stand
  std::uint32_t next_number_ = 0;
  std::vector<Fallen> fallen_;
};

}  // namespace meristem
