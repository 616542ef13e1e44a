// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "meristem/output/picture/still.h"

namespace meristem {

/// A pinhole camera. Film coordinates run from -1 to 1, x to the right and y upward.
class Camera {
 public:
  /// Looks from `position` to `target`; `aspect` is width over height, `field_of_view` the vertical one in radians.
  Camera(Vec3 position, Vec3 target, double field_of_view, double aspect);

  Vec3 position() const { return position_; }  ///< metres, in the world
  Vec3 forward() const { return forward_; }    ///< unit, the way it looks
  Vec3 right() const { return right_; }        ///< unit, where x of the film rises
  Vec3 up() const { return up_; }              ///< unit, where y of the film rises
  /// Half the film's height at a distance of 1; half its width is this times the aspect.
  float half_height() const { return half_height_; }
  /// The unit direction of the ray through a point of the film.
  Vec3 direction(Vec2 film) const;
  /// Where a point is seen on the film; nothing for points behind the camera.
  std::optional<Vec2> project(Vec3 point) const;

 private:
  Vec3 position_;
  Vec3 forward_, right_, up_;
  float half_width_, half_height_;  // half the film's width and height at distance 1
};

/// The camera that `view` asks for. Where it gives no position, the nearest one from its azimuth and altitude from
/// which all of `scene` stays clear of the picture's border, with the plant in the middle unless a target is given.
Camera place_camera(const MeshScene& scene, const View& view, double aspect);

/// `view` with the position and target that place_camera chooses for it, so that it stays while the plant changes.
View placed_view(const MeshScene& scene, View view, double aspect);

}  // namespace meristem
