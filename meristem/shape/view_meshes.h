// SPDX-License-Identifier: Apache-2.0
// Meshes for a view that draws a limited number of triangles.
#pragma once

#include <cstdint>

#include "meristem/base/cache.h"
#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/detail.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// What a view draws of a plant.
struct ViewMeshes {
  MeshScene scene;              ///< meshes and materials to draw
  bool is_whole = true;         ///< if false, the scene is coarser than the plant
  std::uint64_t triangles = 0;  ///< of the whole plant after instancing; an estimate if the scene is not whole
};

/// The limit of triangles of a view.
struct ViewMeshOptions {
  std::uint64_t triangles = 250'000;  ///< about the most triangles of the scene, after instancing
  MeshWork* work = nullptr;           ///< counts what is made; null: nobody counts
};

/// About how many triangles all of a plant has, after instancing. Linear in the nodes and organs of its variants.
double about_triangles(const Plant& plant);

/// The whole plant if it has no more triangles than the view draws, else a coarser scene of about as many.
///
/// The number of triangles that are made grows with the view's number, not with the plant's. Every variant of placed
/// plants is made once. At least a quarter of the triangles goes to the plant's own stems and organs if they need it;
/// the rest is divided so that a placed plant gets fewer triangles the more often it stands in the scene. If not even
/// the coarsest plants fit, an even choice of the places is shown.
///
/// With a `cache`, stems and variants that it has made before keep their meshes, also those of a call that was
/// cancelled. Throws InputError if the tubes and organs of the whole plant would pass the limit on triangles, where
/// each variant counts once. The limit on bytes is that of the plant alone, of each variant alone, and of the scene
/// that is made; nobody sums it up over the whole meshes of all variants. Throws all else as make_mesh_scene does.
ViewMeshes make_view_meshes(const Plant& plant, const Limits& limits, const ViewMeshOptions& options,
                            Progress& progress, Cache* cache = nullptr);

}  // namespace meristem
