// SPDX-License-Identifier: Apache-2.0
// Meshes for a view that draws a limited number of triangles.
#pragma once

#include <cstdint>

#include "meristem/base/cache.h"
#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/detail/detail.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// The meshes that a view draws of a plant.
struct ViewMeshes {
  MeshScene scene;              ///< meshes and materials to draw
  bool is_whole = true;         ///< if false, the scene is coarser than the plant
  std::uint64_t triangles = 0;  ///< triangles of the whole plant after instancing; an estimate if the scene is not
                                ///< whole
};

/// The limit of triangles of a view.
struct ViewMeshOptions {
  std::uint64_t triangles = 250'000;  ///< approximate maximum number of triangles of the scene, after instancing
  MeshWork* work = nullptr;           ///< counts the processed geometry; may be null
};

/// Returns about how many triangles the whole plant has, after instancing. Linear in the nodes and organs of its
/// variants.
double about_triangles(const Plant& plant);

/// Returns the whole plant if it has no more triangles than the view draws, and otherwise a coarser scene of about as
/// many.
///
/// The number of triangles that are made grows with the view's number and not with the plant's. Every variant of placed
/// plants is made once. At least a quarter of the triangles goes to the plant's own stems and organs if they need it.
/// The rest is divided so that a placed plant gets fewer triangles if it occurs more often in the scene. If even the
/// coarsest plants do not fit, an even choice of the places is shown.
///
/// With a `cache`, stems and variants that were made before keep their meshes, also those made by a cancelled call.
/// Throws InputError if the tubes and organs of the whole plant would exceed the limit on triangles, where each variant
/// counts once. The limit on bytes applies to the plant alone, to each variant alone, and to the resulting scene, but
/// not to the sum of all variants' whole meshes. Also throws like make_mesh_scene.
ViewMeshes make_view_meshes(const Plant& plant, const SizeLimits& limits, const ViewMeshOptions& options,
                            Progress& progress, Cache* cache = nullptr);

}  // namespace meristem
