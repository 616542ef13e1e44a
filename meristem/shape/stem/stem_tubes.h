// SPDX-License-Identifier: Apache-2.0
// The tubes of one stem of a plant: passes its looks and parts to tube_plan.h and tubes.h.
#pragma once

#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/stem/stem_looks.h"
#include "meristem/shape/tube/tube_plan.h"

namespace meristem {

/// Returns the plan of a stem's tubes with the `share` of their triangles at a level of detail. `is_quick` is as in
/// Detail. The stem must outlive the plan.
TubePlan plan_stem(const Stem& stem, const StemLooks& looks, double share, bool is_quick = false);

/// Returns the meshes of the plan, deformed like the stem's parts, without tangents. Throws like Deformation::map.
std::vector<Mesh> make_stem_tubes(const TubePlan& plan, const StemLooks& looks, Progress& progress);

}  // namespace meristem
