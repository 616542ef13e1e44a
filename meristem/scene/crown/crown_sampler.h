// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/scene/crown/crown.h"

namespace meristem {

/// A part of a crown: its upper part, its outer part, or what is both.
struct CrownZone {
  double above = 0;  ///< share of the crown's height that lies below the zone, in [0, 1)
  double outer = 1;  ///< share of the radius at each height that the zone takes from outside, in (0, 1]
};

/// The points of a crown that lie in a zone. Outer are those that leave the crown when their distance from its axis is
/// stretched by 1 / (1 - outer).
class ZonedCrown : public Crown {
 public:
  ZonedCrown(const Crown& crown, CrownZone zone);  ///< `crown` must outlive it
  bool contains(Vec3 point) const override;
  Box bounds() const override { return bounds_; }
  Vec2 axis() const override { return axis_; }

 private:
  const Crown& crown_;
  CrownZone zone_;
  Box bounds_;
  Vec2 axis_;
};

/// Whether a crown fills enough of its bounds, about a two-thousandth, that points can be placed. Quick for crowns that
/// fill more.
bool is_fillable(const Crown& crown);

/// Points uniform in a crown's volume, one after another: the k-th is the k-th trial in the crown's bounds that the
/// crown contains, and the j-th trial is a function of (key, j) alone.
class CrownSampler {
 public:
  /// `crown` must outlive it.
  CrownSampler(const Crown& crown, RandomKey key);

  /// Appends the next `count` points. Trials are made in parallel; the points do not depend on the threads, nor on the
  /// counts of the calls before. Returns false, with fewer points, if the crown fills too little of its bounds.
  bool append(std::size_t count, Progress& progress, std::vector<Vec3>& points);
  /// Cubic metres of the crown, estimated from the trials made so far.
  double volume() const;

 private:
  void make_trials(std::size_t count, Progress& progress);

  const Crown& crown_;
  Box box_;
  RandomKey plan_key_;
  RandomKey height_key_;
  std::uint64_t trials_ = 0;
  std::uint64_t accepted_ = 0;
  std::vector<Vec3> waiting_;  // accepted but not given out
  std::size_t given_ = 0;      // points of `waiting_` that were given out
};

}  // namespace meristem
