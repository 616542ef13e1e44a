// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/vec.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// Returns the direction in which it gets brighter from a position. Each light contributes the unit vector toward it,
/// times `sunlit_weight`. If an obstacle blocks the light, the contribution is instead the unit vector away from the
/// obstacle's centroid on the ground, at right angles to the light. The result is the sum weighted by the strengths of
/// the lights; 0 without lights.
///
/// Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund
/// 2020, equations 4.19 to 4.22, read so that they agree with the published figures.
DVec3 brighter_way(const Scene& scene, Vec3 position, double sunlit_weight);

}  // namespace meristem
