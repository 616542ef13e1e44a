// SPDX-License-Identifier: Apache-2.0
// Updates shade grids and marker fields from the changes of a round, and shares out markers.
#include "meristem/grow/stand_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "meristem/base/limits.h"
#include "meristem/base/parallel.h"

namespace meristem {

namespace {

constexpr std::size_t kShootsPerCheck = 16;
constexpr double kLongestShoot = 1e5;  // voxels; longer shoots cast no additional shade

[[noreturn]] void refuse_bytes(const char* what, std::uint64_t bytes, std::uint64_t max, const std::string& path) {
  throw_limit(what, static_cast<double>(bytes), max, "mesh_bytes", path);
}

}  // namespace

const ShadowGrid& StandSpace::shade(const ShadowParameters& form, std::uint64_t max_bytes, std::string path) {
  const auto found = std::ranges::find_if(grids_, [&](const Grid& felt) { return felt.grid.form() == form; });
  if (found != grids_.end()) return found->grid;
  return grids_.emplace_back(Grid{ShadowGrid(form), max_bytes, std::move(path)}).grid;
}

MarkerField& StandSpace::markers(const MarkerParameters& form, RandomKey key, const Obstacles& obstacles,
                                 RoomSeeker& seeker, std::uint64_t max_bytes, std::string path) {
  auto found = std::ranges::find_if(fields_, [&](const Field& felt) { return felt.field.form() == form; });
  if (found == fields_.end()) {
    fields_.emplace_back(Field{MarkerField(form, key, obstacles), {}, max_bytes, std::move(path)});
    found = std::prev(fields_.end());
  }
  found->seekers.push_back(&seeker);
  return found->field;
}

void StandSpace::take(ShootChanges& changes) {
  auto& shoots = changes_.shoots_;
  shoots.insert(shoots.end(), changes.shoots_.begin(), changes.shoots_.end());
  changes.shoots_.clear();
}

void StandSpace::begin_round(Progress& progress) {
  parallel_for(grids_.size() + fields_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (k < grids_.size()) {
        cast_shade(grids_[k], progress);
      } else {
        take_markers(fields_[k - grids_.size()], progress);
      }
    }
  });
  changes_.shoots_ = {};
  for (Field& field : fields_) share_out(field, progress);
}

void StandSpace::cast_shade(Grid& felt, const Progress& progress) const {
  std::vector<ShadeSource> shaders;
  shaders.reserve(changes_.shoots_.size());
  for (const ShootChanges::Shoot& shoot : changes_.shoots_) {
    // Ignore shoots too far away for a fine grid: their shade does not matter.
    if (!felt.grid.reaches(shoot.position)) continue;
    const double weight = std::min(shoot.length / felt.grid.form().voxel, kLongestShoot);
    shaders.push_back({shoot.position, shoot.is_lost ? -weight : weight});
  }
  progress.check();
  try {
    felt.grid.cast(shaders, progress, felt.max_bytes);
  } catch (const ShadowGrid::TooMuchMemory&) {
    refuse_bytes("bytes of shade", felt.max_bytes + 1, felt.max_bytes, felt.path);
  }
}

void StandSpace::take_markers(Field& felt, const Progress& progress) const {
  for (std::size_t k = 0; k < changes_.shoots_.size(); ++k) {
    if (k % kShootsPerCheck == 0) {
      progress.check();
      if (felt.field.bytes() > felt.max_bytes)
        refuse_bytes("bytes of markers", felt.field.bytes(), felt.max_bytes, felt.path);
    }
    if (!felt.field.reaches(changes_.shoots_[k].position)) continue;
    if (changes_.shoots_[k].is_lost) {
      felt.field.vacate(changes_.shoots_[k].position);
    } else {
      felt.field.occupy(changes_.shoots_[k].position);
    }
  }
}

/// Assigns the markers of a field to the searching buds of all plants.
void StandSpace::share_out(Field& felt, Progress& progress) {
  bool any_looks = false;
  for (RoomSeeker* const plant : felt.seekers) any_looks = plant->begin_round() || any_looks;
  if (!any_looks) return;
  std::vector<SpaceSeeker> seekers;
  std::vector<std::size_t> first{0};
  for (const RoomSeeker* plant : felt.seekers) {
    plant->list_seekers(seekers);
    first.push_back(seekers.size());
  }
  std::vector<BudRoom> rooms(seekers.size());
  try {
    felt.field.share_out(seekers, rooms, progress, felt.max_bytes);
  } catch (const MarkerField::TooMuchMemory&) {
    refuse_bytes("bytes of markers in a round", felt.max_bytes + 1, felt.max_bytes, felt.path);
  }
  for (std::size_t k = 0; k < felt.seekers.size(); ++k) {
    felt.seekers[k]->take_room(std::span(rooms).subspan(first[k], first[k + 1] - first[k]));
  }
}

}  // namespace meristem
