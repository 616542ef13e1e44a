// SPDX-License-Identifier: Apache-2.0
// Computes a smoothing spline with a given distance from the data. Among all functions f with a given sum of squares,
// the natural cubic spline that minimises
//   sum of w (y - f(x))^2  +  roughness * integral of f''^2
// has the smallest integral, for the right roughness. For one roughness, the second derivatives c at the inner points
// solve a system of five bands,
//   (R + roughness * Q' W^-1 Q) c = Q' y,   and   f = y - roughness * W^-1 Q c.
// The distance rises with the roughness, and the logarithms of both are nearly linear in each other. The secant rule
// therefore finds the right roughness in a few solutions. The result is the first roughness that meets the distance in
// a bisection of all numbers, so the values do not depend on the last digits of the search.
//
// Based on: C. H. Reinsch: Smoothing by spline functions (1967); P. J. Green, B. W. Silverman: Nonparametric regression
// and generalized linear models (1994), section 2.3.
#include "meristem/base/smoothing_spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "meristem/base/math.h"

namespace meristem {

namespace {

constexpr int kHalvings = 50;
constexpr double kNear = 1e-3;    // relative tolerance of the distance
constexpr double kMin = 1e-12;    // lowest roughness relative to its unit: nearly the given values
constexpr double kMax = 1e12;     // highest roughness: nearly straight lines
constexpr double kFirst = 1e-3;   // first roughness that is tried
constexpr int kSecants = 12;      // maximum number of secant steps; more help only if numbers lose their digits
constexpr double kStride = 12;    // maximum step of the logarithm of the roughness
constexpr double kFlat = 0.05;    // minimum slope of log(squares) by log(roughness); below it, the squares may have
                                  // stopped to rise
constexpr double kMargin = 0.25;  // extra width of a range of logarithms on either side, as a share of its width

void check(std::span<const double> x, const std::vector<std::vector<double>>& values, double distance,
           std::span<const double> weights) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw std::invalid_argument(message);
  };
  const auto are_finite = [](std::span<const double> all) {
    return std::all_of(all.begin(), all.end(), [](double value) { return std::isfinite(value); });
  };
  require(are_finite(x) && std::adjacent_find(x.begin(), x.end(), std::greater_equal<>()) == x.end(),
          "the positions of a smoothing spline must rise");
  for (const std::vector<double>& of_one : values) {
    require(of_one.size() == x.size(), "a smoothing spline needs one value per position");
    require(are_finite(of_one), "the values of a smoothing spline must be finite");
  }
  require(weights.empty() || weights.size() == x.size(), "a smoothing spline needs one weight per position");
  require(std::all_of(weights.begin(), weights.end(), [](double weight) { return weight > 0; }),
          "the weights of a smoothing spline must be above 0");
  require(std::isfinite(distance) && distance >= 0, "the distance of a smoothing spline must be at least 0");
}

// Two functions at once, which a processor solves in the time of one. An odd last function is paired with zeros.
using Pair [[gnu::vector_size(2 * sizeof(double))]] = double;

class Smoother {
 public:
  Smoother(std::span<const double> x, std::span<const double> weights, const std::vector<std::vector<double>>& given)
      : given_(given),
        points_(x.size()),
        inner_(x.size() - 2),
        weights_(points_, 1),
        inverse_weights_(points_),
        rows_(inner_ + 2 * kEdge),
        columns_((given.size() + 1) / 2) {
    if (!weights.empty()) weights_.assign(weights.begin(), weights.end());
    for (std::size_t i = 0; i < points_; ++i) inverse_weights_[i] = 1 / weights_[i];
    const double length = x.back() - x.front();
    unit_ = length * length * length / static_cast<double>(points_);
    for (std::size_t i = 0; i < inner_; ++i) {
      const double left = x[i + 1] - x[i], right = x[i + 2] - x[i + 1];
      row(i).difference = {1 / left, -(1 / left) - 1 / right, 1 / right};
      row(i).stiffness = {(left + right) / 3, i + 1 < inner_ ? right / 6 : 0};
    }
    for (std::size_t i = 0; i < inner_; ++i) {
      for (std::size_t band = 0; band < 3 && i + band < inner_; ++band) {
        for (std::size_t k = band; k < 3; ++k) {
          row(i).penalty[band] += row(i).difference[k] * row(i + band).difference[k - band] * inverse_weights_[i + k];
        }
      }
    }
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      columns_[c].differences.resize(inner_);
      columns_[c].second.resize(inner_ + 2 * kEdge);
      for (std::size_t lane = 0; lane < 2 && 2 * c + lane < given.size(); ++lane) {
        const std::vector<double>& of_one = given[2 * c + lane];
        for (std::size_t i = 0; i < inner_; ++i) {
          const Bands& q = row(i).difference;
          columns_[c].differences[i][lane] = q[0] * of_one[i] + q[1] * of_one[i + 1] + q[2] * of_one[i + 2];
        }
      }
    }
  }

  /// Returns the weighted sum of squared differences between smoothed and given values. `roughness` is a multiple of a
  /// unit that suits the length.
  double squares(double roughness) {
    roughness_ = roughness * unit_;
    factorize();
    double sum = 0;
    for (Column& column : columns_) {
      solve(column);
      Pair of_each{};
      for (std::size_t i = 0; i < points_; ++i) {
        const Pair off = shift(column, i);
        of_each += off * off * weights_[i];
      }
      sum += of_each[0];
      sum += of_each[1];
    }
    return sum;
  }

  /// Returns the smoothed values for the last roughness.
  std::vector<std::vector<double>> values() const {
    std::vector<std::vector<double>> smooth = given_;
    for (std::size_t k = 0; k < smooth.size(); ++k) {
      for (std::size_t i = 0; i < points_; ++i) smooth[k][i] -= shift(columns_[k / 2], i)[k % 2];
    }
    return smooth;
  }

  double weights() const { return std::accumulate(weights_.begin(), weights_.end(), 0.0); }

 private:
  static constexpr std::size_t kEdge = 2;  // number of zeros before the first and after the last inner point
  using Bands = std::array<double, 3>;
  struct Row {                          // one per inner point
    Bands difference{};                 // of Q': the second difference, on the points before, at and after the inner
                                        // point
    std::array<double, 2> stiffness{};  // of R, the diagonal and the band above it
    Bands penalty{};                    // of Q' W^-1 Q, the diagonal and the two bands above it
    Bands factors{};                    // 1 / D, and the two columns of L below each diagonal
  };
  struct Column {
    std::vector<Pair> differences;  // Q' y
    std::vector<Pair> second;       // c, with its edges
  };

  Row& row(std::size_t inner) { return rows_[inner + kEdge]; }

  /// Computes the decomposition L D L' of the banded matrix.
  void factorize() {
    struct Pivot {
      double diagonal = 0, near = 0, far = 0;  // D, and the two entries of L below it
    };
    Pivot before, before_that;
    for (std::size_t i = 0; i < inner_; ++i) {
      Row& here = row(i);
      Pivot pivot;
      pivot.diagonal = here.stiffness[0] + roughness_ * here.penalty[0] - before.diagonal * before.near * before.near -
                       before_that.diagonal * before_that.far * before_that.far;
      const double next = here.stiffness[1] + roughness_ * here.penalty[1] - before.diagonal * before.near * before.far;
      // Divide only once per row, because the next row waits for the result.
      const double inverse = 1 / pivot.diagonal;
      pivot.near = next * inverse;
      pivot.far = roughness_ * here.penalty[2] * inverse;
      here.factors = {inverse, pivot.near, pivot.far};
      before_that = before;
      before = pivot;
    }
  }

  void solve(Column& column) const {
    // Values beyond the edges are 0.
    Pair before{}, before_that{};
    for (std::size_t i = 0; i < inner_; ++i) {
      const Pair here = column.differences[i] - rows_[i + 1].factors[1] * before - rows_[i].factors[2] * before_that;
      column.second[i + kEdge] = here;
      before_that = before;
      before = here;
    }
    before = before_that = Pair{};
    for (std::size_t i = inner_; i-- > 0;) {
      const Bands& factors = rows_[i + kEdge].factors;
      const Pair here = column.second[i + kEdge] * factors[0] - factors[1] * before - factors[2] * before_that;
      column.second[i + kEdge] = here;
      before_that = before;
      before = here;
    }
  }

  /// Returns the amount that the last roughness subtracts from the values at point i.
  Pair shift(const Column& column, std::size_t i) const {
    const Row* const rows = rows_.data() + i;
    const Pair* const second = column.second.data() + i;
    const Pair bend =
        rows[2].difference[0] * second[2] + rows[1].difference[1] * second[1] + rows[0].difference[2] * second[0];
    return roughness_ * inverse_weights_[i] * bend;
  }

  const std::vector<std::vector<double>>& given_;
  std::size_t points_, inner_;
  std::vector<double> weights_, inverse_weights_;
  std::vector<Row> rows_;  // with the rows at the edges
  std::vector<Column> columns_;
  double roughness_ = 0, unit_ = 1;
};

/// A range of roughness.
struct Range {
  double min = 0, max = std::numeric_limits<double>::infinity();
  bool rises = false;  ///< the squares still rise beyond the range
};

/// Returns a range that contains all roughnesses whose squares are at most `max` and at least 2 * kNear (relative)
/// below it. Returns the range of all numbers if the secant rule fails.
Range find_roughness(Smoother& smoother, double max) {
  const double wanted = math::log(max * (1 - kNear));
  double logarithm = math::log(kFirst), found = math::log(smoother.squares(kFirst));
  double slope = 1;
  for (int k = 0; k < kSecants; ++k) {
    const double step = std::clamp((wanted - found) / slope, -kStride, kStride);
    const double next = math::log(smoother.squares(math::exp(logarithm + step)));
    slope = (next - found) / step;
    logarithm += step;
    found = next;
    if (!(slope > 0)) break;
    if (std::abs(wanted - found) > kNear) continue;
    const double middle = logarithm + (wanted - found) / slope;
    const double reach = (1 + 2 * kMargin) * kNear / slope;
    return {math::exp(middle - reach), math::exp(middle + reach), slope > kFlat};
  }
  return {};
}

}  // namespace

std::vector<std::vector<double>> smooth_values(std::span<const double> x, std::vector<std::vector<double>> values,
                                               double distance, std::span<const double> weights) {
  check(x, values, distance, weights);
  if (x.size() < 3 || distance == 0) return values;
  Smoother smoother(x, weights, values);
  const double wanted = distance * distance * smoother.weights();
  const Range likely = find_roughness(smoother, wanted);
  // Straight lines can be near enough.
  if (!likely.rises && smoother.squares(kMax) <= wanted) return smoother.values();
  double low = kMin, high = kMax;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = std::sqrt(low * high);
    double squares = middle < likely.min ? 0 : std::numeric_limits<double>::infinity();
    if (middle >= likely.min && middle <= likely.max) {
      squares = smoother.squares(middle);
      if (squares <= wanted && squares >= (1 - 2 * kNear) * wanted) return smoother.values();
    }
    (squares > wanted ? high : low) = middle;
  }
  smoother.squares(low);
  return smoother.values();
}

}  // namespace meristem
