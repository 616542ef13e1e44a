// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/output/write/provenance.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// Options of an MTG file.
struct MtgOptions {
  std::optional<Provenance> provenance;  ///< comments at the beginning of the file
};

/// Writes the skeletons of `plant` as a multiscale tree graph, form A. `read_mtg` and `skeleton_of` restore them
/// exactly, with all stems in one skeleton. Organs are left out.
///
/// | scale | class | meaning | number |
/// | --- | --- | --- | --- |
/// | 1 | `P` | a tree: everything on one root | from 1 |
/// | 2 | `A` | an axis | number in SkeletonTable |
/// | 3 | `B` | the root, a point | 0 |
/// | 3 | `S` | the segment that ends with a node | on its axis (axis_numbers) |
///
/// Roots and segments have the features `XX`, `YY`, `ZZ` (east, north and up, metres), `TopDia` (metres), `node` (the
/// row in SkeletonTable), `birth`, and further columns by their names. A value is empty if it is unknown or not finite.
/// `axis` and `order` are written only if they do not follow from how entities are joined. Axes have `component` and
/// `instance` if stems belong to components, and `label` if metamers are numbered.
///
/// Each entity is one line, and laterals stand in the next column. Numbers have enough digits to restore the exact
/// float. Memory beyond the plant: 64 MB, the labels and some 40 bytes per node. The file appears whole or not at all.
/// "-" is standard output. Throws MachineError (path, disk), InputError for further columns whose names a file cannot
/// have, Cancelled.
void write_skeleton_mtg(const Plant& plant, const SizeLimits& limits, const std::string& path,
                        const MtgOptions& options, Progress& progress);

}  // namespace meristem
