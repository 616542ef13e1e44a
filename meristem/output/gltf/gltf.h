// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "meristem/base/progress.h"
#include "meristem/output/write/encoded_pictures.h"
#include "meristem/output/write/provenance.h"
#include "meristem/shape/moving/moving_scene.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// The form in which instances of a mesh are written.
enum class GltfInstances {
  automatic,  ///< flattened into one mesh per material; in large scenes as rows
  rows,       ///< rows of arrays with EXT_mesh_gpu_instancing: small files that not every program reads
  nodes,      ///< flattened; in large scenes, nodes that share a mesh: large files that every program reads
};

/// How instances are written, and the origin of the plant.
struct GltfOptions {
  GltfInstances instances = GltfInstances::automatic;  ///< how instances are written
  std::uint64_t flatten_triangles = 5'000'000;         ///< scenes with more triangles are large
  Provenance provenance;                               ///< origin of the plant, stored in the file
  EncodedPictures* pictures = nullptr;                 ///< shared with other files; may be null
};

/// Writes `scene` as binary glTF 2.0 to `path` ("-" for standard output), in metres, y up. Each component has a node.
/// Materials have their names, and their textures are PNG pictures.
///
/// If the scene shows 2 to 1,000 individuals, a root node stands above one node per plant. The node of a plant has the
/// name of its component and its number. It stands at the plant's foot and has a child node per component. Parts
/// without a plant stand beside the plants.
///
/// Tints of instances are vertex colours if instances are flattened, rows of an array if they are instanced, and one of
/// eight materials if nodes share meshes. Streams: memory beyond the scene and the texture files stays below 64 MB. The
/// file appears whole or not at all. Throws MachineError (path, disk), InputError for files over 4 GB (the limit of the
/// format), and Cancelled.
void write_glb(const MeshScene& scene, const std::string& path, const GltfOptions& options, Progress& progress);

/// Writes a moving scene with one animation "growth". The static content is the scene's last state, as write_glb writes
/// it. Rigid instances are nodes that move. All other moving parts of a component are one mesh with a morph target per
/// key except the last. Meshes that are shown only for a while are nodes with size 0 at other times. Instances that do
/// not move are flattened, so the options about instances have no effect. Throws like write_glb.
void write_moving_glb(const MovingScene& moving, const std::string& path, const GltfOptions& options,
                      Progress& progress);

}  // namespace meristem
