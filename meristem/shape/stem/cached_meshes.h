// SPDX-License-Identifier: Apache-2.0
// Results that a mesh scene leaves in a cache for the next scene of the same or a changed plant.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/base/fingerprint.h"
#include "meristem/base/mesh.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/detail/detail.h"
#include "meristem/shape/scene/mesh_origin.h"
#include "meristem/shape/scene/mesh_scene.h"
#include "meristem/shape/tube/tubes.h"

namespace meristem {

/// The tubes of one stem, grouped by looks.
struct StemTubes {
  std::vector<std::shared_ptr<const Mesh>> meshes;
  std::vector<TubeSize> sizes;
  std::vector<std::shared_ptr<const std::vector<AxisTriangles>>> tubes{};  ///< for each mesh

  std::uint64_t bytes() const;
};

/// A blended body or a crown.
struct BodyMesh {
  std::shared_ptr<const Mesh> mesh;

  std::uint64_t bytes() const { return mesh->bytes(); }
};

/// A mesh with tangents. Its original without tangents is kept, because it is found by its address.
struct TangentMesh {
  std::shared_ptr<const Mesh> plain;
  std::shared_ptr<const Mesh> mesh;

  std::uint64_t bytes() const { return mesh->bytes(); }
};

/// The meshes of a plant that stands in several places.
struct VariantMeshes {
  MeshScene scene;
  bool is_whole = true;  ///< false for a coarser level

  std::uint64_t bytes() const;
};

/// Adds everything that shapes a stem's meshes except its surface.
void add_skeleton(const Stem& stem, Fingerprint& to);
void add_surface(const SurfaceOptions& surface, Fingerprint& to);
void add_detail(const MeshDetail& detail, Fingerprint& to);

}  // namespace meristem
