// SPDX-License-Identifier: Apache-2.0
// How a value differs from plant to plant: a distribution that each plant draws from by its own key.
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

/// A distribution. Numbers are drawn until one lies from `low` to `high`.
struct Variation {
  /// The kind of distribution, and what its `numbers` are.
  enum class Kind {
    uniform,      ///< numbers: the two ends
    log_uniform,  ///< the two ends, above 0; the logarithm is uniform
    normal,       ///< mean and standard deviation
    lognormal,    ///< median, and standard deviation of the natural logarithm
    triangular,   ///< lower end, most frequent value, upper end
    integer,      ///< the two ends, both included; whole numbers
    choice,       ///< one of `choices`
  };
  Kind kind = Kind::uniform;    ///< kind of distribution
  std::vector<double> numbers;  ///< parameters, as the kind says
  std::vector<Value> choices;   ///< values to choose from, for Kind::choice
  std::vector<double> weights;  ///< one per choice, above 0 in all; empty: all alike
  std::optional<double> low;    ///< unset: not bounded
  std::optional<double> high;   ///< unset: not bounded

  /// The value of this key: the same one on every machine.
  Value draw(RandomKey key) const;
  /// The share of the distribution that lies from `low` to `high`, about; 1 for choices.
  double share_within() const;
  /// The values at both ends, as far as there are any, and all choices.
  std::vector<Value> ends() const;
  /// Whether all values are numbers.
  bool is_number() const;
};

/// Reads {"normal": [0.1, 0.02], "within": [0.05, 0.2]}, or {"choice": [1, 2, 4], "weights": [3, 2, 1]}. Nothing with
/// faults at their places.
std::optional<Variation> read_variation(const Value& value, const DocumentPath& path, ParameterReader& reader);

}  // namespace meristem
