// SPDX-License-Identifier: Apache-2.0
// Surfaces through the sections of many instances.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/graph/emitter.h"
#include "meristem/graph/graph.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// An emitted section with the component of its instance.
struct SurfaceSection : EmittedSection {
  ComponentIndex component = 0;
  std::uint32_t individual = 0;  ///< index into Plant::individuals
};

/// A mesh that surfaces share, and where it stands.
struct SurfacePiece {
  ComponentIndex component = 0;
  std::shared_ptr<const Mesh> mesh;
  bool is_open = false;       ///< of a surface that encloses nothing: it is seen from both sides
  std::vector<Organ> organs;  ///< without prototypes
  std::vector<std::shared_ptr<const Deformation>> deformations;  ///< one per organ: that of the section it begins with
};

/// Joins the sections of children to those of their parents.
///
/// The first of a section's children, in the order given, continues its surface; each other begins one of its own, from
/// the same section. What of a surface ends at a section belongs to that section's component and has its instance's
/// tint; normals do not show where one piece ends. A surface of a single section is a flat face where that is a ring
/// with a cap, else nothing. Surfaces of the same sections that differ in place, turn and size only, up to 1e-4 of
/// their size, share their meshes.
///
/// `mesh_bytes` have been spent on other meshes. Linear in points. Throws InputError for the limit of bytes, Cancelled.
std::vector<SurfacePiece> join_sections(std::span<const SurfaceSection> sections, const Graph& graph,
                                        std::uint64_t mesh_bytes, Progress& progress);

}  // namespace meristem
