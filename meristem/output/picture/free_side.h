// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/progress.h"
#include "meristem/scene/obstacle/obstacles.h"
#include "meristem/scene/view.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Returns `view` with a side from which the plants are visible past the obstacles. Tries eight sides at three
/// altitudes, the nearest first, and chooses the first side from which half of the plants is visible. If there is no
/// such side, chooses the one with the largest visible part. The view stays unchanged if it has a position, a target or
/// a side of its own, or if no obstacle is visible. `aspect` is the width of the picture divided by its height. The
/// result does not depend on the number of threads. Throws Cancelled.
CameraView view_past_obstacles(const MeshScene& plants, const Obstacles& obstacles, CameraView view, double aspect,
                               const Progress& progress);

}  // namespace meristem
