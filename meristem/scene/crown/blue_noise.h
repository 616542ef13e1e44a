// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/scene/crown/crown_sampler.h"

namespace meristem {

/// Points that keep their distance. Groups of different density may follow each other in one space: a point of one and
/// a point of another keep the smaller of their groups' distances.
class BlueNoise {
 public:
  /// Appends `count` points of the sampler's crown to `points`.
  /// Returns false if the crown fills too little of its bounds. About 10 trials a point, in time linear in the points.
  bool append(CrownSampler& sampler, std::uint64_t count, Progress& progress, std::vector<Vec3>& points);

 private:
  struct Kept {
    Vec3 point;
    float spacing;       // its group's, at the time
    std::uint32_t next;  // another of its bucket
  };

  void begin_group(double spacing, std::size_t expected);
  void insert(Vec3 point, float spacing);
  bool is_free(Vec3 point) const;
  std::size_t bucket(std::int64_t x, std::int64_t y, std::int64_t z) const;

  std::vector<Kept> kept_;            // in the order of the points
  std::vector<std::uint32_t> first_;  // of each bucket, one of them; kNone ends a chain
  double cell_size_ = 1;
  float present_spacing_ = 0;
};

}  // namespace meristem
