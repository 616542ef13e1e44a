// SPDX-License-Identifier: Apache-2.0
// The range of an editor's slider: the range in which people usually set a number, narrower than the hard range.
#pragma once

#include <utility>

#include "meristem/graph/table/parameter.h"

namespace meristem {

/// Returns true if a row contains a number, or lists of numbers, with a range.
bool has_numbers(const Parameter& row);

/// Returns the usual range of a row of numbers, in document units. The row can set its ends. A missing end is derived
/// from the default, the hard range and the unit.
///
/// Both ends are finite and within the hard range, and whole for whole numbers. They differ unless only one number is
/// allowed. All numbers of `fallback`, the row's default, lie between them.
///
/// A narrow hard range (at most 2 wide, or 10 times the default) is the usual range. Otherwise the upper end is 4 times
/// the default. If the default is 0 or missing, the unit determines the upper end. The lower end is 0, the hard
/// minimum, or the negative upper end if negative numbers are allowed.
UsualSpan usual_range(const Parameter& row, const Value& fallback);

/// The usual ranges of the first and of the second numbers of points. They are equal if the row has one range for both.
std::pair<UsualSpan, UsualSpan> usual_ranges_of_points(const Parameter& row, const Value& fallback);

}  // namespace meristem
