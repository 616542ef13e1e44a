// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/curve.h"
#include "meristem/scene/crown/crown.h"

namespace meristem {

/// A crown given by how far it reaches from the vertical through the root: a profile, or several at azimuths, between
/// which the radius at each height goes linearly, and from the last on to the first.
class ProfileCrown : public Crown {
 public:
  /// Marked points (radius, height) in metres, at least two, heights strictly rising, joined by a natural cubic spline.
  /// Radii below 0 count as 0.
  using Profile = std::vector<Vec2>;
  struct AtAzimuth {
    double azimuth = 0;  ///< radians from north (-z) over east (+x), any number
    Profile profile;
  };
  using Sides = std::vector<AtAzimuth>;

  /// Throws std::invalid_argument for other profiles, none, or two at one azimuth; documents are checked before.
  explicit ProfileCrown(const Profile& profile) : ProfileCrown(Sides{{0, profile}}) {}
  explicit ProfileCrown(const Sides& sides);

  double radius_at(double height, double azimuth = 0) const;  ///< 0 outside the marked heights
  double lowest() const { return lowest_; }                   ///< metres above the root
  double highest() const { return highest_; }
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  Box bounds() const override;
  Vec2 axis() const override { return {0, 0}; }

 private:
  struct Side {
    double azimuth;  // in [0, 2 pi)
    Curve radius;    // radius over height
  };
  std::vector<Side> sides_;  // by azimuth
  double lowest_ = 0;
  double highest_ = 0;
  double reach_ = 0;  // no radius is larger
};

/// The azimuth in [0, 2 pi) that is the same direction.
double wrapped_azimuth(double azimuth);

}  // namespace meristem
