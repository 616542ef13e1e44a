// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/plant/skeleton.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// Returns the light at each node of a skeleton in world space: the scene's light that obstacles let through, reduced
/// by the shade of the skeleton's own stems. It is 1 in the open where the strengths of sun and sky sum to 1, and at
/// least 0. Shade falls as in self-organizing trees with default parameters, in voxels of 1/24 of the skeleton's
/// longest side. A twice as large skeleton therefore has equal light. Other plants do not count. Cost: one ray per node
/// and light among obstacles, else linear in the length of the stems.
std::vector<float> light_at_nodes(const Skeleton& skeleton, const Scene& scene);

}  // namespace meristem
