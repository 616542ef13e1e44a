// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/document/grow.h"
#include "meristem/output/overlay/overlay.h"
#include "meristem/output/picture/still.h"

namespace meristem {

/// A still, seen from where, and what is drawn over the plants.
struct PictureOptions {
  StillOptions still;                   ///< size and quality
  View view;                            ///< the place and direction of the camera
  bool crown_hulls = false;             ///< draws the convex hull of each tree's crown as wires
  std::vector<OverlayPart> overlays{};  ///< what else is shown, with a legend; the camera frames that, too
  bool plants = true;                   ///< false: nothing but overlays and obstacles
};

/// What render_still draws for a picture, and what is written over it.
struct PictureScene {
  MeshScene meshes;                  ///< the meshes to render
  View view;                         ///< the view with the camera placed
  std::vector<OverlayLayer> layers;  ///< layers to draw over the rendered picture
};
/// Prepares a picture: chooses meshes, camera and layers, and renders nothing. Throws as take_picture() does.
PictureScene picture_scene(const GrownDocument& grown, const Limits& limits, const Scene& scene,
                           const PictureOptions& options, const Progress& progress);

/// A picture of what a document has grown, in the document's `scene`. `limits` are the document's. The camera frames
/// the plants, whatever is drawn around them. Throws what render_still and overlay_layers throw.
Image take_picture(const GrownDocument& grown, const Limits& limits, const Scene& scene, const PictureOptions& options,
                   Progress& progress);

/// Takes the last picture of what has grown, and frees its meshes.
Image take_last_picture(GrownDocument& grown, const Limits& limits, const Scene& scene, const PictureOptions& options,
                        Progress& progress);

/// Returns true if a picture shows plants as their meshes alone: then it needs no GrownDocument::plant.
bool shows_meshes_alone(const PictureOptions& options);

}  // namespace meristem
