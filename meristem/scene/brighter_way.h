// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/vec.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// Where it gets brighter from a position: for each of the scene's lights the unit vector toward it, times
/// `sunlit_weight`, or, where an obstacle is in the way, the unit vector away from the obstacle's centroid on the
/// ground and at right angles to the light; their sum, weighted by strength. 0 where there is no light.
///
/// Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund
/// 2020, equations 4.19 to 4.22, as the published figures bear them out.
DVec3 brighter_way(const Scene& scene, Vec3 position, double sunlit_weight);

}  // namespace meristem
