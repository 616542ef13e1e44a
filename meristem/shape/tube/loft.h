// SPDX-License-Identifier: Apache-2.0
// Lofts: a surface through a row of sections, like the skin of a hull over its frames.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meristem/base/mesh.h"

namespace meristem {

/// A section of a loft. Its points are in metres, in order: an open row of at least 2 points, a ring of at least 3
/// points that closes from the last to the first (which is not repeated), or 1 point, in which the surface ends in a
/// tip.
struct LoftSection {
  std::vector<Vec3> points;  ///< metres
  bool is_closed = true;     ///< true: a ring; false: an open row
  bool is_round = false;     ///< if true, no corner of the section is sharp, however few it has

  bool is_point() const { return points.size() == 1; }  ///< true for a single point
};

/// An error in a section.
struct LoftError {
  std::string message;               ///< description of the error
  std::string expected;              ///< what was expected, or empty
  std::optional<std::size_t> point;  ///< index of the point at fault, if it is a single one
};

/// Returns why a surface cannot pass through the section: no points, 2 points in a ring, more than 1000, numbers that
/// are not finite, or neighbours at equal positions. Also rings along a line, and rings that cross themselves when
/// projected along their area vector. Returns nothing for a valid section.
std::optional<LoftError> find_error(const LoftSection& section);

/// The ends of a loft that have a cap.
struct LoftCaps {
  bool first = true;  ///< closes a ring at the first section by a flat face
  bool last = true;   ///< closes a ring at the last section by a flat face
};

/// The mesh of a loft.
struct Loft {
  Mesh mesh;  ///< with normals and texture coordinates
  /// For each section, its first triangle and its number of triangles. A section has the triangles between it and the
  /// section before, and the triangles of its caps.
  std::vector<std::uint32_t> first_triangle;
};

/// Returns the surface through the sections in their order.
///
/// Sections with equally many points are joined point by point, others by shares of their length, from first point to
/// first point. A ring joins an open row as if the ring were cut at its first point. A loft with rings faces outward,
/// in either direction of the rings, if all rings run in one direction. A loft without rings faces the side from which
/// its rows run to the right while the surface goes up. A single ring is a flat face (with its last cap), seen from the
/// side where it runs counter-clockwise.
///
/// Normals are smooth, except along corners of a section that bend by more than 40°, at edges of caps, and at pointed
/// tips. u runs along each section by length from 0 to 1, and a ring has a second vertex at its first point. v runs by
/// the mean distance between sections, from 0 at the first to 1 at the last. On caps, both are as in a picture. Linear
/// in points, except for caps with bays. Sections with errors give as much of a surface as possible, and rings along a
/// line have no caps. Throws std::invalid_argument for sections without points and for numbers that are not finite.
Loft make_loft(std::span<const LoftSection> sections, LoftCaps caps = {});

}  // namespace meristem
