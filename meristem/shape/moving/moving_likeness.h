// SPDX-License-Identifier: Apache-2.0
// How alike two states of a part of a moving scene are: whether one can become the other by moving, and how.
#pragma once

#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/mesh.h"

namespace meristem {

bool are_one_frame(const Frame& a, const Frame& b);

/// Whether a frame is made of turn, shift and scale alone, so that a node of glTF can hold it.
bool is_rigid_frame(const Frame& frame);

/// Whether the vertices of one mesh can move to those of the other: they have the same triangles, or lie at the same
/// places of the same picture. Blades of other proportions may be cut otherwise between equal vertices.
bool are_of_one_form(const Mesh& a, const Mesh& b);

/// Whether normals must move with their faces from one frame to the other; both have a size.
bool are_turned(const Frame& a, const Frame& b);
/// The same from one list of normals to another as long.
bool are_turned(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

}  // namespace meristem
