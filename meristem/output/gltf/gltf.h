// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "meristem/base/progress.h"
#include "meristem/output/write/encoded_pictures.h"
#include "meristem/output/write/provenance.h"
#include "meristem/shape/mesh_scene.h"
#include "meristem/shape/moving/moving_scene.h"

namespace meristem {

/// How instances of a mesh are written.
enum class GltfInstances {
  automatic,  ///< flattened into one mesh per material; in large scenes rows
  rows,       ///< rows of arrays by EXT_mesh_gpu_instancing: small files, that not every program reads
  nodes,      ///< flattened; in large scenes nodes that share a mesh: large files, that every program reads
};

/// How instances are written, and where the plant came from.
struct GltfOptions {
  GltfInstances instances = GltfInstances::automatic;  ///< how instances are written
  std::uint64_t flatten_triangles = 5'000'000;         ///< scenes with more triangles are large
  Provenance provenance;                               ///< origin of the plant, stored in the file
  EncodedPictures* pictures = nullptr;                 ///< shared with other files; may be null
};

/// Writes `scene` as binary glTF 2.0 to `path` ("-" for standard output): metres, y up, one node per component,
/// materials with their names and their textures as PNG. Where 2 to 1,000 individuals of the scene are seen, a root
/// stands above a node per plant, which has the name of its component and its number, stands at the plant's foot, and
/// has a node per component below it; what belongs to no plant stands beside the plants. Tints of instances are vertex
/// colours where instances are flattened, a row of an array where they are instanced, and one of eight materials where
/// nodes share meshes. Streams: memory beyond the scene and the textures' files stays below 64 MB. The file appears
/// whole or not at all. Throws MachineError (path, disk), InputError for files over 4 GB (which the format cannot
/// hold), Cancelled.
void write_glb(const MeshScene& scene, const std::string& path, const GltfOptions& options, Progress& progress);

/// Writes a scene that moves, as write_glb writes its last state, with one animation "growth": rigid instances are
/// nodes that move, all else of a component that moves is one mesh with a morph target per key but the last, and meshes
/// that are shown for a while are nodes without size at other times. Instances that stand still are flattened. Nothing
/// of `options` says how instances are written. Throws as write_glb does.
void write_moving_glb(const MovingScene& moving, const std::string& path, const GltfOptions& options,
                      Progress& progress);

}  // namespace meristem
