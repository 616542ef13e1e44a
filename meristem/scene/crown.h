// SPDX-License-Identifier: Apache-2.0
// Crown envelopes and the attraction points in them.
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/curve.h"
#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/base/vec.h"

namespace meristem {

/// A body of revolution about the vertical through the root: radius as a natural cubic spline of height.
class ProfileCrown {
 public:
  /// Marked points (radius, height) in metres, at least two, heights strictly rising. Radii below 0 count as 0.
  /// Throws std::invalid_argument for other points; documents are checked before.
  explicit ProfileCrown(const std::vector<Vec2>& profile);

  double radius_at(double height) const;  ///< 0 outside the marked heights
  double lowest() const;                  ///< metres above the root
  double highest() const;
  double volume() const { return volume_; }  ///< cubic metres
  bool contains(Vec3 point) const;           ///< relative to the root

  /// `count` points uniform in volume, relative to the root: the height by inverting the cumulated cross-section, then
  /// uniform in the disc. The k-th point is a function of (key, k) alone.
  std::vector<Vec3> sample(std::uint64_t count, RandomKey key, Progress& progress) const;

 private:
  Curve radius_;
  std::vector<double> heights_;    // equally spaced
  std::vector<double> cumulated_;  // volume below each height
  double volume_ = 0;
};

}  // namespace meristem
