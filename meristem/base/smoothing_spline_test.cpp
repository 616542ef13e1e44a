// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/smoothing_spline.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/random.h"

namespace meristem::smoothing_spline_test {

using List = std::vector<double>;
using Matrix = std::vector<List>;

struct Sample {
  List x, y, weights;
};

/// Returns a noisy wave at uneven positions with uneven weights.
Sample noisy_wave(std::size_t count, std::uint64_t seed) {
  const RandomKey key(seed);
  Sample sample;
  double place = 0;
  for (std::size_t k = 0; k < count; ++k) {
    place += key.child("step").uniform(k, 0.2, 1.8);
    sample.x.push_back(place);
    sample.y.push_back(std::sin(0.7 * place) + 0.2 * key.child("noise").normal(k));
    sample.weights.push_back(key.child("weight").uniform(k, 0.5, 3));
  }
  return sample;
}

List smooth(const Sample& sample, double distance) {
  return smooth_values(sample.x, {sample.y}, distance, sample.weights)[0];
}

/// Returns the weighted root mean square distance.
double distance_of(const Sample& sample, const List& values) {
  double squares = 0, sum = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    squares += sample.weights[k] * (values[k] - sample.y[k]) * (values[k] - sample.y[k]);
    sum += sample.weights[k];
  }
  return std::sqrt(squares / sum);
}

/// Returns the least-squares line at the positions.
List line_through(const Sample& sample) {
  double w = 0, wx = 0, wy = 0, wxx = 0, wxy = 0;
  for (std::size_t k = 0; k < sample.x.size(); ++k) {
    const double weight = sample.weights[k], x = sample.x[k], y = sample.y[k];
    w += weight, wx += weight * x, wy += weight * y, wxx += weight * x * x, wxy += weight * x * y;
  }
  const double slope = (w * wxy - wx * wy) / (w * wxx - wx * wx);
  List line;
  for (const double x : sample.x) line.push_back((wy - slope * wx) / w + slope * x);
  return line;
}

/// Solves by Gaussian elimination with pivots.
List solved(Matrix a, List b) {
  const std::size_t count = b.size();
  for (std::size_t column = 0; column < count; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column; row < count; ++row) {
      if (std::abs(a[row][column]) > std::abs(a[pivot][column])) pivot = row;
    }
    std::swap(a[column], a[pivot]);
    std::swap(b[column], b[pivot]);
    for (std::size_t row = column + 1; row < count; ++row) {
      const double factor = a[row][column] / a[column][column];
      for (std::size_t k = column; k < count; ++k) a[row][k] -= factor * a[column][k];
      b[row] -= factor * b[column];
    }
  }
  for (std::size_t row = count; row-- > 0;) {
    for (std::size_t k = row + 1; k < count; ++k) b[row] -= a[row][k] * b[k];
    b[row] /= a[row][row];
  }
  return b;
}

/// Returns the matrix for the integral of the squared second derivative of the natural spline, as a function of its
/// values: Q R^-1 Q'.
Matrix roughness_of(const List& x) {
  const std::size_t count = x.size(), inner = count - 2;
  Matrix q(count, List(inner, 0)), r(inner, List(inner, 0)), k(count, List(count, 0));
  for (std::size_t j = 0; j < inner; ++j) {
    const double left = x[j + 1] - x[j], right = x[j + 2] - x[j + 1];
    q[j][j] = 1 / left;
    q[j + 1][j] = -1 / left - 1 / right;
    q[j + 2][j] = 1 / right;
    r[j][j] = (left + right) / 3;
    if (j + 1 < inner) r[j][j + 1] = r[j + 1][j] = right / 6;
  }
  for (std::size_t column = 0; column < count; ++column) {
    List of_column;
    for (std::size_t j = 0; j < inner; ++j) of_column.push_back(q[column][j]);
    const List second = solved(r, of_column);
    for (std::size_t row = 0; row < count; ++row) {
      for (std::size_t j = 0; j < inner; ++j) k[row][column] += q[row][j] * second[j];
    }
  }
  return k;
}

TEST(SmoothingSpline, DistanceOfNothingLeavesTheValues) {
  const Sample sample = noisy_wave(12, 1);
  EXPECT_EQ(smooth(sample, 0), sample.y);
}

TEST(SmoothingSpline, ALargeDistanceGivesTheLeastSquaresLine) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Sample sample = noisy_wave(15, seed);
    const List line = line_through(sample), values = smooth(sample, 10);
    for (std::size_t k = 0; k < line.size(); ++k) EXPECT_NEAR(values[k], line[k], 1e-8);
  }
}

TEST(SmoothingSpline, MeetsTheDistance) {
  for (const double distance : {0.001, 0.01, 0.05, 0.2}) {
    for (const std::size_t count : {4, 12, 100}) {
      const Sample sample = noisy_wave(count, 5);
      if (distance_of(sample, line_through(sample)) < distance) continue;
      const double reached = distance_of(sample, smooth(sample, distance));
      EXPECT_LE(reached, distance * (1 + 1e-9)) << count;
      EXPECT_GT(reached, distance * 0.998) << count;
    }
  }
}

TEST(SmoothingSpline, LinesComeOutAsTheyAre) {
  Sample sample = noisy_wave(9, 2);
  for (std::size_t k = 0; k < sample.x.size(); ++k) sample.y[k] = 3 - 2 * sample.x[k];
  for (const double distance : {1e-4, 1.0}) {
    const List values = smooth(sample, distance);
    for (std::size_t k = 0; k < values.size(); ++k) EXPECT_NEAR(values[k], sample.y[k], 1e-11);
  }
}

TEST(SmoothingSpline, LessDistanceIsRougher) {
  const Sample sample = noisy_wave(14, 3);
  const Matrix roughness = roughness_of(sample.x);
  double last = 0;
  for (const double distance : {0.3, 0.2, 0.1, 0.05, 0.0}) {
    const List values = smooth(sample, distance);
    double now = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      for (std::size_t j = 0; j < values.size(); ++j) now += values[i] * roughness[i][j] * values[j];
    }
    EXPECT_GT(now, last);
    last = now;
  }
}

TEST(SmoothingSpline, FollowsTheScaleOfPlacesAndOfValues) {
  const Sample sample = noisy_wave(13, 4);
  const List plain = smooth(sample, 0.1);
  Sample scaled = sample;
  for (double& x : scaled.x) x = 1000 * x - 7;
  for (double& y : scaled.y) y *= 0.001;
  const List values = smooth(scaled, 0.0001);
  for (std::size_t k = 0; k < plain.size(); ++k) EXPECT_NEAR(1000 * values[k], plain[k], 1e-6);
}

// For one roughness, the values solve (W + roughness K) f = W y. Each row of this equation gives the roughness.
TEST(SmoothingSpline, SolvesTheDenseEquationsOfGreenAndSilverman) {
  for (const std::size_t count : {3, 4, 5, 8, 20}) {
    const Sample sample = noisy_wave(count, count);
    const List values = smooth(sample, 0.5 * distance_of(sample, line_through(sample)));
    const Matrix k = roughness_of(sample.x);
    double over = 0, under = 0;
    List bend(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) bend[i] += k[i][j] * values[j];
      over += bend[i] * sample.weights[i] * (sample.y[i] - values[i]);
      under += bend[i] * bend[i];
    }
    Matrix all = k;
    List right;
    for (std::size_t i = 0; i < count; ++i) {
      for (double& entry : all[i]) entry *= over / under;
      all[i][i] += sample.weights[i];
      right.push_back(sample.weights[i] * sample.y[i]);
    }
    const List dense = solved(all, right);
    for (std::size_t i = 0; i < count; ++i) EXPECT_NEAR(values[i], dense[i], 1e-9) << count;
  }
}

TEST(SmoothingSpline, CoordinatesOfOneCurveTurnWithIt) {
  const Sample a = noisy_wave(16, 6), b = noisy_wave(16, 7);
  Matrix turned{List(16), List(16)};
  const double cosine = 0.6, sine = 0.8;
  for (std::size_t k = 0; k < 16; ++k) {
    turned[0][k] = cosine * a.y[k] - sine * b.y[k];
    turned[1][k] = sine * a.y[k] + cosine * b.y[k];
  }
  const Matrix plain = smooth_values(a.x, {a.y, b.y}, 0.1), after = smooth_values(a.x, turned, 0.1);
  for (std::size_t k = 0; k < 16; ++k) {
    EXPECT_NEAR(after[0][k], cosine * plain[0][k] - sine * plain[1][k], 1e-9);
    EXPECT_NEAR(after[1][k], sine * plain[0][k] + cosine * plain[1][k], 1e-9);
  }
}

TEST(SmoothingSpline, AHeavyPointStays) {
  Sample sample = noisy_wave(12, 8);
  sample.weights[4] = 1e6;
  EXPECT_NEAR(smooth(sample, 2e-4)[4], sample.y[4], 1e-5);
}

TEST(SmoothingSpline, FewerThanThreeValuesStay) {
  EXPECT_EQ(smooth_values(List{1, 2}, {{5, 7}}, 10)[0], (List{5, 7}));
  EXPECT_EQ(smooth_values(List{}, {List{}}, 1)[0], List{});
}

TEST(SmoothingSpline, RejectsWhatIsNoFunction) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(smooth_values(List{0, 0, 1}, {{1, 2, 3}}, 1), std::invalid_argument);
  EXPECT_THROW(smooth_values(List{0, nan, 1}, {{1, 2, 3}}, 1), std::invalid_argument);
  EXPECT_THROW(smooth_values(List{0, 1, 2}, {{1, 2}}, 1), std::invalid_argument);
  EXPECT_THROW(smooth_values(List{0, 1, 2}, {{1, nan, 3}}, 1), std::invalid_argument);
  EXPECT_THROW(smooth_values(List{0, 1, 2}, {{1, 2, 3}}, -1), std::invalid_argument);
  EXPECT_THROW(smooth_values(List{0, 1, 2}, {{1, 2, 3}}, nan), std::invalid_argument);
  EXPECT_THROW(smooth_values(List{0, 1, 2}, {{1, 2, 3}}, 1, List{1, 1}), std::invalid_argument);
  EXPECT_THROW(smooth_values(List{0, 1, 2}, {{1, 2, 3}}, 1, List{1, 0, 1}), std::invalid_argument);
}

}  // namespace meristem::smoothing_spline_test
