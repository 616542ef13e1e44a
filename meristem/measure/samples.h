// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace meristem {

/// Statistics of a list of numbers. All fields are 0 if the list is empty.
struct SampleStatistics {
  std::size_t count = 0;  ///< how many numbers
  double mean = 0;        ///< arithmetic mean
  double spread = 0;      ///< standard deviation of these numbers, not of a population that they represent
  double low = 0;         ///< 5 % of the numbers are below
  double median = 0;      ///< half of the numbers are below
  double high = 0;        ///< 5 % are above
};

/// Computes the statistics of `samples`. Quantiles are interpolated between neighbours in rank. The cost is one sort.
SampleStatistics distribution(std::vector<double> samples);

/// Returns the value below which a share (0 to 1) of `ascending` lies, linear between neighbours. Returns 0 for an
/// empty list.
double quantile(std::span<const double> ascending, double share);

}  // namespace meristem
