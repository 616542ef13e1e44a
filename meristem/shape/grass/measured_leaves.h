// SPDX-License-Identifier: Apache-2.0
// Measured leaves: digitised midribs, and widths along blades.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "meristem/base/diagnostic.h"
#include "meristem/base/limits.h"

namespace meristem {

/// A list of points with their lines in a file. `lines` may be empty.
struct MeasuredCurve {
  std::optional<int> rank;         ///< rank of the leaf on its stem, or a class of ranks
  std::optional<int> lindex;       ///< number among the leaves of that rank
  std::optional<double> age;       ///< age of the leaf, in any unit
  std::vector<glm::dvec2> points;  ///< midribs: (x, y); widths: (s, r); in the unit of the file
  std::vector<int> lines;          ///< line of each point, from 1; may be empty
};

/// Reads a text with the columns x and y (away from the stem and up, in any unit) and optionally rank, lindex and age.
/// Points with equal values of these belong to one midrib. Points that repeat the point before are left out with a
/// warning each. Throws an InputError with all other errors by line, including the errors of check_midrib.
std::vector<MeasuredCurve> read_midribs(std::string_view text, const SizeLimits& limits,
                                        std::vector<Diagnostic>& warnings);

/// Reads a text with the columns s (distance from the base) and r (width, or share of the widest) and optionally rank
/// or rankclass, and lindex. Repetitions are handled as in read_midribs, and errors are thrown as in check_widths.
/// Widths that run from the tip to the base are reversed with a warning each.
std::vector<MeasuredCurve> read_widths(std::string_view text, const SizeLimits& limits,
                                       std::vector<Diagnostic>& warnings);

/// Throws an InputError if a midrib has fewer than 3 points, two equal points in a row (nearer than a millionth of its
/// length), or numbers that are not finite or exceed 1e9.
void check_midrib(const MeasuredCurve& midrib);

/// Throws an InputError if widths have fewer than 3 rows, positions that are neither ascending nor descending, or two
/// equal positions (as in check_midrib). Also throws if a number is not finite or exceeds 1e9, if a position or width
/// is below 0, or if no width is above 0.
void check_widths(const MeasuredCurve& widths);

/// Reverses widths that are listed from the tip to the base (descending s), or measured from the tip (narrow at the
/// first s and wide at the last). Returns true if they were reversed.
bool turn_to_base(MeasuredCurve& widths);

}  // namespace meristem
