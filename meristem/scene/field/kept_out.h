// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/frame.h"
#include "meristem/scene/crown/crown.h"

namespace meristem {

/// A body that stems keep out of. They slow down as they come near to it, and go along it: at a distance d from the
/// surface they head toward it by a share d / reach of their way at most, so their distance never falls faster than by
/// exp(-way / reach). Out of a body that they begin in, they grow the same way.
class KeptOut {
 public:
  /// `frame` takes the body's coordinates to the world's and has one scale; `reach` is above 0, metres in the world.
  KeptOut(CrownPointer body, const Frame& frame, double reach);

  /// The next section of a stem: `step` metres from a position, in the direction of a unit vector.
  struct Section {
    Vec3 position{0};
    Vec3 heading = kUp;
    double step = 0;
    double radius = 0;  ///< of the stem, all of which stays outside
  };
  /// The unit vector nearest to the section's heading that the body leaves open. A convex body is never entered.
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
