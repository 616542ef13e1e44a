// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"

namespace meristem {

/// Replaces those normals of `mesh` that lie behind one of their triangles: by ones that lie in front of all of these
/// where there are such, as nearly everywhere, else by ones that lie in front of most. Cost linear in triangles. Counts
/// nothing into the caller's stage; throws Cancelled.
void turn_to_front(Mesh& mesh, Progress& progress);

}  // namespace meristem
