// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "meristem/graph/table/value.h"
#include "meristem/measure/measures.h"

namespace meristem {

/// Options of a report of measures.
struct MeasureReport {
  bool each = false;              ///< if true, also shows the measures of each tree
  std::vector<std::string> only;  ///< names of the rows to show; empty: all rows
};

/// Returns the measures as an object of numbers, lists and null, keyed by the names of their rows. If layers were
/// measured, a list "layers" follows, from the lowest layer, of objects with "low", "high" (metres) and "leaf_area".
/// With MeasureReport::each, a list "each" follows with one object per tree: "component", "instance" (null if unknown),
/// "position", and its measures.
Value measures_value(const StandMeasures& measures, const MeasureReport& report);

/// Returns the measures as lines for people: name, value with four digits, unit. With MeasureReport::each, a block for
/// each tree follows.
std::string measures_text(const StandMeasures& measures, const MeasureReport& report);

/// Returns the manual's table of all measures, in Markdown.
std::string measures_reference();

}  // namespace meristem
