// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "meristem/base/progress.h"
#include "meristem/output/write/provenance.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// How instances are written, and where the plant came from.
struct GltfOptions {
  /// Instances of one material are flattened into one mesh up to this many triangles; beyond, nodes share meshes.
  std::uint64_t flatten_triangles = 5'000'000;
  /// Instances share meshes by EXT_mesh_gpu_instancing, however few triangles there are: small files, that not every
  /// program reads.
  bool instanced = false;
  Provenance provenance;
};

/// Writes `scene` as binary glTF 2.0 to `path` ("-" for standard output): metres, y up, one node a component, materials
/// with their names and their textures as PNG. Tints of instances are vertex colours where instances are flattened, a
/// row of an array where they are instanced, and one of eight materials where nodes share meshes.
/// Streams: memory beyond the scene and the textures' files stays below 64 MB. The file appears whole or not at all.
/// Throws MachineError (path, disk), InputError for files over 4 GB (which the format cannot hold), Cancelled.
void write_glb(const MeshScene& scene, const std::string& path, const GltfOptions& options, Progress& progress);

}  // namespace meristem
