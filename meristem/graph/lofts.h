// SPDX-License-Identifier: Apache-2.0
// Surfaces through the sections of many instances.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/graph/emitted.h"
#include "meristem/graph/graph.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// An emitted section, with the component of its instance.
struct SurfaceSection : EmittedSection {
  ComponentIndex component = 0;
  std::uint32_t individual = 0;  ///< index into Plant::individuals
};

/// A mesh that equal surfaces share, and the organs that place it.
struct SurfacePiece {
  ComponentIndex component = 0;
  std::shared_ptr<const Mesh> mesh;
  bool is_open = false;       ///< true: the surface encloses nothing and is visible from both sides
  std::vector<Organ> organs;  ///< without prototypes
  std::vector<std::shared_ptr<const Deformation>> deformations;  ///< one per organ: the deformation of its first
                                                                 ///< section
};

/// Joins the sections of children to the sections of their parents.
///
/// The first child of a section, in the order given, continues its surface. Each other child begins a new surface at
/// that section. A piece of surface that ends at a section belongs to that section's component and has its instance's
/// tint. Normals are smooth across the ends of pieces. A single section makes a flat face if it is a ring with a cap,
/// else nothing. Surfaces that differ only in position, rotation and size, up to 1e-4 of their size, share their
/// meshes.
///
/// `mesh_bytes` is the size of all other meshes. Takes time in proportion to the points. Throws InputError for the
/// limit of bytes, and Cancelled.
std::vector<SurfacePiece> join_sections(std::span<const SurfaceSection> sections, const Graph& graph,
                                        std::uint64_t mesh_bytes, Progress& progress);

}  // namespace meristem
