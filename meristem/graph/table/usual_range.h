// SPDX-License-Identifier: Apache-2.0
// The range in which people move a number: what an editor's slider shows, narrower than what is allowed.
#pragma once

#include <utility>

#include "meristem/graph/table/parameter.h"

namespace meristem {

/// Whether a row holds numbers with a form of their own: one, or lists of them.
bool has_numbers(const Parameter& row);

/// The usual range of a row of numbers, in document units: what the row says; an end that it leaves open follows from
/// its default, its hard range and its unit. Both ends are finite, lie in the hard range (above it where its lower end
/// is excluded), are whole for whole numbers, and differ unless only one number is allowed; between them lie all
/// numbers of `fallback`, the row's default.
///
/// What is derived is the hard range where that is narrow: at most 2 wide, or 10 times the default's size. Else it goes
/// to 4 times the default, or where that is 0 or not given as far as the unit suggests, from 0, the hard minimum, or
/// the same below 0 where that is allowed.
UsualSpan usual_range(const Parameter& row, const Value& fallback);

/// The usual ranges of the first and of the second numbers of points. They are equal if the row has one range for both.
std::pair<UsualSpan, UsualSpan> usual_ranges_of_points(const Parameter& row, const Value& fallback);

}  // namespace meristem
