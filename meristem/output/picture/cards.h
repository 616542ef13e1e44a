// SPDX-License-Identifier: Apache-2.0
// A plant as a few crossed pictures of itself, for views from very far.
#pragma once

#include "meristem/base/progress.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Number and resolution of cards.
struct CardOptions {
  int cards = 3;   ///< number of upright cards, 1 to kMaxCards, turned evenly about the plant's foot; more look rounder
                   ///< from all sides
  int size = 256;  ///< pixels along the plant's longest side; more are finer, and file sizes grow with the square
  int samples = 4;  ///< rays per pixel along each side; more sample edges and thin leaves more evenly
};

/// Returns upright cards that cross above the foot of `whole`, and one level card with the view from above. A card is
/// two triangles of the size of the plant in its view. All cards share one picture of unlit colours with a mask, and
/// one of normals, both drawn by parallel rays. The number of unmasked pixels matches the area that the plant covers,
/// so that thin crowns keep their density. The bytes are equal on any number of threads. Returns an empty scene for a
/// scene without triangles. Textures of `whole` must be painted. Begins a stage of `progress`. Throws
/// std::invalid_argument for options out of range, Cancelled.
MeshScene make_cards(const MeshScene& whole, const CardOptions& options, Progress& progress);

}  // namespace meristem
