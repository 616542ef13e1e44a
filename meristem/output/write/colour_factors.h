// SPDX-License-Identifier: Apache-2.0
// Colours as files can hold them: a factor on the whole material and one on each instance, none above 1.
#pragma once

#include <vector>

#include "meristem/shape/mesh_scene.h"
#include "meristem/shape/moving/moving_scene.h"

namespace meristem {

/// The light that comes back is texture * base * instance(tint), linear.
struct ColourFactors {
  Vec3 material{1};     ///< Material::tint()
  Vec3 base{1};         ///< the most that any instance needs, at most 1
  Vec3 mean{1};         ///< of all instances, at most 1
  bool varies = false;  ///< some instances have tints of their own

  /// The factor on `base` for an instance of this tint, in [0, 1].
  Vec3 instance(Vec3 tint) const;
};

/// The colour factors of each of the scene's materials.
std::vector<ColourFactors> colour_factors(const MeshScene& scene);

/// The same, with all that instances need at any time.
std::vector<ColourFactors> colour_factors(const MovingScene& moving);

}  // namespace meristem
