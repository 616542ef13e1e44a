// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/vec.h"

namespace meristem {

/// An origin and directions: an affine map from local to outer coordinates.
///
/// Columns of `axes` are the images of x (to the right), y (the heading) and z (the upper face); unit and orthogonal
/// unless the frame scales. `origin` is in metres. The default is the world's own frame: y up.
struct Frame {
  Mat3 axes{1};    ///< columns: directions of x, y and z in outer coordinates
  Vec3 origin{0};  ///< metres, in outer coordinates

  Vec3 right() const { return axes[0]; }    ///< direction of x in outer coordinates
  Vec3 heading() const { return axes[1]; }  ///< direction of y in outer coordinates
  Vec3 upper() const { return axes[2]; }    ///< direction of z in outer coordinates

  /// Outer coordinates of a local point.
  Vec3 point(Vec3 local) const { return origin + axes * local; }
  /// Outer direction of a local direction; its length scales with the frame.
  Vec3 vector(Vec3 local) const { return axes * local; }
  /// Outer unit normal of a local unit normal; right also for frames that scale unevenly or mirror.
  Vec3 normal(Vec3 local) const;

  /// The frame `inner`, given in this one's coordinates, in outer coordinates.
  Frame operator*(const Frame& inner) const { return {axes * inner.axes, point(inner.origin)}; }
};

/// A frame in 64 bits, for files with the coordinates of a country. A thousand kilometres from the origin, neighbouring
/// 32-bit floats are 6 cm apart.
struct DFrame {
  DMat3 axes{1};    ///< columns: directions of x, y and z in outer coordinates
  DVec3 origin{0};  ///< metres, in outer coordinates

  /// Outer coordinates of a local point in 64 bits; callers that store 32 bits round it once.
  DVec3 point(DVec3 local) const { return origin + axes * local; }
};

/// The rotation by `angle` (radians) about the unit vector `axis`, counter-clockwise seen against it.
/// Uses the project's own sine and cosine, so that frames have the same bytes on every machine.
Mat3 rotation(Vec3 axis, double angle);
/// The rotation by `angle` (radians) about the unit vector `axis` in 64 bits.
DMat3 exact_rotation(DVec3 axis, double angle);

/// The smallest rotation that takes the unit vector `from` to the unit vector `to`; for opposite vectors a half turn
/// about some axis at right angles, always the same one.
Mat3 rotation_between(Vec3 from, Vec3 to);

/// The rotation that closes `share` of the angle between the unit vector `from` and `target`; where `share` is negative
/// it closes as much of the angle to the opposite of `target`. Turns about `fallback` where both are parallel.
Mat3 rotation_toward(Vec3 from, Vec3 target, double share, Vec3 fallback);

/// A frame at `origin` with unit heading `heading`, its upper face as near to `upper` as can be. Any vectors do: where
/// `upper` is parallel to the heading, a fixed substitute stands in.
Frame frame_along(Vec3 origin, Vec3 heading, Vec3 upper);

/// A unit vector at right angles to the unit vector `direction`, a continuous choice almost everywhere.
Vec3 any_perpendicular(Vec3 direction);

/// `vector` with length 1, or `fallback` where its length is below 1e-20 or not finite.
Vec3 normalized_or(Vec3 vector, Vec3 fallback);

}  // namespace meristem
