// SPDX-License-Identifier: Apache-2.0
// Evaluates keyed values over time. Smooth keys use cubic Hermite segments whose slopes are limited so that each
// segment is monotone (source in track.h). Because segments are monotone, a bisection finds where a level is crossed.
#include "meristem/base/track.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "meristem/base/require.h"

namespace meristem {

namespace {

constexpr int kCrossingHalvings = 60;  // number of halvings of a segment when a crossing is sought; enough for all
                                       // digits of a double
constexpr double kForever = std::numeric_limits<double>::infinity();

/// Returns the slope at a key between two segments: the weighted harmonic mean of their slopes, or 0 if the values
/// turn. The result is at most three times the flatter slope, so that cubics through the key stay monotone.
double middle_slope(double before, double after, double length_before, double length_after) {
  if (before * after <= 0) return 0;
  const double weight_before = 2 * length_after + length_before;
  const double weight_after = length_after + 2 * length_before;
  return (weight_before + weight_after) / (weight_before / before + weight_after / after);
}

}  // namespace

KeyTrack::KeyTrack(std::vector<Key> keys) : keys_(std::move(keys)), slope_(keys_.size(), 0) {
  require(!keys_.empty(), "a track needs a key");
  const auto secant = [&](std::size_t k) {
    return (keys_[k + 1].value - keys_[k].value) / (keys_[k + 1].time - keys_[k].time);
  };
  for (std::size_t k = 1; k < keys_.size(); ++k) require(keys_[k - 1].time < keys_[k].time, "keys need rising times");
  for (std::size_t k = 1; k + 1 < keys_.size(); ++k) {
    if (keys_[k].way == Way::step || keys_[k + 1].way == Way::step) continue;
    slope_[k] =
        middle_slope(secant(k - 1), secant(k), keys_[k].time - keys_[k - 1].time, keys_[k + 1].time - keys_[k].time);
  }
}

double KeyTrack::at(double time) const {
  if (time >= keys_.back().time) return keys_.back().value;
  if (!(time > keys_.front().time)) return keys_.front().value;
  const auto next = std::ranges::upper_bound(keys_, time, {}, &Key::time);
  return between(static_cast<std::size_t>(next - keys_.begin()) - 1, time);
}

double KeyTrack::between(std::size_t segment, double time) const {
  const Key& from = keys_[segment];
  const Key& to = keys_[segment + 1];
  if (to.way == Way::step) return from.value;
  const double length = to.time - from.time;
  const double u = (time - from.time) / length;
  const double rise = to.value - from.value;
  if (to.way == Way::linear) return from.value + u * rise;
  // Cubic Hermite interpolation, as an increment on the first value.
  const double eased = u * u * (3 - 2 * u);
  const double bent = u * (1 - u) * ((1 - u) * slope_[segment] - u * slope_[segment + 1]) * length;
  const auto [low, high] = std::minmax(from.value, to.value);
  return std::clamp(from.value + eased * rise + bent, low, high);  // corrects only rounding errors
}

/// Returns the first time at which the value reaches a level, in a segment that rises to the level or above.
double KeyTrack::crossing(std::size_t segment, double level) const {
  const Key& from = keys_[segment];
  const Key& to = keys_[segment + 1];
  if (to.way == Way::step) return to.time;
  if (to.way == Way::linear) return from.time + (level - from.value) / (to.value - from.value) * (to.time - from.time);
  double below = from.time;
  double above = to.time;
  for (int k = 0; k < kCrossingHalvings; ++k) {
    const double middle = 0.5 * (below + above);
    (between(segment, middle) < level ? below : above) = middle;
  }
  return above;
}

double KeyTrack::since(double level, double by) const {
  if (at(by) < level) return kForever;
  // Segments are monotone, so the value was lower before if the segment begins lower.
  for (std::size_t k = keys_.size(); k-- > 1;) {
    if (keys_[k - 1].time > by || keys_[k - 1].value >= level) continue;
    return std::min(by, crossing(k - 1, level));
  }
  return -kForever;
}

}  // namespace meristem
