// SPDX-License-Identifier: Apache-2.0
// Among all functions f with a given sum of squares from the data, the natural cubic spline that minimises
//   sum of w (y - f(x))^2  +  roughness * integral of f''^2
// is the one with the least integral, for the right roughness, which is found by bisection: the distance rises with it.
// For one roughness the second derivatives c at the inner points solve a system of five bands,
//   (R + roughness * Q' W^-1 Q) c = Q' y,   and   f = y - roughness * W^-1 Q c.
// Based on: C. H. Reinsch: Smoothing by spline functions (1967); P. J. Green, B. W. Silverman: Nonparametric regression
// and generalized linear models (1994), section 2.3.
#include "meristem/base/smoothing_spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace meristem {

namespace {

constexpr int kHalvings = 50;
constexpr double kNear = 1e-3;    // of the distance, to which it is met
constexpr double kLeast = 1e-12;  // roughness, over that of the unit: all but the values themselves
constexpr double kMost = 1e12;    // all but straight lines

void check(std::span<const double> x, const std::vector<std::vector<double>>& values, double distance,
           std::span<const double> weights) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw std::invalid_argument(message);
  };
  const auto are_finite = [](std::span<const double> all) {
    return std::all_of(all.begin(), all.end(), [](double value) { return std::isfinite(value); });
  };
  require(are_finite(x) && std::adjacent_find(x.begin(), x.end(), std::greater_equal<>()) == x.end(),
          "the positions of a smoothing spline rise");
  for (const std::vector<double>& of_one : values) {
    require(of_one.size() == x.size(), "a smoothing spline has a value per position");
    require(are_finite(of_one), "the values of a smoothing spline are finite");
  }
  require(weights.empty() || weights.size() == x.size(), "a smoothing spline has a weight per position");
  require(std::all_of(weights.begin(), weights.end(), [](double weight) { return weight > 0; }),
          "the weights of a smoothing spline are above 0");
  require(std::isfinite(distance) && distance >= 0, "the distance of a smoothing spline is at least 0");
}

class Smoother {
 public:
  Smoother(std::span<const double> x, std::span<const double> weights) : inner_(x.size() - 2) {
    for (std::size_t i = 0; i + 1 < x.size(); ++i) steps_.push_back(x[i + 1] - x[i]);
    inverse_weights_.assign(x.size(), 1);
    weights_ = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!weights.empty()) inverse_weights_[i] = 1 / weights[i];
      weights_ += 1 / inverse_weights_[i];
    }
    const double length = x.back() - x.front();
    unit_ = length * length * length / static_cast<double>(x.size());
    bands_.resize(inner_);
    factors_.resize(inner_);
    for (std::size_t i = 0; i < inner_; ++i) {
      // Row i of Q': the second difference about the inner point i + 1.
      const double left = 1 / steps_[i], right = 1 / steps_[i + 1];
      differences_.push_back({left, -left - right, right});
    }
  }

  /// Sets the roughness, in multiples of one that suits the length.
  void set(double roughness) {
    roughness_ = roughness * unit_;
    for (std::size_t i = 0; i < inner_; ++i) {
      bands_[i] = {(steps_[i] + steps_[i + 1]) / 3, i + 1 < inner_ ? steps_[i + 1] / 6 : 0, 0};
      for (std::size_t band = 0; band < 3 && i + band < inner_; ++band) {
        double product = 0;
        for (std::size_t k = band; k < 3; ++k) {
          product += differences_[i][k] * differences_[i + band][k - band] * inverse_weights_[i + k];
        }
        bands_[i][band] += roughness_ * product;
      }
    }
    factorize();
  }

  /// The smoothed values, and the weighted squares of how far they are from the given ones.
  double apply(const std::vector<double>& given, std::vector<double>& smooth) {
    second_.resize(inner_);
    for (std::size_t i = 0; i < inner_; ++i) {
      second_[i] =
          differences_[i][0] * given[i] + differences_[i][1] * given[i + 1] + differences_[i][2] * given[i + 2];
    }
    solve(second_);
    smooth = given;
    double squares = 0;
    for (std::size_t i = 0; i < given.size(); ++i) {
      double bend = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        if (i >= k && i - k < inner_) bend += differences_[i - k][k] * second_[i - k];
      }
      const double shift = roughness_ * inverse_weights_[i] * bend;
      smooth[i] -= shift;
      squares += shift * shift / inverse_weights_[i];
    }
    return squares;
  }

  double weights() const { return weights_; }

 private:
  /// L D L' of the banded matrix.
  void factorize() {
    for (std::size_t i = 0; i < inner_; ++i) {
      double diagonal = bands_[i][0], next = bands_[i][1];
      if (i >= 1) {
        diagonal -= factors_[i - 1][0] * factors_[i - 1][1] * factors_[i - 1][1];
        next -= factors_[i - 1][0] * factors_[i - 1][1] * factors_[i - 1][2];
      }
      if (i >= 2) diagonal -= factors_[i - 2][0] * factors_[i - 2][2] * factors_[i - 2][2];
      factors_[i] = {diagonal, next / diagonal, bands_[i][2] / diagonal};
    }
  }

  void solve(std::vector<double>& column) const {
    for (std::size_t i = 0; i < inner_; ++i) {
      if (i >= 1) column[i] -= factors_[i - 1][1] * column[i - 1];
      if (i >= 2) column[i] -= factors_[i - 2][2] * column[i - 2];
    }
    for (std::size_t i = inner_; i-- > 0;) {
      column[i] /= factors_[i][0];
      if (i + 1 < inner_) column[i] -= factors_[i][1] * column[i + 1];
      if (i + 2 < inner_) column[i] -= factors_[i][2] * column[i + 2];
    }
  }

  using Bands = std::array<double, 3>;

  std::size_t inner_;
  std::vector<double> steps_;
  std::vector<double> inverse_weights_;
  std::vector<Bands> differences_;  // of Q', by inner point: on the points before, at and after it
  std::vector<Bands> bands_;        // diagonal and the two above it
  std::vector<Bands> factors_;      // D, and the two columns of L below each diagonal
  std::vector<double> second_;
  double roughness_ = 0, unit_ = 1, weights_ = 0;
};

}  // namespace

std::vector<std::vector<double>> smooth_values(std::span<const double> x, std::vector<std::vector<double>> values,
                                               double distance, std::span<const double> weights) {
  check(x, values, distance, weights);
  if (x.size() < 3 || distance == 0) return values;
  Smoother smoother(x, weights);
  std::vector<std::vector<double>> smooth(values.size());
  const double wanted = distance * distance * smoother.weights();
  const auto squares_at = [&](double roughness) {
    smoother.set(roughness);
    double squares = 0;
    for (std::size_t k = 0; k < values.size(); ++k) squares += smoother.apply(values[k], smooth[k]);
    return squares;
  };
  double low = kLeast, high = kMost;
  if (squares_at(high) <= wanted) return smooth;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = std::sqrt(low * high);
    const double squares = squares_at(middle);
    if (squares <= wanted && squares >= (1 - 2 * kNear) * wanted) return smooth;
    (squares > wanted ? high : low) = middle;
  }
  squares_at(low);
  return smooth;
}

}  // namespace meristem
