// SPDX-License-Identifier: Apache-2.0
// The meshes of one plant: its stems, bodies and organs.
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/detail.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// What the meshes are for.
enum class MeshUse {
  all,
  rays,  ///< what only pictures show is left out
};

struct OwnMeshOptions {
  const Limits& limits;
  const Detail& detail;
  Cache* cache = nullptr;
  MeshUse use = MeshUse::all;
};

/// The meshes of a plant without its plantings. Throws as make_mesh_scene does.
MeshScene make_own_meshes(const Plant& plant, const OwnMeshOptions& options, Progress& progress);

/// How many triangles the tubes and organs of a plant have without its plantings. Plans all tubes and makes none.
/// Throws as make_mesh_scene does.
std::uint64_t planned_triangles(const Plant& plant, const Limits& limits);

/// Brings what belongs to one component together, in the order of first appearance; leaves out what is not to be seen.
std::vector<MeshInstances> grouped(std::vector<MeshInstances> meshes);

}  // namespace meristem
