// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/scene/crown_sampler.h"

namespace meristem {

/// Points that keep their distance. Groups of different density may follow each other in one space: a point of one and
/// a point of another keep the smaller of their groups' distances.
class BlueNoise {
 public:
  /// Appends `count` points of the sampler's crown to `points`, which holds those of the groups before and no others.
  /// Returns false if the crown fills too little of its bounds. About 10 trials a point, in time linear in the points.
  bool append(CrownSampler& sampler, std::uint64_t count, Progress& progress, std::vector<Vec3>& points);

 private:
  void begin_group(double spacing, std::size_t expected, const std::vector<Vec3>& points);
  void insert(std::uint32_t index, Vec3 point);
  bool is_free(Vec3 point, const std::vector<Vec3>& points) const;
  std::size_t bucket(std::int64_t x, std::int64_t y, std::int64_t z) const;
  std::int64_t cell(float coordinate) const;

  std::vector<float> spacing_;        // of each point: its group's, at the time
  std::vector<std::uint32_t> first_;  // of each bucket, a point; kNone ends a chain
  std::vector<std::uint32_t> next_;   // of each point, another of its bucket
  double cell_size_ = 1;
  float present_spacing_ = 0;
};

}  // namespace meristem
