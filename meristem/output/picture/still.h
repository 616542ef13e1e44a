// SPDX-License-Identifier: Apache-2.0
// A ray-cast picture: sun and sky with soft shadows, textured and translucent surfaces that light each other, a ground
// that catches the shadow.
#pragma once

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/output/write/png.h"
#include "meristem/scene/scene.h"
#include "meristem/scene/view.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// Size and quality of a picture.
struct StillOptions {
  int width = 1200;   ///< pixels, 1 to 16384; the same for the height
  int height = 1200;  ///< pixels
  /// Most paths per pixel. Noise falls with its root; even sky and ground, where no more is seen, take an eighth.
  int samples = 64;
  bool transparent = false;  ///< no background, ground and obstacles; only the plant, with alpha
  bool ground = true;        ///< a plane under the plant that takes its shade
  bool even = false;         ///< every pixel takes all samples: slower, with less noise
};

/// Returns the width divided by the height.
inline double aspect_of(const StillOptions& options) { return static_cast<double>(options.width) / options.height; }

/// Throws InputError for sizes outside 1 to 16384 or samples outside 1 to 65536; before growing, say.
void check_still_options(const StillOptions& options);

/// Renders `meshes` in the light of `scene`, among its obstacles. The camera frames the meshes, or obstacles where
/// there are none. The picture is equal on any number of threads; progress counts pixels. Throws what
/// check_still_options throws, and Cancelled.
Image render_still(const MeshScene& meshes, const Scene& scene, const View& view, const StillOptions& options,
                   Progress& progress);

/// Renders the same picture, and frees `meshes` with it; they are not copied to stand among obstacles.
Image render_still(MeshScene&& meshes, const Scene& scene, const View& view, const StillOptions& options,
                   Progress& progress);

}  // namespace meristem
