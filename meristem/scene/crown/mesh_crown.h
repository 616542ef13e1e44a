// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <glm/mat3x3.hpp>

#include "meristem/base/frame.h"
#include "meristem/scene/crown/crown.h"
#include "meristem/scene/obstacle/closed_mesh.h"

namespace meristem {

/// The inside of a closed mesh, placed by a frame.
class MeshCrown : public Crown {
 public:
  /// `frame` takes the mesh's coordinates to those of the crown; its axes must be independent.
  MeshCrown(std::shared_ptr<const ClosedMesh> mesh, const Frame& frame);
  bool contains(Vec3 point) const override;
  Box bounds() const override { return bounds_; }

 private:
  std::shared_ptr<const ClosedMesh> mesh_;
  DVec3 origin_;
  glm::dmat3 back_;  // from the crown's directions to the mesh's
  Box bounds_;
};

}  // namespace meristem
