// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/base/fingerprint.h"
#include "meristem/base/kept_results.h"
#include "meristem/base/mesh.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/detail.h"
#include "meristem/shape/mesh_cache.h"
#include "meristem/shape/tube/tubes.h"

namespace meristem {

/// The tubes of one stem, by its looks.
struct StemTubes {
  std::vector<std::shared_ptr<const Mesh>> meshes;
  std::vector<TubeSize> sizes;

  std::uint64_t bytes() const;
};

/// A mesh with tangents, and the one without of which it was made.
struct TangentMesh {
  std::shared_ptr<const Mesh> plain;
  std::shared_ptr<const Mesh> mesh;

  std::uint64_t bytes() const { return mesh->bytes(); }
};

struct MeshCache::Kept {
  KeptResults<const StemTubes> tubes;
  KeptResults<const Mesh> bodies;
  KeptResults<const TangentMesh> tangents;  // by the address of the plain mesh, which stays as long as it is kept
  Reuse stems_reuse;
  Reuse bodies_reuse;

  void begin_run();
  void end_run();
};

/// Adds all that shapes a stem's meshes, but for what clothes it.
void add_skeleton(const Stem& stem, Fingerprint& to);
void add_surface(const Surface& surface, Fingerprint& to);
void add_detail(const Detail& detail, Fingerprint& to);

}  // namespace meristem
