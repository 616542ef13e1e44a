// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// Writes the skeletons as a table of cylinders in CSV, one row per cylinder. The columns equal the structure
/// `cylinder` of TreeQSM, as exported for R and Python: `radius`, `length`, `start.x` to `start.z`, `axis.x` to
/// `axis.z` (a unit vector), `parent` (number of a row from 1; 0 at a root), `extension` (the next cylinder of the
/// branch, 0 at a tip), `added` (0), `UnmodRadius` (the radius), `branch` (from 1), `SurfCov` (1), `mad` (0),
/// `BranchOrder`, `PositionInBranch` (from 1). Metres; x east, y north, z up. The cylinders of several trees follow
/// each other. Streams like write_skeleton_csv, plus 48 bytes per cylinder, and throws the same errors.
///
/// Based on: P. Raumonen et al., Fast automatic precision tree models from terrestrial laser scanner data, 2013.
void write_cylinder_csv(const Plant& plant, const SizeLimits& limits, const std::string& path, Progress& progress);

}  // namespace meristem
