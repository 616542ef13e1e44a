// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/detail.h"
#include "meristem/shape/implicit/plant_body.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// Adds the thickening of the blended bodies of all stems to `whole`. The least radius is the largest of all bodies.
void add_thickening(const Plant& plant, Thickening& whole);
/// Returns true if any stem has a blended body or a visible crown body.
bool has_bodies(const Plant& plant);

/// About how many triangles the blended bodies and crowns of a plant have. A guess by their resolution, unless the
/// document says how many. Linear in nodes.
double about_body_triangles(const Plant& plant);

/// The box about a body's solids, and one side of the cells in which its surface is sought, in metres.
struct BodyCells {
  Box box;
  double cell = 0;
};
/// Those of the blended bodies and crown bodies of all stems, in their order, before any deformation. Throws Cancelled.
std::vector<BodyCells> find_body_cells(const Plant& plant, const Progress& progress);

/// The blended bodies and crown bodies of all stems, in their order; a body's material has no texture, as bodies have
/// no uvs, and a crown's is its component's with the crown's colour: those that are new are appended to `materials`.
/// Beyond level 0 of `detail` they are simplified to its share of their triangles, but to no fewer than 200. A quick
/// detail makes them of larger cells first, and of no fewer than 60 triangles. Begins
/// stages of `progress` where there are any. Bodies that are among the `results` are not made anew. Throws as
/// extract_isosurface does, at the component's surface.
std::vector<MeshInstances> make_body_meshes(const Plant& plant, const Detail& detail, const Limits& limits,
                                            std::vector<Material>& materials, Progress& progress, CacheRun& results);

}  // namespace meristem
