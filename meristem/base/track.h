// SPDX-License-Identifier: Apache-2.0
// A number over time, given by keys.
//
// Based on: F. N. Fritsch, J. Butland: A method for constructing local monotone piecewise cubic interpolants (1984),
// for smooth keys.
#pragma once

#include <vector>

namespace meristem {

/// Values at times, and between them one way each: no value lies beyond those of the two keys around it.
class Track {
 public:
  /// How the value comes to a key from the key before.
  enum class Way {
    linear,  ///< evenly
    smooth,  ///< by a monotone cubic, which begins and ends at rest where the values turn or the keys begin and end
    step,    ///< at once, at the key's time
  };
  /// A value at a time.
  struct Key {
    double time = 0;        ///< seconds
    double value = 0;       ///< in the unit of the number that the track drives
    Way way = Way::linear;  ///< how the value comes here from the key before

    bool operator==(const Key&) const = default;
  };

  /// At least one key, at rising times.
  explicit Track(std::vector<Key> keys);

  /// All keys, by rising time.
  const std::vector<Key>& keys() const { return keys_; }
  /// The value at a time: the first key's before it, the last key's after it.
  double at(double time) const;
  /// The time since which the value has been at least `level` without a break up to the time `by`: minus infinity where
  /// it always was, plus infinity where it is below at `by`.
  double since(double level, double by) const;

 private:
  double between(std::size_t segment, double time) const;
  double crossing(std::size_t segment, double level) const;

  std::vector<Key> keys_;
  std::vector<double> slope_;  // by key, per second; meant for smooth ways alone
};

}  // namespace meristem
