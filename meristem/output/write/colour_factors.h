// SPDX-License-Identifier: Apache-2.0
// Colours in the form of files: a factor for the whole material and one for each instance, none above 1.
#pragma once

#include <vector>

#include "meristem/shape/moving/moving_scene.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// The reflected light is texture * base * instance(tint), linear.
struct ColourFactors {
  Vec3 material{1};     ///< Material::tint()
  Vec3 base{1};         ///< maximum over all instances, at most 1
  Vec3 mean{1};         ///< mean over all instances, at most 1
  bool varies = false;  ///< true if some instances have tints of their own

  /// Returns the factor on `base` for an instance of this tint, in [0, 1].
  Vec3 instance(Vec3 tint) const;
};

/// Returns the colour factors of each of the scene's materials.
std::vector<ColourFactors> colour_factors(const MeshScene& scene);

/// Returns the colour factors of a moving scene, which cover all tints of instances at any time.
std::vector<ColourFactors> colour_factors(const MovingScene& moving);

}  // namespace meristem
