// SPDX-License-Identifier: Apache-2.0
// How much room a plant takes, before its stems have meshes.
#pragma once

#include "meristem/base/frame.h"
#include "meristem/base/vec.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// The box around the corners of a box in a frame: what is in the one is in the other.
Box box_in(const Box& box, const Frame& frame);

/// A box that holds all nodes with their radii, the meshes of all organs, and the plants of all plantings. It is the
/// smallest one where nothing is turned. Linear in nodes, organs and places.
Box bounds(const Plant& plant);

}  // namespace meristem
