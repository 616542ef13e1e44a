// SPDX-License-Identifier: Apache-2.0
// Measured values as a distribution: {"sample": [38, 42, 55]}, or a column of a file {"sample": {"file": "angles.csv",
// "column": "angle"}}. Each instance gets one of the values, all equally likely. With "smooth", an instance gets a
// value that may lie between two neighbouring values.
#pragma once

#include <memory>
#include <vector>

#include "meristem/graph/table/parameter.h"

namespace meristem {

class DocumentPath;
class FileReader;
class NumberReader;
class ReadErrors;

/// The sorted values of a sample, in document units.
struct Sample {
  std::vector<double> values;  ///< at least one; rising
  bool is_smooth = false;

  /// Returns the value below which `share` of all values lie; `share` is from 0 to below 1. A smooth sample is
  /// interpolated linearly between neighbouring values, from the lowest at 0 to the highest at 1.
  double quantile(double share) const;
};

/// The readers that a sample needs.
struct SampleReaders {
  NumberReader& numbers;  ///< for a list of numbers
  FileReader& files;      ///< for a column of a file
  ReadErrors& errors;     ///< for everything else that is wrong
};

/// Reads the sample of a number from the object that contains it and its `smooth`. Reports values out of the row's
/// range, fractions for whole numbers, missing files and columns, and texts instead of numbers, each at its path.
/// Returns null after an error.
std::shared_ptr<const Sample> read_sample(const Parameter& row, const Value& object, const DocumentPath& path,
                                          const SampleReaders& readers);

}  // namespace meristem
