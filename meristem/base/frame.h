// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/vec.h"

namespace meristem {

/// An origin and directions: an affine map from local to outer coordinates.
///
/// The columns of `axes` are the images of x (to the right), y (the heading) and z (the upper face). They are unit and
/// orthogonal unless the frame scales. `origin` is in metres. The default is the world's own frame: y up.
struct Frame {
  Mat3 axes{1};    ///< columns: directions of x, y and z in outer coordinates
  Vec3 origin{0};  ///< metres, in outer coordinates

  Vec3 right() const { return axes[0]; }    ///< direction of x in outer coordinates
  Vec3 heading() const { return axes[1]; }  ///< direction of y in outer coordinates
  Vec3 upper() const { return axes[2]; }    ///< direction of z in outer coordinates

  /// Returns the outer coordinates of a local point.
  Vec3 point(Vec3 local) const { return origin + axes * local; }
  /// Returns the outer direction of a local direction. The length scales with the frame.
  Vec3 vector(Vec3 local) const { return axes * local; }
  /// Returns the outer unit normal of a local unit normal. Correct also for frames that scale unevenly or mirror.
  Vec3 normal(Vec3 local) const;

  /// Returns the frame `inner` in outer coordinates. `inner` is given in the coordinates of this frame.
  Frame operator*(const Frame& inner) const { return {axes * inner.axes, point(inner.origin)}; }
};

/// A frame in 64 bits, for files with national map coordinates. A thousand kilometres from the origin, neighbouring
/// 32-bit floats are 6 cm apart.
struct DFrame {
  DMat3 axes{1};    ///< columns: directions of x, y and z in outer coordinates
  DVec3 origin{0};  ///< metres, in outer coordinates

  /// Returns the outer coordinates of a local point in 64 bits. Callers that store 32 bits round only once.
  DVec3 point(DVec3 local) const { return origin + axes * local; }
};

/// Returns the rotation by `angle` (radians) about the unit vector `axis`, counter-clockwise as seen against the axis.
/// Uses the project's own sine and cosine, so that frames have equal bytes on every machine.
Mat3 rotation(Vec3 axis, double angle);
/// Returns the rotation by `angle` (radians) about the unit vector `axis` in 64 bits.
DMat3 exact_rotation(DVec3 axis, double angle);

/// Returns the smallest rotation that turns the unit vector `from` to the unit vector `to`. For opposite vectors,
/// returns a half turn about a fixed axis at right angles.
Mat3 rotation_between(Vec3 from, Vec3 to);

/// Returns the rotation that closes `share` of the angle between the unit vector `from` and `target`. A negative
/// `share` closes as much of the angle to the opposite of `target`. The rotation is about `fallback` if both are
/// parallel.
Mat3 rotation_toward(Vec3 from, Vec3 target, double share, Vec3 fallback);

/// Returns a frame at `origin` with unit heading `heading`, whose upper face is as near to `upper` as possible. Accepts
/// any vectors: if `upper` is parallel to the heading, a fixed vector replaces it.
Frame frame_along(Vec3 origin, Vec3 heading, Vec3 upper);

/// Returns a unit vector at right angles to the unit vector `direction`. The result is continuous almost everywhere.
Vec3 any_perpendicular(Vec3 direction);

/// Returns `vector` with length 1. Returns `fallback` if the length is below 1e-20 or not finite.
Vec3 normalized_or(Vec3 vector, Vec3 fallback);

}  // namespace meristem
