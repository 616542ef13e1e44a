// SPDX-License-Identifier: Apache-2.0
// Takes pictures: adds overlays and hulls to the meshes, places the camera, renders the still, and writes labels over
// it.
#include "meristem/export/picture/picture.h"

#include <algorithm>
#include <utility>

#include "meristem/base/math.h"
#include "meristem/export/overlay/overlay_meshes.h"
#include "meristem/export/overlay/overlay_text.h"
#include "meristem/export/picture/hull_wires.h"
#include "meristem/output/picture/camera.h"
#include "meristem/output/picture/free_side.h"

namespace meristem {

namespace {

/// Returns the unit vector along the ground to the right of the picture.
Vec3 right_of(const CameraView& view) {
  const auto azimuth = view.azimuth;
  Vec3 forward(-static_cast<float>(math::sin(azimuth)), 0, static_cast<float>(math::cos(azimuth)));
  if (view.position) forward = view.target.value_or(Vec3(0)) - *view.position;
  return normalized_or(glm::cross(Vec3(forward.x, 0, forward.z), kUp), Vec3(1, 0, 0));
}

}  // namespace

PictureScene picture_scene(const GrownDocument& grown, const SizeLimits& limits, const Scene& scene,
                           const PictureOptions& options, const Progress& progress) {
  const MeshScene& plants = grown.meshes;
  const double aspect = aspect_of(options.still);
  const CameraView view = options.still.transparent
                              ? options.view
                              : view_past_obstacles(plants, scene.obstacles, options.view, aspect, progress);
  PictureScene picture{options.plants ? plants : MeshScene(), view, {}};
  if (!options.overlays.empty()) {
    const OverlaySource source{grown.plant, grown.traces, scene, limits, plants.bounds(), right_of(view)};
    picture.layers = overlay_layers(source, options.overlays, progress);
    Box box = overlay_bounds(picture.layers);
    if (options.plants) box.add(plants.bounds());
    const Vec3 size = box.size();
    picture.meshes = with_overlays(picture.meshes, picture.layers, std::max({size.x, size.y, size.z}));
    picture.view = placed_view(picture.meshes, view, aspect);
  } else if (options.crown_hulls && !plants.meshes.empty()) {
    picture.view = placed_view(plants, view, aspect);
  }
  if (options.crown_hulls && !plants.meshes.empty()) {
    picture.meshes = with_crown_hulls(picture.meshes, grown.plant, progress);
  }
  return picture;
}

bool shows_meshes_alone(const PictureOptions& options) {
  return options.overlays.empty() && !options.crown_hulls && options.plants;
}

Image take_last_picture(GrownDocument& grown, const SizeLimits& limits, const Scene& scene,
                        const PictureOptions& options, Progress& progress) {
  if (!shows_meshes_alone(options)) return take_picture(grown, limits, scene, options, progress);
  return render_still(std::move(grown.meshes), scene, options.view, options.still, progress);
}

Image take_picture(const GrownDocument& grown, const SizeLimits& limits, const Scene& scene,
                   const PictureOptions& options, Progress& progress) {
  if (shows_meshes_alone(options)) {
    return render_still(grown.meshes, scene, options.view, options.still, progress);
  }
  const PictureScene picture = picture_scene(grown, limits, scene, options, progress);
  Image image = render_still(picture.meshes, scene, picture.view, options.still, progress);
  const Camera camera = place_camera(picture.meshes, picture.view, aspect_of(options.still));
  write_overlay_text(image, picture.layers, [&](Vec3 position) { return camera.project(position); });
  return image;
}

}  // namespace meristem
