// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/track.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace meristem::track_test {

using Way = KeyTrack::Way;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Track, HasTheValuesOfItsKeysAtTheirTimes) {
  for (const Way way : {Way::linear, Way::smooth, Way::step}) {
    const KeyTrack track({{0, 0.05}, {1.5, 3, way}, {4, -2, way}, {7, -2, way}, {9, 1, way}});
    for (const KeyTrack::Key& key : track.keys()) EXPECT_EQ(track.at(key.time), key.value);
    EXPECT_EQ(track.at(-5), 0.05);
    EXPECT_EQ(track.at(100), 1);
  }
}

TEST(Track, GoesEvenlyAtOnceOrSmoothlyBetweenThem) {
  EXPECT_DOUBLE_EQ(KeyTrack({{0, 1}, {4, 3}}).at(1), 1.5);
  EXPECT_EQ(KeyTrack({{0, 1}, {4, 3, Way::step}}).at(3.999), 1);
  // A cubic with slope 0 at both ends is the smooth step.
  const KeyTrack smooth({{0, 0}, {1, 1, Way::smooth}});
  for (const double t : {0.1, 0.25, 0.5, 0.9}) EXPECT_DOUBLE_EQ(smooth.at(t), t * t * (3 - 2 * t));
}

TEST(Track, SmoothKeysRiseAndFallWithTheirKeysAndNeverBeyondThem) {
  const KeyTrack track(
      {{0, 0}, {1, 0.01, Way::smooth}, {1.2, 5, Way::smooth}, {6, 5.1, Way::smooth}, {7, 0, Way::smooth}});
  for (std::size_t k = 1; k < track.keys().size(); ++k) {
    const KeyTrack::Key& from = track.keys()[k - 1];
    const KeyTrack::Key& to = track.keys()[k];
    const double sign = to.value > from.value ? 1 : -1;
    double last = from.value;
    for (int n = 1; n <= 1000; ++n) {
      const double value = track.at(from.time + (to.time - from.time) * n / 1000);
      EXPECT_GE(sign * (value - last), 0) << "segment " << k << " at " << n;
      last = value;
    }
  }
}

TEST(Track, SmoothKeysHaveNoKinks) {
  const KeyTrack track({{0, 0}, {1, 1, Way::smooth}, {3, 4, Way::smooth}, {4, 6, Way::smooth}});
  constexpr double kStep = 1e-6;
  for (const double key : {1.0, 3.0}) {
    const double before = (track.at(key) - track.at(key - kStep)) / kStep;
    const double after = (track.at(key + kStep) - track.at(key)) / kStep;
    EXPECT_NEAR(before, after, 1e-4);
    EXPECT_GT(after, 0.5);
  }
}

TEST(Track, TellsSinceWhenALevelIsHeld) {
  const KeyTrack linear({{1, 0}, {5, 8}});
  EXPECT_DOUBLE_EQ(linear.since(2, 4), 2);
  EXPECT_EQ(linear.since(2, 1.9), kInfinity);
  EXPECT_EQ(linear.since(0, 3), -kInfinity);
  const KeyTrack smooth({{0, 0}, {2, 4, Way::smooth}});
  EXPECT_NEAR(smooth.at(smooth.since(1, 5)), 1, 1e-12);
  EXPECT_EQ(KeyTrack({{0, 0}, {2, 4, Way::step}}).since(3, 2.5), 2);
  // If a level is reached twice, the time counts from the later one.
  const KeyTrack twice({{0, 0}, {1, 2}, {2, 0}, {4, 2}});
  EXPECT_DOUBLE_EQ(twice.since(1, 1), 0.5);
  EXPECT_DOUBLE_EQ(twice.since(1, 10), 3);
}

TEST(Track, RefusesKeysWithoutOrder) {
  EXPECT_THROW(KeyTrack({}), std::invalid_argument);
  EXPECT_THROW(KeyTrack({{1, 0}, {1, 2}}), std::invalid_argument);
  EXPECT_THROW(KeyTrack({{2, 0}, {1, 2}}), std::invalid_argument);
}

}  // namespace meristem::track_test
