// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "meristem/grow/stand.h"
#include "meristem/scene/shadow_grid.h"

namespace meristem {

/// The shade that the plants of a stand cast on each other and on themselves. What they cast in a round is felt from
/// the next one on. Growth models may each feel it in a grid of their own form; all plants cast on all grids.
class StandShade : public Commons {
 public:
  /// The grid of a form, the same one for equal forms; it stays where it is. Growth throws InputError at `path`, a
  /// document path, where the grid would take more than `most_bytes`. To be called before the first round.
  const ShadowGrid& grid(const ShadowForm& form, std::uint64_t most_bytes, std::string path);
  /// Whether anything feels shade; if not, casting it is lost work.
  bool is_felt() const { return !grids_.empty(); }

  /// A leafy shoot of `length` metres at a place (world space). A shoot as long as a voxel counts as one shader.
  void cast(Vec3 place, double length) { new_shoots_.push_back({place, length}); }

  void begin_round(Progress& progress) override;

 private:
  struct Shoot {
    Vec3 place{0};
    double length = 0;
  };
  struct Felt {
    ShadowGrid grid;
    std::uint64_t most_bytes = 0;
    std::string path;
  };
  void cast_new_shoots(Felt& felt, const Progress& progress) const;

  std::deque<Felt> grids_;
  std::vector<Shoot> new_shoots_;
};

}  // namespace meristem
