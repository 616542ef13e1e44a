// SPDX-License-Identifier: Apache-2.0
// A plant as a few crossed pictures of itself, for a look from very far.
#pragma once

#include "meristem/base/progress.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// How many cards there are, and how fine.
struct CardOptions {
  int cards =
      3;  ///< upright ones, 1 to kMostCards, turned evenly about the plant's foot; raised, rounder from all sides
  int size = 256;   ///< pixels along the plant's longest side; raised, finer, and files grow with its square
  int samples = 4;  ///< rays per pixel along each side; raised, edges and thin leaves are met more evenly
};

/// Upright cards that cross above the foot of `whole`, and one level card that shows it from above: two triangles each,
/// as large as the plant is from there. They share one picture of its colours, without light, with a mask, and one of
/// its normals: both are what parallel rays meet. As many pixels stay unmasked as the plant covers, so that thin crowns
/// keep their density. The bytes are equal on any number of threads. Empty for a scene without triangles. Textures of
/// `whole` must be painted. Begins a stage of `progress`. Throws std::invalid_argument for options out of range,
/// Cancelled.
MeshScene make_cards(const MeshScene& whole, const CardOptions& options, Progress& progress);

}  // namespace meristem
