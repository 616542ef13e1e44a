// SPDX-License-Identifier: Apache-2.0
// A ray-traced picture: sun and sky with soft shadows, textured and translucent surfaces that light each other, and
// ground that receives the shadow.
#pragma once

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/output/write/png.h"
#include "meristem/scene/scene.h"
#include "meristem/scene/view.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Size and quality of a picture.
struct StillOptions {
  int width = 1200;   ///< pixels, 1 to 16384
  int height = 1200;  ///< pixels, 1 to 16384
  /// Maximum number of paths per pixel. The noise falls with the square root. Even sky and ground, where more paths
  /// change nothing, use an eighth.
  int samples = 64;
  bool transparent = false;  ///< if true, shows only the plant with alpha, without background, ground and obstacles
  bool ground = true;        ///< if true, a plane under the plant receives its shadow
  bool even = false;         ///< if true, every pixel takes all samples, which is slower and has less noise
};

/// Returns the width divided by the height.
inline double aspect_of(const StillOptions& options) { return static_cast<double>(options.width) / options.height; }

/// Throws InputError for sizes outside 1 to 16384 or samples outside 1 to 65536. Can be called before growth.
void check_still_options(const StillOptions& options);

/// Renders `meshes` in the light of `scene`, among its obstacles. The camera frames the meshes, or the obstacles if
/// there are no meshes. The picture is equal on any number of threads. Progress counts pixels. Throws like
/// check_still_options, and Cancelled.
Image render_still(const MeshScene& meshes, const Scene& scene, const CameraView& view, const StillOptions& options,
                   Progress& progress);

/// Renders an equal picture and frees `meshes` afterwards. They are not copied to add obstacles.
Image render_still(MeshScene&& meshes, const Scene& scene, const CameraView& view, const StillOptions& options,
                   Progress& progress);

}  // namespace meristem
