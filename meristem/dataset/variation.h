// SPDX-License-Identifier: Apache-2.0
// The variation of a value from plant to plant: a distribution from which each plant draws with its own key.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "meristem/base/random.h"
#include "meristem/graph/table/reader.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// A distribution. Numbers are drawn until one lies between `low` and `high`.
struct ValueVariation {
  /// The kind of distribution, and the meaning of its `numbers`.
  enum class Kind {
    uniform,      ///< lower and upper end
    log_uniform,  ///< lower and upper end, above 0; the logarithm is uniform
    normal,       ///< mean and standard deviation
    lognormal,    ///< median, and standard deviation of the natural logarithm
    triangular,   ///< lower end, most frequent value, upper end
    integer,      ///< lower and upper end, both included; whole numbers
    choice,       ///< one of `choices`
  };
  Kind kind = Kind::uniform;    ///< kind of distribution
  std::vector<double> numbers;  ///< parameters of the distribution, by its kind
  std::vector<Value> choices;   ///< values to choose from, for Kind::choice
  std::vector<double> weights;  ///< one per choice, with a sum above 0; empty: equal weights
  std::optional<double> low;    ///< lower bound; unset: no bound
  std::optional<double> high;   ///< upper bound; unset: no bound

  /// Returns the value for this key, equal on every machine.
  Value draw(RandomKey key) const;
  /// Returns the approximate share of the distribution between `low` and `high`. Returns 1 for choices.
  double share_within() const;
  /// Returns the values at both ends, if the distribution has ends, and all choices.
  std::vector<Value> ends() const;
  /// Returns true if all values are numbers.
  bool is_number() const;
};

/// Reads {"normal": [0.1, 0.02], "within": [0.05, 0.2]}, or {"choice": [1, 2, 4], "weights": [3, 2, 1]}. Reports faults
/// at their positions, and then returns nothing.
std::optional<ValueVariation> read_variation(const Value& value, const DocumentPath& path, ParameterReader& reader);

}  // namespace meristem
