// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/stand_shade.h"

#include <algorithm>
#include <utility>

#include "meristem/base/limits.h"
#include "meristem/base/parallel.h"

namespace meristem {

namespace {

constexpr std::size_t kShootsPerCheck = 16;  // the deepest pyramids take a millisecond each

}  // namespace

const ShadowGrid& StandShade::grid(const ShadowForm& form, std::uint64_t most_bytes, std::string path) {
  const auto found =
      std::find_if(grids_.begin(), grids_.end(), [&](const Felt& felt) { return felt.grid.form() == form; });
  if (found != grids_.end()) return found->grid;
  return grids_.emplace_back(Felt{ShadowGrid(form), most_bytes, std::move(path)}).grid;
}

void StandShade::begin_round(Progress& progress) {
  parallel_for(grids_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) cast_new_shoots(grids_[k], progress);
  });
  new_shoots_.clear();
}

void StandShade::cast_new_shoots(Felt& felt, const Progress& progress) const {
  for (std::size_t k = 0; k < new_shoots_.size(); ++k) {
    if (k % kShootsPerCheck == 0) {
      progress.check();
      const std::size_t bytes = felt.grid.bytes();
      if (bytes > felt.most_bytes) {
        throw_limit("bytes of shade", static_cast<double>(bytes), felt.most_bytes, "mesh_bytes", felt.path);
      }
    }
    felt.grid.add(new_shoots_[k].place, new_shoots_[k].length / felt.grid.form().voxel);
  }
}

}  // namespace meristem
