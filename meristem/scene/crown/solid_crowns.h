// SPDX-License-Identifier: Apache-2.0
// The simple bodies that serve as crowns. Sizes are metres, at least 0; a body without volume contains nothing useful.
#pragma once

#include "meristem/scene/crown/crown.h"

namespace meristem {

/// An ellipsoid with its axes along x, y and z; a sphere where the radii are equal.
class EllipsoidCrown : public Crown {
 public:
  EllipsoidCrown(Vec3 centre, Vec3 radii) : centre_(centre), radii_(radii) {}
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  Box bounds() const override;

 private:
  DVec3 centre_;
  DVec3 radii_;
};

/// A cone on a horizontal disc.
class ConeCrown : public Crown {
 public:
  /// `base` is the middle of the disc; the apex stands `height` over it.
  ConeCrown(Vec3 base, double radius, double height) : base_(base), radius_(radius), height_(height) {}
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  Box bounds() const override;

 private:
  DVec3 base_;
  double radius_;
  double height_;
};

/// A box with its edges along x, y and z.
class BoxCrown : public Crown {
 public:
  explicit BoxCrown(const Box& box) : box_(box) {}
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  Box bounds() const override { return box_; }

 private:
  Box box_;
};

}  // namespace meristem
