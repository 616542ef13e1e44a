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

/// A list of points with the lines of a file on which they stand; `lines` may be empty.
struct MeasuredCurve {
  std::optional<int> rank;         ///< rank of the leaf on its stem, or a class of ranks
  std::optional<int> lindex;       ///< which one among the leaves of that rank
  std::optional<double> age;       ///< age of the leaf, in any unit
  std::vector<glm::dvec2> points;  ///< midribs: (x, y); widths: (s, r); in the unit of the file
  std::vector<int> lines;          ///< line of each point, from 1; may be empty
};

/// Reads a text with the columns x and y (away from the stem and up, of any unit) and, if there, rank, lindex and age;
/// a midrib is what stands together with equal ones of these. Points that repeat the one before are left out, with a
/// warning each. Throws an InputError with all other faults, also those of check_midrib, by their lines.
std::vector<MeasuredCurve> read_midribs(std::string_view text, const Limits& limits, std::vector<Diagnostic>& warnings);

/// Reads a text with the columns s (distance from the base) and r (width, or share of the widest) and, if there, rank
/// or rankclass, and lindex. Repeats are treated as in read_midribs, faults are those of check_widths. Widths that run
/// from the tip to the base are turned about, with a warning each.
std::vector<MeasuredCurve> read_widths(std::string_view text, const Limits& limits, std::vector<Diagnostic>& warnings);

/// Throws an InputError if a midrib has fewer than 3 points, two equal ones in a row (nearer than a millionth of its
/// length), or numbers that are not finite or above 1e9.
void check_midrib(const MeasuredCurve& midrib);

/// Throws an InputError if widths have fewer than 3 rows, positions that neither rise nor fall all along, two equal
/// positions (as of midribs), numbers that are not finite or above 1e9, a position below 0, a width below 0, or no
/// width above 0.
void check_widths(const MeasuredCurve& widths);

/// Whether widths are listed from the tip to the base (falling s), or measured from the tip (narrow where s begins and
/// wide where it ends); turns them about.
bool turn_to_base(MeasuredCurve& widths);

}  // namespace meristem
