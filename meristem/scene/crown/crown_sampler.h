// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/scene/crown/crown.h"

namespace meristem {

/// A part of a crown: its upper part, its outer part, or the intersection of both.
struct CrownZone {
  double above = 0;  ///< share of the crown's height below the zone, in [0, 1)
  double outer = 1;  ///< share of the radius, at each height, that belongs to the zone, from outside, in (0, 1]
};

/// The points of a crown that lie in a zone. A point is in the outer part if it leaves the crown when its distance from
/// the axis is multiplied by 1 / (1 - outer).
class ZonedCrown : public Crown {
 public:
  ZonedCrown(const Crown& crown, CrownZone zone);  ///< `crown` must outlive this object
  bool contains(Vec3 point) const override;
  Box bounds() const override { return bounds_; }
  Vec2 axis() const override { return axis_; }

 private:
  const Crown& crown_;
  CrownZone zone_;
  Box bounds_;
  Vec2 axis_;
};

/// Returns true if a crown fills enough of its bounds (about 1/2000) to place points. Fast for crowns that fill more.
bool is_fillable(const Crown& crown);

/// Generates points uniform in a crown's volume. Trial j is a uniform point of the crown's bounds and a function of
/// (key, j) alone. The k-th point is the k-th trial that the crown contains.
class CrownSampler {
 public:
  /// `crown` must outlive this object.
  CrownSampler(const Crown& crown, RandomKey key);

  /// Appends the next `count` points. Trials run in parallel. The points depend neither on the number of threads nor on
  /// the counts of earlier calls. Returns false, with fewer points, if the crown fills too little of its bounds. Throws
  /// Cancelled.
  bool append(std::size_t count, Progress& progress, std::vector<Vec3>& points);
  /// Returns the volume of the crown in cubic metres, estimated from the trials so far. Returns 0 before the first
  /// trial.
  double volume() const;

 private:
  void make_trials(std::size_t count, Progress& progress);

  const Crown& crown_;
  Box box_;
  RandomKey plan_key_;
  RandomKey height_key_;
  std::uint64_t trials_ = 0;
  std::uint64_t accepted_ = 0;
  std::vector<Vec3> waiting_;  // accepted points that have not been returned yet
  std::size_t given_ = 0;      // number of points of `waiting_` that have been returned
};

}  // namespace meristem
