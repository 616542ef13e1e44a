// SPDX-License-Identifier: Apache-2.0
// The silhouette of a body of revolution as a chain of straight edges.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "meristem/shape/solid/revolution.h"

namespace meristem {

/// Radius and height, metres, with the unit directions of the silhouette before and after, which differ at sharp edges.
/// A direction turned clockwise by a right angle is the normal.
struct SilhouetteCorner {
  glm::dvec2 at;
  glm::dvec2 arriving{0, 0}, leaving{0, 0};
};

/// From the axis at the base to the axis at the tip: open ends have their discs. Only the first and the last corner lie
/// on the axis, with radius 0. For a silhouette without a fault.
std::vector<SilhouetteCorner> silhouette_chain(const SolidOfRevolution& solid);

/// Their positions.
std::vector<glm::dvec2> corners_of(const std::vector<SilhouetteCorner>& chain);

}  // namespace meristem
