// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace meristem {

/// Statistics of many numbers; all are 0 if there are no numbers.
struct Distribution {
  std::size_t count = 0;  ///< how many numbers
  double mean = 0;        ///< arithmetic mean
  double spread = 0;      ///< standard deviation of these numbers, not of a population they stand for
  double low = 0;         ///< 5 % of the numbers are below
  double median = 0;      ///< half of the numbers are below
  double high = 0;        ///< 5 % are above
};

/// Numbers between two neighbours in rank are interpolated. Costs a sort.
Distribution distribution(std::vector<double> samples);

/// The value below which the `share` (0 to 1) of ascending numbers lies, linear between neighbours; 0 for none.
double quantile(std::span<const double> ascending, double share);

}  // namespace meristem
