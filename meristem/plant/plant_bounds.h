// SPDX-License-Identifier: Apache-2.0
// Bounding boxes of plants without making meshes for their stems.
#pragma once

#include "meristem/base/frame.h"
#include "meristem/base/vec.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// Returns the box around the transformed corners of `box`. It contains the transformed content of `box`.
Box box_in(const Box& box, const Frame& frame);

/// Returns a box that contains all nodes with their radii, the meshes of all organs, and the plants of all plantings.
/// It is the smallest such box if no instance is rotated. Cost: linear in nodes, organs and places.
Box bounds(const Plant& plant);

}  // namespace meristem
