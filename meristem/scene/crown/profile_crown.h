// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/curve.h"
#include "meristem/scene/crown/crown.h"

namespace meristem {

/// A crown given by its radius around the vertical through the root. It has one profile, or several profiles at
/// different azimuths. Between neighbouring azimuths, also from the last to the first, the radius at each height is
/// linear.
class ProfileCrown : public Crown {
 public:
  /// Points (radius, height) in metres: at least two, with strictly rising heights, joined by a natural cubic spline.
  /// Negative radii count as 0.
  using Profile = std::vector<Vec2>;
  /// A profile and its direction from the root.
  struct AtAzimuth {
    double azimuth = 0;  ///< radians from north (-z) over east (+x), any number
    Profile profile;     ///< (radius, height), metres
  };
  using Sides = std::vector<AtAzimuth>;  ///< profiles at different azimuths, in any order

  /// Throws std::invalid_argument for invalid profiles, for an empty list, and for two profiles at one azimuth.
  /// Documents are checked earlier.
  explicit ProfileCrown(const Profile& profile) : ProfileCrown(Sides{{0, profile}}) {}
  explicit ProfileCrown(const Sides& sides);

  double radius_at(double height, double azimuth = 0) const;  ///< metres; 0 outside the profile's heights
  double lowest() const { return lowest_; }                   ///< metres above the root
  double highest() const { return highest_; }                 ///< metres above the root
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  Box bounds() const override;
  Vec2 axis() const override { return {0, 0}; }

 private:
  struct Side {
    double azimuth;  // in [0, 2 pi)
    Curve radius;    // radius over height
  };
  std::vector<Side> sides_;  // sorted by azimuth
  double lowest_ = 0;
  double highest_ = 0;
  double reach_ = 0;  // upper bound of all radii
};

/// Returns the equivalent azimuth in [0, 2 pi).
double wrapped_azimuth(double azimuth);

}  // namespace meristem
