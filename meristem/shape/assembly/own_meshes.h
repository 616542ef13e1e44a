// SPDX-License-Identifier: Apache-2.0
// The meshes of one plant: its stems, bodies and organs.
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/detail/detail.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// The purpose of the meshes.
enum class MeshUse {
  all,
  rays,  ///< leaves out attributes that only pictures show
};

struct OwnMeshOptions {
  const SizeLimits& limits;
  const MeshDetail& detail;
  Cache* cache = nullptr;
  MeshUse use = MeshUse::all;
};

/// Returns the meshes of a plant without its plantings. Throws like make_mesh_scene.
MeshScene make_own_meshes(const Plant& plant, const OwnMeshOptions& options, Progress& progress);

/// Returns the number of triangles of a plant's tubes and organs, without its plantings. Plans all tubes but makes
/// none. Throws like make_mesh_scene.
std::uint64_t planned_triangles(const Plant& plant, const SizeLimits& limits);

/// Groups meshes by component in the order of first appearance, and removes invisible ones.
std::vector<MeshInstances> grouped(std::vector<MeshInstances> meshes);

}  // namespace meristem
