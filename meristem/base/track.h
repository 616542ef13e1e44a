// SPDX-License-Identifier: Apache-2.0
// A number over time, given by keys.
//
// Based on: F. N. Fritsch, J. Butland: A method for constructing local monotone piecewise cubic interpolants (1984),
// for smooth keys.
#pragma once

#include <vector>

namespace meristem {

/// Values at given times, with monotone interpolation between them: no value lies outside the values of the two keys
/// around it.
class KeyTrack {
 public:
  /// Interpolation from the key before to this key.
  enum class Way {
    linear,  ///< at constant speed
    smooth,  ///< by a monotone cubic, with slope 0 where the values turn and at the first and last key
    step,    ///< jumps at the time of the key
  };
  /// A value at one time.
  struct Key {
    double time = 0;        ///< seconds
    double value = 0;       ///< in the unit of the number that the track drives
    Way way = Way::linear;  ///< interpolation from the key before

    bool operator==(const Key&) const = default;
  };

  /// `keys` must have at least one key, with ascending times.
  explicit KeyTrack(std::vector<Key> keys);

  /// Returns all keys, ascending by time.
  const std::vector<Key>& keys() const { return keys_; }
  /// Returns the value at a time. Before the first key, this is the first key's value, and after the last key the last
  /// key's value.
  double at(double time) const;
  /// Returns the time since which the value has been at least `level` without a break until the time `by`. Returns
  /// minus infinity if it always was, and plus infinity if it is below at `by`.
  double since(double level, double by) const;

 private:
  double between(std::size_t segment, double time) const;
  double crossing(std::size_t segment, double level) const;

  std::vector<Key> keys_;
  std::vector<double> slope_;  // for each key, per second; used only for smooth interpolation
};

}  // namespace meristem
