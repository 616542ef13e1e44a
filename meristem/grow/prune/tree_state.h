// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/random.h"
#include "meristem/grow/metamer/metamers.h"
#include "meristem/grow/metamer/resource.h"
#include "meristem/grow/prune/leads.h"
#include "meristem/plant/pipe_radii.h"

namespace meristem {

/// A tree as an operation sees it, after the growth of `iteration`. All referenced objects must outlive it.
struct TreeState {
  const Metamers& metamers;
  const TreeLeads& leads;
  const ResourceFlow& flow;  ///< at the begin of the iteration, without new metamers
  const PipeModel& radii;
  int iteration = 1;
  RandomKey key;          ///< of the operation in this iteration
  bool in_pairs = false;  ///< opposite buds: metamers come in pairs
  std::size_t marks = 0;  ///< number of different marks in the operation list
};

/// A chosen shoot.
struct Shoot {
  AxisIndex axis = 0;
  std::vector<MetamerIndex> path;  ///< from its base to its tip, without the seed
};

}  // namespace meristem
