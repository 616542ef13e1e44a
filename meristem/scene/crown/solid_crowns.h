// SPDX-License-Identifier: Apache-2.0
// Simple bodies that serve as crowns. Sizes are in metres and at least 0. A body without volume has no useful interior.
#pragma once

#include "meristem/scene/crown/crown.h"

namespace meristem {

/// An ellipsoid with its axes along x, y and z; a sphere if the radii are equal.
class EllipsoidCrown : public Crown {
 public:
  /// `radii` are the half axes along x, y and z.
  EllipsoidCrown(Vec3 centre, Vec3 radii) : centre_(centre), radii_(radii) {}
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  Box bounds() const override;
  bool is_convex() const override { return true; }

 private:
  DVec3 centre_;
  DVec3 radii_;
};

/// A cone on a horizontal disc.
class ConeCrown : public Crown {
 public:
  /// `base` is the centre of the disc; the apex is `height` above it.
  ConeCrown(Vec3 base, double radius, double height) : base_(base), radius_(radius), height_(height) {}
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  Box bounds() const override;
  bool is_convex() const override { return true; }

 private:
  DVec3 base_;
  double radius_;
  double height_;
};

/// An upright cylinder on a horizontal disc.
class CylinderCrown : public Crown {
 public:
  /// `base` is the centre of the lower disc.
  CylinderCrown(Vec3 base, double radius, double height) : base_(base), radius_(radius), height_(height) {}
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  Box bounds() const override;
  bool is_convex() const override { return true; }

 private:
  DVec3 base_;
  double radius_;
  double height_;
};

/// A pyramid on a horizontal square with its sides along x and z.
class PyramidCrown : public Crown {
 public:
  /// `base` is the centre of the square with sides of length `width`; the apex is `height` above it.
  PyramidCrown(Vec3 base, double width, double height) : base_(base), half_width_(width / 2), height_(height) {}
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  Box bounds() const override;
  bool is_convex() const override { return true; }

 private:
  DVec3 base_;
  double half_width_;
  double height_;
};

/// A torus that lies flat.
class TorusCrown : public Crown {
 public:
  /// `radius` is the radius of the circle in the middle of the tube. `tube`, the radius of the tube, is at most
  /// `radius`.
  TorusCrown(Vec3 centre, double radius, double tube) : centre_(centre), radius_(radius), tube_(tube) {}
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  Box bounds() const override;

 private:
  DVec3 centre_;
  double radius_;
  double tube_;
};

/// All points on one side of a plane.
class HalfSpaceCrown : public Crown {
 public:
  /// `point` lies on the plane. `normal` points out of the half space and has any length above 0.
  HalfSpaceCrown(Vec3 point, Vec3 normal) : point_(point), normal_(normal) {}
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  /// Returns a box with sides of 2 kEndlessReach.
  Box bounds() const override;
  bool is_convex() const override { return true; }

 private:
  DVec3 point_;
  DVec3 normal_;
};

/// A box with its edges along x, y and z.
class BoxCrown : public Crown {
 public:
  /// A crown that fills `box`.
  explicit BoxCrown(const Box& box) : box_(box) {}
  bool contains(Vec3 point) const override;
  double distance(Vec3 point) const override;
  Box bounds() const override { return box_; }
  bool is_convex() const override { return true; }

 private:
  Box box_;
};

}  // namespace meristem
