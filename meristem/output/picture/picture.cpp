// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/picture.h"

#include "meristem/output/picture/camera.h"
#include "meristem/output/picture/hull_wires.h"

namespace meristem {

Image take_picture(const GrownDocument& grown, const Scene& scene, const PictureOptions& options, Progress& progress) {
  const StillOptions& still = options.still;
  if (!options.crown_hulls || grown.meshes.meshes.empty()) {
    return render_still(grown.meshes, scene, options.view, still, progress);
  }
  const double aspect = static_cast<double>(still.width) / still.height;
  const View view = placed_view(grown.meshes, options.view, aspect);
  return render_still(with_crown_hulls(grown.meshes, grown.plant, progress), scene, view, still, progress);
}

}  // namespace meristem
