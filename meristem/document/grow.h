// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/progress.h"
#include "meristem/document/document.h"
#include "meristem/graph/growth_traces.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/assembly/geometry_count.h"
#include "meristem/shape/assembly/view_meshes.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// The parts of a grown document. Each part needs the parts before it.
enum class GrownPart {
  plant,     ///< skeletons and organs: sufficient for tables and measures of skeletons
  meshes,    ///< meshes of all surfaces: for measures and for meshes without pictures
  textures,  ///< pictures on the meshes: for renderings, and for files that contain pictures
};

/// A document that has grown: its plant, and the meshes of all surfaces.
struct GrownDocument {
  Plant plant;                         ///< skeletons, organs and materials
  MeshScene meshes;                    ///< empty if only the plant was made
  GrownPart up_to = GrownPart::plant;  ///< the last part that was made; without textures, materials have sketches of
                                       ///< them
  std::vector<Diagnostic> warnings;    ///< unusual but valid things in the plant, placed in the document's text
  GrowthTraces traces;                 ///< the requested records of its growth
};

/// Keeps the results of one growth for the next growth of the unchanged or changed document. The next growth makes only
/// parts that depend on the change. The cache holds only what the last growth has used. A result is equal to the byte
/// with or without the cache. A growth that fails or is cancelled leaves the cache valid. Only one call at a time may
/// use it.
using GrowthCache = Cache;

/// The numbers of results of one kind that the last growth with a cache made and reused.
struct ReuseCount {
  const char* what;  ///< in the plural: "instances"
  CacheReuse count;  ///< results made and reused
};

/// Returns the reuse of each kind of result, in the order in which growth makes the kinds. A kind that the growth did
/// not need is left out.
std::vector<ReuseCount> reuse_of(const GrowthCache& cache);

/// Options of a growth: its time, its last stage, its detail and its view.
struct GrowthOptions {
  double time = 0;                        ///< time of the document, seconds
  MeshDetail detail{};                    ///< how coarse the meshes are
  GrownPart up_to = GrownPart::textures;  ///< the last stage that is made
  GrowthCache* cache = nullptr;           ///< results of the last growth; null: nothing is reused
  GrowthView view;                        ///< the step of growth that is shown, and what is recorded of growth
  /// If false and meshes are made, the plant is freed while they are made, and GrownDocument::plant is empty. A large
  /// stand then needs half of the memory. Results in a cache are not freed.
  bool keeps_plant = true;
};

/// Grows a document. All programs use this function. A document gives equal bytes on any number of threads, with and
/// without a cache. Throws InputError (limits, numbers that are not finite; placed in the document's text) and
/// Cancelled.
GrownDocument grow_document(const Document& document, Progress& progress, const GrowthOptions& options = {});

/// Completes a growth of the document up to a part. The result equals the result of grow_document for this part.
/// Existing meshes keep their detail. Throws as grow_document does, and then leaves `grown` unchanged.
void complete_growth(const Document& document, GrownDocument& grown, Progress& progress,
                     const GrowthOptions& options = {});

/// Replaces texture sketches by pictures in the materials of a plant that has grown from the document, and of the
/// plants that stand in it. Throws Cancelled.
void paint_plant(const Document& document, Plant& plant, Progress& progress, GrowthCache* cache = nullptr);

/// Returns the meshes of a level of detail of a plant that has grown from the document, without a new growth. They
/// equal the meshes that grow_document gives for the level, with the plant's textures. Throws what grow_document
/// throws.
MeshScene mesh_detail(const Document& document, const Plant& plant, const MeshDetail& detail, Progress& progress,
                      GrowthCache* cache = nullptr);

/// Returns the meshes for rays (ray_meshes.h) of a plant that has grown from the document, at level 0.
/// Textures with holes must be painted (paint_plant). Throws what grow_document throws.
MeshScene mesh_for_rays(const Document& document, const Plant& plant, Progress& progress);
/// Returns these meshes, and frees the plant while they are made.
MeshScene mesh_for_rays(const Document& document, Plant&& plant, Progress& progress);

/// Counts the geometry of the meshes of a plant at level 0, without making the meshes (geometry_count.h). Throws what
/// grow_document throws.
GeometryCount count_geometry(const Document& document, const Plant& plant, Progress& progress);

/// Returns the meshes of a plant that has grown from the document, with the plant's textures, for a view that draws a
/// limited number of triangles (view_meshes.h). Throws what grow_document throws.
ViewMeshes view_meshes(const Document& document, const Plant& plant, const ViewMeshOptions& options, Progress& progress,
                       GrowthCache* cache = nullptr);

}  // namespace meristem
