// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/stand_shade.h"

#include <algorithm>

#include "meristem/base/parallel.h"

namespace meristem {

namespace {

constexpr std::size_t kShootsPerCheck = 16;  // the deepest pyramids take a millisecond each

}  // namespace

const ShadowGrid& StandShade::grid(const ShadowForm& form) {
  const auto found =
      std::find_if(grids_.begin(), grids_.end(), [&](const ShadowGrid& grid) { return grid.form() == form; });
  return found != grids_.end() ? *found : grids_.emplace_back(form);
}

void StandShade::begin_round(Progress& progress) {
  parallel_for(grids_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      for (std::size_t s = 0; s < new_shoots_.size(); ++s) {
        if (s % kShootsPerCheck == 0) progress.check();
        grids_[k].add(new_shoots_[s].place, new_shoots_[s].length / grids_[k].form().voxel);
      }
    }
  });
  new_shoots_.clear();
}

}  // namespace meristem
