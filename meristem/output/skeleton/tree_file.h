// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/output/write/provenance.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// Writes the skeletons as a tree file, as treetools and raycloudtools read it: a line per tree, whose segments follow
/// each other, each `x,y,z,radius,parent_id,branch_id,order` and parted from the next by a comma and a blank. The first
/// segment is the root, a point with parent -1; every other one is a cylinder from its parent's position to its own, of
/// the radius that cylinders_of gives. Metres; x east, y north, z up. Comments tell the provenance. Streams as
/// write_skeleton_csv does, but for 60 bytes per node; throws as that does.
void write_tree_file(const Plant& plant, const Limits& limits, const std::string& path, const Provenance& provenance,
                     Progress& progress);

}  // namespace meristem
