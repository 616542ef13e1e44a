// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/frame.h"
#include "meristem/scene/crown/crown.h"

namespace meristem {

/// A body that stems keep out of. Near the body, stems slow their approach and turn along the surface. At distance d,
/// they head toward the surface by at most the share d / reach of their way. Their distance therefore falls no faster
/// than exp(-way / reach). Stems that begin inside the body grow out of it by the same rule.
class KeptOut {
 public:
  /// `frame` maps the body's coordinates to the world's and scales uniformly. `reach` is above 0, metres in the world.
  KeptOut(CrownPointer body, const Frame& frame, double reach);

  /// The next section of a stem: `step` metres from `position` in the direction of the unit vector `heading`.
  struct Section {
    Vec3 position{0};    ///< begin of the section, metres
    Vec3 heading = kUp;  ///< unit vector
    double step = 0;     ///< length of the section, metres
    double radius = 0;   ///< radius of the stem, whose whole cross-section stays outside
  };
  /// Returns the unit vector nearest to the section's heading that the body allows. A convex body is never entered.
  Vec3 open_heading(const Section& section) const;

 private:
  double distance(Vec3 position) const;
  Vec3 outward(Vec3 position) const;

  CrownPointer body_;
  Vec3 origin_;
  Mat3 back_;
  double scale_;
  double reach_;
};

}  // namespace meristem
