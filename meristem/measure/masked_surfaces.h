// SPDX-License-Identifier: Apache-2.0
// Surfaces that the organs of a prototype share, without the holes of their textures.
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/measure/foliage.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/texture/alpha_mask.h"

namespace meristem {

/// Computes areas of triangles under a frame. Area vectors are multiplied by the cofactors of the axes of the frame.
class AreaInFrame {
 public:
  explicit AreaInFrame(const Frame& frame) {
    const DVec3 x(frame.axes[0]);
    const DVec3 y(frame.axes[1]);
    const DVec3 z(frame.axes[2]);
    yz_ = glm::cross(y, z);
    zx_ = glm::cross(z, x);
    xy_ = glm::cross(x, y);
  }
  double twice(const DVec3& vector) const { return glm::length(vector.x * yz_ + vector.y * zx_ + vector.z * xy_); }

 private:
  DVec3 yz_, zx_, xy_;
};

/// The triangles that all organs of a prototype share.
struct MaskedSurface {
  const Mesh* mesh = nullptr;
  std::vector<DVec3> vectors;   ///< twice the area vector of each triangle, in its own frame
  std::vector<double> covered;  ///< share of each triangle that is not a hole
};

/// The surfaces of the prototypes of a plant, or of a plant that comes in blocks (plant_variant.h).
class MaskedSurfaces {
 public:
  /// Finds the surfaces of the prototypes that `block` has and earlier blocks did not have. The meshes and textures of
  /// `block` must outlive this. Throws std::invalid_argument if a texture with holes is a sketch.
  void add_new(const Plant& block);
  const MaskedSurface& of(const Organ& organ) const { return surfaces_[organ.prototype]; }
  /// Returns the area of each organ of a block. Counts organs into the caller's stage of `progress`.
  std::vector<OrganArea> areas(const Plant& block, Progress& progress) const;

 private:
  using Key = std::pair<const Texture*, std::array<float, 6>>;  // a triangle on a texture

  std::vector<double> covered(const Mesh& mesh, const Texture* texture);

  std::map<const Texture*, AlphaMask> masks_;
  std::map<Key, double> shares_;  // results that meshes with equal uvs share
  std::vector<MaskedSurface> surfaces_;
};

}  // namespace meristem
