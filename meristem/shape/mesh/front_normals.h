// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"

namespace meristem {

/// Replaces the normals of `mesh` that lie behind one of their triangles. The new normals lie in front of all their
/// triangles if possible, which is nearly always, and otherwise in front of most. The cost is linear in triangles. Does
/// not advance the caller's stage. Throws Cancelled.
void turn_to_front(Mesh& mesh, Progress& progress);

}  // namespace meristem
