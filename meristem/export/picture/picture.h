// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/document/grow.h"
#include "meristem/export/overlay/overlay.h"
#include "meristem/output/picture/still.h"

namespace meristem {

/// A picture: its size and quality, its view, and the overlays over the plants.
struct PictureOptions {
  StillOptions still;                   ///< size and quality
  CameraView view;                      ///< position and direction of the camera
  bool crown_hulls = false;             ///< draws the convex hull of each tree's crown as wires
  std::vector<OverlayPart> overlays{};  ///< overlays with a legend; the camera frames them as well
  bool plants = true;                   ///< if false, shows only overlays and obstacles
};

/// The scene of a picture for render_still, and the layers for its text.
struct PictureScene {
  MeshScene meshes;                  ///< the meshes to render
  CameraView view;                   ///< the view with the camera placed
  std::vector<OverlayLayer> layers;  ///< layers that are drawn over the rendered picture
};
/// Prepares a picture: chooses meshes, camera and layers, but renders nothing. Throws like take_picture().
PictureScene picture_scene(const GrownDocument& grown, const SizeLimits& limits, const Scene& scene,
                           const PictureOptions& options, const Progress& progress);

/// Returns a picture of a grown document in the document's `scene`. `limits` are the document's. The camera frames the
/// plants, whatever is drawn around them. Throws like render_still and overlay_layers.
Image take_picture(const GrownDocument& grown, const SizeLimits& limits, const Scene& scene,
                   const PictureOptions& options, Progress& progress);

/// Takes the last picture of a grown document, and frees its meshes.
Image take_last_picture(GrownDocument& grown, const SizeLimits& limits, const Scene& scene,
                        const PictureOptions& options, Progress& progress);

/// Returns true if a picture shows only the plants' meshes. Then it does not need GrownDocument::plant.
bool shows_meshes_alone(const PictureOptions& options);

}  // namespace meristem
