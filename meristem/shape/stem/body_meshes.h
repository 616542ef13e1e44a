// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/detail/detail.h"
#include "meristem/shape/implicit/plant_body.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Adds the thickening of the blended bodies of all stems to `whole`. The least radius is the largest of all bodies.
void add_thickening(const Plant& plant, BodyThickening& whole);
/// Returns true if any stem has a blended body or a visible crown body.
bool has_bodies(const Plant& plant);

/// Returns about how many triangles the blended bodies and crowns of a plant have. This is an estimate from their
/// resolution, unless the document sets the number. Linear in nodes.
double about_body_triangles(const Plant& plant);

/// The box around a body's solids, and the side length of the cells in which its surface is sought, in metres.
struct BodyCells {
  Box box;
  double cell = 0;
};
/// Returns the cells of the blended bodies and crown bodies of all stems, in their order, before any deformation.
/// Throws Cancelled.
std::vector<BodyCells> find_body_cells(const Plant& plant, const Progress& progress);

/// Returns the meshes of the blended bodies and crown bodies of all stems, in their order. A body's material has no
/// texture, since bodies have no uvs. A crown's material is its component's material with the crown's colour. New
/// materials are appended to `materials`. Beyond level 0 of `detail`, bodies are simplified to its share of their
/// triangles, but to no fewer than 200. A quick detail first makes them of larger cells, and keeps at least 60
/// triangles. Begins stages of `progress` if there are bodies. Bodies found in `results` are not made again. Throws
/// like extract_isosurface, at the component's surface.
std::vector<MeshInstances> make_body_meshes(const Plant& plant, const MeshDetail& detail, const SizeLimits& limits,
                                            std::vector<Material>& materials, Progress& progress, CacheRun& results);

}  // namespace meristem
