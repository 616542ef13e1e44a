// SPDX-License-Identifier: Apache-2.0
// Draws triangles seen by parallel rays as runs of pixels.
#pragma once

#include <algorithm>
#include <cmath>

#include "meristem/base/vec.h"

namespace meristem {

/// A parallel view, which maps positions to pixels.
struct OutlineView {
  DVec3 across{1, 0, 0};  ///< unit vector to the picture's right
  DVec3 up{0, 1, 0};      ///< unit vector at right angles to `across`
  DVec3 centre{0};        ///< position in the picture's middle
  double scale = 1;       ///< pixels per metre
  int size = 1;           ///< pixels along each side of the picture

  glm::dvec2 pixel(Vec3 position) const {
    const DVec3 offset = DVec3(position) - centre;
    return {glm::dot(offset, across) * scale + 0.5 * size, glm::dot(offset, up) * scale + 0.5 * size};
  }
};

/// Returns a view along `direction` (unit vector).
inline OutlineView view_along(Vec3 direction, DVec3 centre, double scale, int size) {
  OutlineView view;
  const DVec3 along(direction);
  const DVec3 aside = std::abs(along.y) < 0.9 ? DVec3(0, 1, 0) : DVec3(1, 0, 0);
  const DVec3 across = glm::cross(aside, along);
  view.across = across * (1 / std::sqrt(glm::dot(across, across)));
  view.up = glm::cross(along, view.across);
  view.centre = centre;
  view.scale = scale;
  view.size = size;
  return view;
}

/// Calls `visit(row, first, end)` for the pixels of each row whose centres lie in the triangle, in either orientation.
template <class Visit>
void cover_triangle(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, int size, const Visit& visit) {
  if (b.y < a.y) std::swap(a, b);
  if (c.y < b.y) std::swap(b, c);
  if (b.y < a.y) std::swap(a, b);
  const double last = size;
  // Row k has its centres at k + 0.5. A centre at the height of a corner belongs to the part above the corner.
  const double from = std::ceil(std::max(a.y, 0.0) - 0.5);
  const double to = std::ceil(std::min(c.y, last) - 0.5);
  for (double row = from; row < to; row += 1) {
    const double y = row + 0.5;
    const double on_long = a.x + (c.x - a.x) * ((y - a.y) / (c.y - a.y));
    const double on_short =
        y < b.y ? a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)) : b.x + (c.x - b.x) * ((y - b.y) / (c.y - b.y));
    const double left = std::ceil(std::max(std::min(on_long, on_short), 0.0) - 0.5);
    const double right = std::ceil(std::min(std::max(on_long, on_short), last) - 0.5);
    if (left < right) visit(static_cast<int>(row), static_cast<int>(left), static_cast<int>(right));
  }
}

}  // namespace meristem
