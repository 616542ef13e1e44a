// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/crown/mesh_crown.h"

#include <cmath>
#include <limits>
#include <utility>

#include <glm/matrix.hpp>

namespace meristem {

MeshCrown::MeshCrown(std::shared_ptr<const ClosedMesh> mesh, const DFrame& frame)
    : mesh_(std::move(mesh)), origin_(frame.origin), back_(glm::inverse(frame.axes)), axes_(frame.axes) {
  for (const DVec3 position : mesh_->positions()) bounds_.add(Vec3(frame.point(position)));
  // Enlarge the bounds, so that rounding cuts nothing off.
  for (int k = 0; k < 3; ++k) {
    bounds_.low[k] = std::nextafter(bounds_.low[k], -std::numeric_limits<float>::infinity());
    bounds_.high[k] = std::nextafter(bounds_.high[k], std::numeric_limits<float>::infinity());
  }
}

bool MeshCrown::contains(Vec3 point) const { return mesh_->contains(back_ * (DVec3(point) - origin_)); }

double MeshCrown::distance(Vec3 point) const {
  std::call_once(is_searchable_, [&] {
    Obstacle body{.mesh = mesh_->mesh()};
    for (DVec3& position : body.mesh.positions) position = DFrame{axes_, origin_}.point(position);
    surface_ = Obstacles({std::move(body)});
  });
  const double away = surface_.distance_to_surface(point);
  return contains(point) ? -away : away;
}

}  // namespace meristem
