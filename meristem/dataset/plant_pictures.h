// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/progress.h"
#include "meristem/dataset/dataset_plan.h"
#include "meristem/document/grow.h"

namespace meristem {

/// Writes the pictures that a plan requests of a plant, with their true depth, normals and masks. The plant must have
/// grown up to textures. `base` is the path of the files without their endings. Pictures of several views are named
/// `base_0`, `base_1`, ...
void write_plant_pictures(const DatasetPlan& plan, const PlannedPlant& plant, const Document& document,
                          const GrownDocument& grown, const std::string& base, Progress& progress);

}  // namespace meristem
