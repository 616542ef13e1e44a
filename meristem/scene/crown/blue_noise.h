// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/scene/crown/crown_sampler.h"

namespace meristem {

/// Places points with a minimum distance. Groups of different density may follow each other in one space. Points of two
/// groups keep the smaller of the two groups' distances.
class BlueNoise {
 public:
  /// Appends `count` points of the sampler's crown to `points`. Returns false if the crown fills too little of its
  /// bounds. Needs about 10 trials per point. Cost: linear in the points.
  bool append(CrownSampler& sampler, std::uint64_t count, Progress& progress, std::vector<Vec3>& points);

 private:
  struct Kept {
    Vec3 point;
    float spacing;       // spacing of its group when it was placed
    std::uint32_t next;  // next point in the same bucket
  };

  void begin_group(double spacing, std::size_t expected);
  void insert(Vec3 point, float spacing);
  bool is_free(Vec3 point) const;
  std::size_t bucket(std::int64_t x, std::int64_t y, std::int64_t z) const;

  std::vector<Kept> kept_;            // in the order of the points
  std::vector<std::uint32_t> first_;  // one point of each bucket; kNone ends a chain
  double cell_size_ = 1;
  float present_spacing_ = 0;
};

}  // namespace meristem
