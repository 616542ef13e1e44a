// SPDX-License-Identifier: Apache-2.0
// The silhouette of a body of revolution as a chain of straight edges.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "meristem/shape/solid/revolution.h"

namespace meristem {

/// A corner of the chain: radius and height in metres, and the unit directions of the silhouette before and after,
/// which differ at sharp edges. A direction turned clockwise by a right angle is the normal.
struct SilhouetteCorner {
  glm::dvec2 at;
  glm::dvec2 arriving{0, 0}, leaving{0, 0};
};

/// Returns the chain from the axis at the base to the axis at the tip. Open ends have their discs. Only the first and
/// the last corner lie on the axis, with radius 0. The silhouette must have no error.
std::vector<SilhouetteCorner> silhouette_chain(const SolidOfRevolution& solid);

/// Returns the positions of the corners.
std::vector<glm::dvec2> corners_of(const std::vector<SilhouetteCorner>& chain);

}  // namespace meristem
