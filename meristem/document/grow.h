// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/progress.h"
#include "meristem/document/document.h"
#include "meristem/graph/expansion_cache.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/mesh_cache.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// A document that has grown: skeletons and organs, and the meshes that clothe them.
struct GrownDocument {
  Plant plant;
  MeshScene meshes;
};

/// What one growth leaves for the next one of the same or a changed document: expansion_cache.h, mesh_cache.h.
struct GrowthCache {
  ExpansionCache expansion;
  MeshCache meshes;

  std::uint64_t bytes() const { return expansion.bytes() + meshes.bytes(); }
};

/// Grows a document as it stands at `time` (seconds): the one call behind every door. `detail` says how coarse the
/// meshes are. With a `cache`, only what has changed since its last growth is made anew. The same document gives the
/// same bytes on any number of threads, with and without a cache. Throws InputError (limits, numbers that are not
/// finite; placed in the document's text), Cancelled.
GrownDocument grow_document(const Document& document, Progress& progress, double time = 0, const Detail& detail = {},
                            GrowthCache* cache = nullptr);

/// The meshes of a level of detail of a plant that has grown of the document: those that grow_document gives for it,
/// without growing anew. Throws as it does.
MeshScene mesh_detail(const Document& document, const Plant& plant, const Detail& detail, Progress& progress,
                      MeshCache* cache = nullptr);

}  // namespace meristem
