// SPDX-License-Identifier: Apache-2.0
// Describes a list of numbers by mean, standard deviation and quantiles. A quantile is interpolated between the two
// nearest ranks of the sorted list.
#include "meristem/measure/samples.h"

#include <algorithm>
#include <cmath>

namespace meristem {

SampleStatistics distribution(std::vector<double> samples) {
  if (samples.empty()) return {};
  std::sort(samples.begin(), samples.end());
  const auto count = static_cast<double>(samples.size());
  double sum = 0;
  for (const double sample : samples) sum += sample;
  const double mean = sum / count;
  double squares = 0;
  for (const double sample : samples) squares += (sample - mean) * (sample - mean);
  return {.count = samples.size(),
          .mean = mean,
          .spread = std::sqrt(squares / count),
          .low = quantile(samples, 0.05),
          .median = quantile(samples, 0.5),
          .high = quantile(samples, 0.95)};
}

double quantile(std::span<const double> ascending, double share) {
  if (ascending.empty()) return 0;
  const double rank = share * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  return ascending[below] + (rank - static_cast<double>(below)) * (ascending[above] - ascending[below]);
}

}  // namespace meristem
