// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/crown/mesh_crown.h"

#include <cmath>
#include <limits>
#include <utility>

#include <glm/matrix.hpp>

namespace meristem {

MeshCrown::MeshCrown(std::shared_ptr<const ClosedMesh> mesh, const DFrame& frame)
    : mesh_(std::move(mesh)), origin_(frame.origin), back_(glm::inverse(frame.axes)) {
  for (const DVec3 position : mesh_->positions()) bounds_.add(Vec3(frame.point(position)));
  // Rounding must not cut anything off.
  for (int k = 0; k < 3; ++k) {
    bounds_.low[k] = std::nextafter(bounds_.low[k], -std::numeric_limits<float>::infinity());
    bounds_.high[k] = std::nextafter(bounds_.high[k], std::numeric_limits<float>::infinity());
  }
}

bool MeshCrown::contains(Vec3 point) const { return mesh_->contains(back_ * (DVec3(point) - origin_)); }

}  // namespace meristem
