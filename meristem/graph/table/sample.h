// SPDX-License-Identifier: Apache-2.0
// Measured values as a distribution: {"sample": [38, 42, 55]}, or of a file's column {"sample": {"file": "angles.csv",
// "column": "angle"}}. Each instance has one of the values, each as likely as any other; with "smooth" it has one that
// may lie between two neighbours in their order, too.
#pragma once

#include <memory>
#include <vector>

#include "meristem/graph/table/parameter.h"

namespace meristem {

class DocumentPath;

/// In document units.
struct Sample {
  std::vector<double> values;  ///< at least one; rising
  bool is_smooth = false;

  /// The value below which this share of all lies, from 0 up to 1 without it. Smooth: on the straight lines between
  /// neighbouring values, the lowest at 0 and the highest at 1.
  double quantile(double share) const;
};

/// The sample of a number, from the object that has it with its `smooth`. Faults for values out of the row's range,
/// whole ones that are fractions, files and columns that are not there, and texts for numbers, each at its path; null
/// after one.
std::shared_ptr<const Sample> read_sample(const Parameter& row, const Value& object, const DocumentPath& path,
                                          ParameterReader& reader);

}  // namespace meristem
