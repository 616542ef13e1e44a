// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <gtest/gtest.h>

#include "meristem/base/mesh.h"

namespace meristem {

/// Succeeds if programs for 3D printing can use the mesh. By its indices alone, every edge must have one triangle on
/// either side with opposite directions. The signed volume must be positive, and no vertex may be unused.
testing::AssertionResult check_printable(const Mesh& mesh);

/// Returns the number of pairs of triangles without a common vertex that cross each other: an edge of one passes
/// through the inside of the other. Compares the boxes of all pairs, so it suits meshes of a few thousand triangles.
std::size_t count_crossings(const Mesh& mesh);

}  // namespace meristem
