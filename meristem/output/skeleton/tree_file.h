// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/output/write/provenance.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// Writes the skeletons as a tree file in the format of treetools and raycloudtools. Each tree is one line of segments
/// `x,y,z,radius,parent_id,branch_id,order`, separated by a comma and a blank. The first segment is the root, a point
/// with parent -1. Every other segment is a cylinder from its parent's position to its own, with the radius of
/// cylinders_of. Metres; x east, y north, z up. Comments contain the provenance. Streams like write_skeleton_csv, plus
/// 60 bytes per node, and throws the same errors.
void write_tree_file(const Plant& plant, const SizeLimits& limits, const std::string& path,
                     const Provenance& provenance, Progress& progress);

}  // namespace meristem
