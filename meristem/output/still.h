// SPDX-License-Identifier: Apache-2.0
// A ray-cast picture: sun and sky with soft shadows, one bounce between surfaces, a ground that catches the shadow.
#pragma once

#include <optional>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/output/image.h"
#include "meristem/scene/scene.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// Where a picture is taken from. Unset parts are chosen so that the whole plant is seen.
struct View {
  std::optional<Vec3> position;  ///< metres
  std::optional<Vec3> target;    ///< metres; by default the middle of what is seen
  double field_of_view = 0.6;    ///< vertical, radians
  double azimuth =
      2.6;  ///< where the camera stands as seen from the target if no position is given, from north over east
  double altitude = 0.12;  ///< and how high, radians
  Vec3 background{-1};     ///< sRGB; negative: the sky
};

struct StillOptions {
  int width = 1200;
  int height = 1200;
  int samples = 64;          ///< paths a pixel; noise falls with its root, time grows with it
  bool transparent = false;  ///< no background, no ground; only the plant, with alpha
  bool ground = true;
};

/// Renders `meshes` in the light of `scene`. The same picture on any number of threads; progress counts pixels.
/// Throws InputError for sizes outside 1 to 16384 or samples outside 1 to 65536, Cancelled.
Image render_still(const MeshScene& meshes, const Scene& scene, const View& view, const StillOptions& options,
                   Progress& progress);

}  // namespace meristem
