// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/progress.h"
#include "meristem/document/document.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// A document that has grown: skeletons and organs, and the meshes that clothe them.
struct GrownDocument {
  Plant plant;
  MeshScene meshes;
};

/// Grows a document as it stands at `time` (seconds): the one call behind every door. The same document gives the same
/// bytes on any number of threads. Throws InputError (limits, numbers that are not finite; placed in the document's
/// text), Cancelled.
GrownDocument grow_document(const Document& document, Progress& progress, double time = 0);

}  // namespace meristem
