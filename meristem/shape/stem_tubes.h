// SPDX-License-Identifier: Apache-2.0
// The tubes of one stem of a plant: what its looks and parts say to tube_plan.h and tubes.h.
#pragma once

#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/stem_looks.h"
#include "meristem/shape/tube/tube_plan.h"

namespace meristem {

/// The plan of a stem's tubes with the `share` of their triangles that a level of detail has; `is_quick` as in Detail.
/// The stem outlives it.
TubePlan plan_stem(const Stem& stem, const StemLooks& looks, double share, bool is_quick = false);

/// The meshes of the plan, deformed as the stem's parts are, without tangents. Throws as Deformation::map does.
std::vector<Mesh> make_stem_tubes(const TubePlan& plan, const StemLooks& looks, Progress& progress);

}  // namespace meristem
