// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/measure/surface_labels.h"
#include "meristem/output/write/provenance.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Options of a PLY file.
struct PlyOptions {
  Provenance provenance;                  ///< written as comments
  const SurfaceLabels* labels = nullptr;  ///< labels of the meshes; null: faces have no labels
  bool shared_vertices = false;           ///< if true, leaves out normals and texture coordinates, and faces share
                                          ///< vertices, so that closed meshes are closed by their indices
};

/// Writes `scene` as one mesh in binary little-endian PLY, in metres, y up.
///
/// A vertex has `x y z`, then `nx ny nz` and `s t` (v upward) if some mesh has them, with 0 for meshes that do not.
/// `red green blue` as bytes (sRGB) are the colour of the material, tinted like the instance. `component` is an index,
/// and the header lists its name: `comment component 0 tree`. Faces are `list uchar int vertex_indices`. With labels,
/// faces also have `uchar kind` (SurfaceKind), `ushort order`, and `tree`, `component`, `instance` and `shoot` as
/// `int`, -1 if there is no such object. An element `shoot` then has the label of each shoot, `list uchar uchar label`.
/// Instances are flattened.
///
/// Streams: memory beyond the scene stays below 64 MB, or with shared vertices 8 bytes per vertex more. The file
/// appears whole or not at all. "-" is standard output. Throws MachineError (path, disk) and Cancelled. Throws
/// InputError for numbers that are not finite, and for more vertices or triangles than an `int` can count.
void write_mesh_ply(const MeshScene& scene, const std::string& path, const PlyOptions& options, Progress& progress);

/// Writes the skeletons of `plant` as points and edges in binary little-endian PLY, in metres, y up. A vertex has the
/// columns of SkeletonTable, `x y z radius` first, and `label` as a text. The column `node` is left out, because it is
/// the number of the vertex. `parent` is a vertex or -1, `component` an index as above, and NaN marks unknown values.
/// An edge is `vertex1 vertex2`, from parent to child. Plantings are expanded first, within `limits`. Streams, throws
/// and appears like write_mesh_ply.
void write_skeleton_ply(const Plant& plant, const SizeLimits& limits, const std::string& path,
                        const PlyOptions& options, Progress& progress);

}  // namespace meristem
