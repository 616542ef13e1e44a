// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/grow/metamer/metamers.h"
#include "meristem/plant/pipe_radii.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// The shoots that a tree has lost by shedding or cutting, to reconstruct earlier states.
class FallenShoots {
 public:
  /// Records a metamer and everything that it bears, before they are cut off in an iteration.
  void note(const Metamers& metamers, MetamerIndex first, int iteration);
  /// Updates the indices after metamers have been removed: those whose mark in `gone`, one per metamer, is not 0.
  void forget(const std::vector<std::uint8_t>& gone);

  /// Returns the skeleton of the current metamers together with the fallen shoots, in the order of birth. Fallen shoots
  /// are attached at their original places and angles, with radii of the pipe model. The column `falls` (see
  /// growth_in_time.h) has the iteration of the loss. Their other columns, except `metamer` and `bud_angle`, are 0.
  Skeleton with_fallen(Skeleton standing, const PipeModel& model);

 private:
  struct Fallen {
    std::uint32_t number = 0;  // number among all metamers, in the order of birth
    std::uint32_t parent = 0;
    Vec3 internode{0};
    float birth = 0;
    float falls = 0;
    float on_axis = 0;  // its number on the axis
    float bud_angle = 0;
    std::uint16_t order = 0;
    bool begins_axis = false;
  };

  void number_all(std::size_t count);

  std::vector<std::uint32_t> numbers_;  // of the standing metamers
  std::uint32_t next_number_ = 0;
  std::vector<Fallen> fallen_;
};

}  // namespace meristem
