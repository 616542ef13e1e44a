// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/measure/surface_labels.h"
#include "meristem/output/write/provenance.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// What the head of the file says.
struct PlyOptions {
  Provenance provenance;                  ///< written as comments
  const SurfaceLabels* labels = nullptr;  ///< of the meshes; null: faces have none
};

/// Writes `scene` as one mesh in binary little-endian PLY: metres, y up. A vertex has `x y z`, `nx ny nz` and `s t` (v
/// upward; each of the two only if some mesh has them, 0 for those that have not), `red green blue` of its material,
/// tinted as its instance is, as bytes (sRGB), and `component`, an index whose name stands in the header: `comment
/// component 0 tree`. Faces are `list uchar int vertex_indices`, and with labels also `uchar kind` (SurfaceKind),
/// `ushort order`, and as `int` `tree`, `component`, `instance` and `shoot`, -1 for none; an element `shoot` then has
/// the label of each shoot, `list uchar uchar label`. Instances are flattened. Streams: memory beyond the scene stays
/// below 64 MB. The file appears whole or not at all; "-" is standard output. Throws MachineError (path, disk),
/// InputError for more vertices than an `int` counts, Cancelled.
void write_mesh_ply(const MeshScene& scene, const std::string& path, const PlyOptions& options, Progress& progress);

/// Writes the skeletons of `plant` as points and edges in binary little-endian PLY: metres, y up. A vertex has the
/// columns of SkeletonTable, `x y z radius` first and without `node`, which is its number, and `label`, a text:
/// `parent` is a vertex or -1, `component` an index as above, NaN what is not known. An edge is `vertex1 vertex2`, from
/// parent to child. Streams, throws and appears as write_mesh_ply does.
void write_skeleton_ply(const Plant& plant, const Limits& limits, const std::string& path, const PlyOptions& options,
                        Progress& progress);

}  // namespace meristem
