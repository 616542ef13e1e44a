// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>

#include "meristem/base/frame.h"
#include "meristem/scene/crown/crown.h"
#include "meristem/scene/obstacle/closed_mesh.h"
#include "meristem/scene/obstacle/obstacles.h"

namespace meristem {

/// The interior of a closed mesh, placed by a frame.
class MeshCrown : public Crown {
 public:
  /// `frame` maps the mesh's coordinates to the crown's; its axes must be linearly independent.
  MeshCrown(std::shared_ptr<const ClosedMesh> mesh, const DFrame& frame);
  bool contains(Vec3 point) const override;
  /// Returns the distance as Crown::distance does. The first call builds a search tree for the nearest triangle. The
  /// tree costs about 300 bytes and one microsecond per triangle.
  double distance(Vec3 point) const override;
  Box bounds() const override { return bounds_; }

 private:
  std::shared_ptr<const ClosedMesh> mesh_;
  DVec3 origin_;
  DMat3 back_;  // maps the crown's directions to the mesh's
  Box bounds_;
  DMat3 axes_;
  mutable std::once_flag is_searchable_;
  mutable Obstacles surface_;  // in world space
};

}  // namespace meristem
