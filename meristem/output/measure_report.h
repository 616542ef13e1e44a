// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "meristem/graph/table/value.h"
#include "meristem/measure/measures.h"

namespace meristem {

/// What a report of measures shows.
struct MeasureReport {
  bool each = false;              ///< also the measures of each tree
  std::vector<std::string> only;  ///< names of the rows that are shown; empty: all
};

/// The measures as an object of numbers, lists and null by the names of their rows. Where there are layers, a list
/// "layers" of objects with "low", "high" (metres) and "leaf_area" follows, from the lowest. With MeasureReport::each,
/// a list "each" of objects follows, one per tree: "component", "instance" (null where not known), "position", and its
/// measures.
Value measures_value(const StandMeasures& measures, const MeasureReport& report);

/// The measures as lines for people: name, value with four digits, unit. With
/// MeasureReport::each, a block for each tree follows.
std::string measures_text(const StandMeasures& measures, const MeasureReport& report);

/// The manual's table of all measures, in Markdown.
std::string measures_reference();

}  // namespace meristem
