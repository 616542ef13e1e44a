// SPDX-License-Identifier: Apache-2.0
// Compares two states of a part of a moving scene: whether one can become the other by moving, and how.
#pragma once

#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/mesh.h"

namespace meristem {

bool are_one_frame(const Frame& a, const Frame& b);

/// Returns true if a frame consists only of rotation, translation and scale, so that a glTF node can store it.
bool is_rigid_frame(const Frame& frame);

/// Returns true if the vertices of one mesh can move to the vertices of the other: both have equal triangles, or
/// vertices at equal positions of equal pictures. Blades of different proportions may be cut differently between equal
/// vertices.
bool are_of_one_form(const Mesh& a, const Mesh& b);

/// Returns true if normals must turn with their faces from one frame to the other. Both frames must have a size.
bool are_turned(const Frame& a, const Frame& b);
/// Returns true if normals differ between two lists of equal length, by the same rule.
bool are_turned(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

}  // namespace meristem
