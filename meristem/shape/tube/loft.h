// SPDX-License-Identifier: Apache-2.0
// Lofts: a surface through a row of sections, as the skin of a hull lies over its frames.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meristem/base/mesh.h"

namespace meristem {

/// Points in metres, in the order in which the section runs through them: an open row of at least 2, a ring of at least
/// 3 that closes from the last to the first (which is not repeated), or 1 point, in which the surface ends in a tip.
struct LoftSection {
  std::vector<Vec3> points;  ///< metres
  bool is_closed = true;     ///< true: a ring; false: an open row
  bool is_round = false;     ///< no corner of it is sharp, however few there are

  bool is_point() const { return points.size() == 1; }  ///< true for a single point
};

/// A fault of a section.
struct LoftFault {
  std::string message;               ///< what is wrong
  std::string expected;              ///< what was expected, or empty
  std::optional<std::size_t> point;  ///< at fault, where it is one
};

/// Why a surface cannot run through the section: no points, 2 in a ring, more than 1000, numbers that are not finite,
/// neighbours at the same position, rings along a line or, seen against their area, crossing themselves. Empty where it
/// can.
std::optional<LoftFault> find_fault(const LoftSection& section);

/// Which ends of a loft have a cap.
struct LoftCaps {
  bool first = true;  ///< closes a ring at the first section by a flat face
  bool last = true;   ///< closes a ring at the last section by a flat face
};

/// The mesh of a loft.
struct Loft {
  Mesh mesh;  ///< with normals and texture coordinates
  /// Where the triangles of each section begin, and their number. A section has the triangles between it and the
  /// section before, and those of the caps that lie on it.
  std::vector<std::uint32_t> first_triangle;
};

/// The surface through the sections in their order.
///
/// Sections with as many points are joined point by point, others by shares of their length, from first point to first
/// point; a ring meets an open row as if it were cut at its first point. What has rings faces outward, whichever way
/// round they run, if all run the same way. What has none faces the side from which its rows run to the right while
/// the surface goes up. A single ring is a flat face (with its last cap), seen from where it runs counter-clockwise.
///
/// Normals are smooth but for edges along corners of a section that bend by more than 40°, edges of caps, and pointed
/// tips. u runs along each section by its length from 0 to 1, and a ring has a second vertex at its first point; v runs
/// by the mean way between sections, from 0 at the first to 1 at the last; on caps both are as in a picture. Linear in
/// points, but for caps with bays. Sections with faults make as much of a surface as they can, rings along a line no
/// caps; throws std::invalid_argument for those without points and numbers that are not finite.
Loft make_loft(std::span<const LoftSection> sections, LoftCaps caps = {});

}  // namespace meristem
