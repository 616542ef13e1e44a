// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "meristem/output/picture/still.h"

namespace meristem {

/// A pinhole camera. Film coordinates run from -1 to 1, x to the right and y upward.
class Camera {
 public:
  /// Looks from `position` to `target`. `aspect` is width divided by height, and `field_of_view` is the vertical angle
  /// and `roll` the turn about the line of sight, both in radians. A positive roll turns the picture clockwise.
  Camera(Vec3 position, Vec3 target, double field_of_view, double aspect, double roll = 0);

  Vec3 position() const { return position_; }  ///< position in the world, metres
  Vec3 forward() const { return forward_; }    ///< unit vector of the viewing direction
  Vec3 right() const { return right_; }        ///< unit vector along which x of the film rises
  Vec3 up() const { return up_; }              ///< unit vector along which y of the film rises
  /// Returns half the film's height at a distance of 1. Half its width is this times the aspect.
  float half_height() const { return half_height_; }
  /// Returns the unit direction of the ray through a point of the film.
  Vec3 direction(Vec2 film) const;
  /// Returns the position of a point on the film, or nothing for points behind the camera.
  std::optional<Vec2> project(Vec3 point) const;

 private:
  Vec3 position_;
  Vec3 forward_, right_, up_;
  float half_width_, half_height_;  // half the film's width and height at distance 1
};

/// Returns the camera of `view`. If the view has no position, the camera stands as near as possible, in the direction
/// of the view's azimuth and altitude, so that `scene` stays clear of the picture's border. The plant is in the middle
/// unless the view has a target.
Camera place_camera(const MeshScene& scene, const CameraView& view, double aspect);

/// Returns `view` with the position and target that place_camera chooses, so that the view stays while the plant
/// changes.
CameraView placed_view(const MeshScene& scene, CameraView view, double aspect);

}  // namespace meristem
