// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/progress.h"
#include "meristem/document/document.h"
#include "meristem/graph/growth_traces.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/geometry_count.h"
#include "meristem/shape/mesh_scene.h"
#include "meristem/shape/view_meshes.h"

namespace meristem {

/// What can be made of a document, each of what stands before it.
enum class GrownPart {
  plant,     ///< skeletons and organs: tables, measures of skeletons
  meshes,    ///< what clothes them: measures, meshes without pictures
  textures,  ///< what lies on the meshes: pictures, and files that hold some
};

/// A document that has grown: skeletons and organs, and the meshes that clothe them.
struct GrownDocument {
  Plant plant;                         ///< skeletons, organs and materials
  MeshScene meshes;                    ///< empty if only the plant was made
  GrownPart up_to = GrownPart::plant;  ///< what there is of it; without textures, materials have sketches of them
  std::vector<Diagnostic> warnings;    ///< what is odd about the plant but not wrong, placed in the document's text
  GrowthTraces traces;                 ///< what was recorded of its growth, where that was asked for
};

/// What one growth leaves for the next one of the same or a changed document, which makes anew only what depends on the
/// change. It holds no more than the last growth has used. The result is the same as without it, to the byte; one that
/// throws or is cancelled leaves it in order. One call at a time may use it.
using GrowthCache = Cache;

/// How much of a kind of result the last growth with a cache made anew, and how much the cache had.
struct ReuseCount {
  const char* what;  ///< in the plural: "instances"
  Reuse count;       ///< results made and reused
};

/// How much of each kind of result the cache gave back, in the order in which growth makes the kinds; a kind that the
/// growth did not need is left out.
std::vector<ReuseCount> reuse_of(const GrowthCache& cache);

/// The time, the last stage and the detail of a growth.
struct GrowthOptions {
  double time = 0;                        ///< seconds: the document as it stands then
  Detail detail{};                        ///< how coarse the meshes are
  GrownPart up_to = GrownPart::textures;  ///< the last stage that is made
  GrowthCache* cache = nullptr;           ///< results of the last growth; null: everything is made anew
  GrowthView view;                        ///< the step of growth that is shown, and what is recorded of growth
  /// If false and meshes are made, the plant is freed while they are made, and GrownDocument::plant is empty. A large
  /// stand then takes half of the memory. What a cache holds is not freed.
  bool keeps_plant = true;
};

/// Grows a document: the one call that all programs make. The same document gives the same bytes on any number of
/// threads, with and without a cache. Throws InputError (limits, numbers that are not finite; placed in the document's
/// text), Cancelled.
GrownDocument grow_document(const Document& document, Progress& progress, const GrowthOptions& options = {});

/// Completes a growth of the document up to a part, with the result that grow_document would have given for this part;
/// meshes that exist keep their detail. Throws as grow_document does, and then leaves `grown` unchanged.
void complete_growth(const Document& document, GrownDocument& grown, Progress& progress,
                     const GrowthOptions& options = {});

/// Replaces the sketches of textures in the materials of a plant that has grown from the document, and of the plants
/// that stand in it, by pictures. Throws Cancelled.
void paint_plant(const Document& document, Plant& plant, Progress& progress, GrowthCache* cache = nullptr);

/// The meshes of a level of detail of a plant that has grown from the document, without growing it anew. They equal the
/// meshes that grow_document gives for the level, with the plant's textures. Throws what grow_document throws.
MeshScene mesh_detail(const Document& document, const Plant& plant, const Detail& detail, Progress& progress,
                      GrowthCache* cache = nullptr);

/// Returns the meshes for rays (ray_meshes.h) of a plant that has grown from the document, at level 0.
/// Textures with holes must be painted (paint_plant). Throws what grow_document throws.
MeshScene mesh_for_rays(const Document& document, const Plant& plant, Progress& progress);
/// Returns these meshes, and frees the plant while they are made.
MeshScene mesh_for_rays(const Document& document, Plant&& plant, Progress& progress);

/// Counts the geometry of the meshes of a plant at level 0, without making the meshes (geometry_count.h). Throws what
/// grow_document throws.
GeometryCount count_geometry(const Document& document, const Plant& plant, Progress& progress);

/// The meshes of a plant that has grown from the document, for a view that draws a limited number of triangles
/// (view_meshes.h), with the plant's textures. Throws what grow_document throws.
ViewMeshes view_meshes(const Document& document, const Plant& plant, const ViewMeshOptions& options, Progress& progress,
                       GrowthCache* cache = nullptr);

}  // namespace meristem
