// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/output/write/provenance.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// What the head of the file says.
struct MtgOptions {
  std::optional<Provenance> provenance;  ///< as comments at the file's head
};

/// Writes the skeletons of `plant` as a multiscale tree graph, form A: what they have comes back exactly when
/// `read_mtg` and `skeleton_of` read it, all stems in one skeleton. Organs are left out.
///
/// | scale | class | what it is | number |
/// | --- | --- | --- | --- |
/// | 1 | `P` | a tree: what stands on one root | from 1 |
/// | 2 | `A` | an axis | that of SkeletonTable |
/// | 3 | `B` | the root, a point | 0 |
/// | 3 | `S` | the segment that ends with a node | on its axis (axis_numbers) |
///
/// Roots and segments have the features `XX`, `YY`, `ZZ` (east, north and up, metres), `TopDia` (metres), `node` (the
/// row in SkeletonTable), `birth` and further columns by their names, empty where they are not known or not finite;
/// `axis` and `order` only where these do not follow from how entities are joined. Axes have `component` and `instance`
/// where stems are of components, and `label` where metamers are numbered.
///
/// A line an entity, laterals in the next column. Numbers have the digits that give the same float when read. Memory
/// beyond the plant: 64 MB, the labels and some 40 bytes per node. The file appears whole or not at all; "-" is
/// standard output. Throws MachineError (path, disk), InputError for further columns whose names a file cannot have,
/// Cancelled.
void write_skeleton_mtg(const Plant& plant, const Limits& limits, const std::string& path, const MtgOptions& options,
                        Progress& progress);

}  // namespace meristem
