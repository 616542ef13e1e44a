// SPDX-License-Identifier: Apache-2.0
// Removes points of a leaf in the order of their error. The priority queue is a tree of pairwise comparisons over all
// points with the smallest error at its root. A change repeats only the comparisons above it, without unpredictable
// branches.
#include "meristem/shape/grass/reduce_leaf.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "meristem/shape/flat/segment.h"

namespace meristem {

namespace {

constexpr double kUnreachable = std::numeric_limits<double>::infinity();

/// Returns the squared distance of the k-th point of a curve from the segment between two others.
double squared_distance(const std::vector<double>& x, const std::vector<double>& y, std::size_t k, std::size_t a,
                        std::size_t b) {
  const glm::dvec2 away = from_segment({x[k] - x[a], y[k] - y[a]}, {x[b] - x[a], y[b] - y[a]});
  return glm::dot(away, away);
}

/// Finds the minimum of many numbers. Ties go to the lower index.
class MinOf {
 public:
  explicit MinOf(std::size_t count)
      : leaves_(std::bit_ceil(count)), min_(2 * leaves_, kUnreachable), index_(2 * leaves_) {
    for (std::size_t k = 0; k < leaves_; ++k) index_[leaves_ + k] = static_cast<std::uint32_t>(k);
  }

  /// Must be called before `compare_all`.
  void place(std::size_t index, double number) { min_[leaves_ + index] = number; }
  void compare_all() {
    for (std::size_t node = leaves_; --node > 0;) compare(node);
  }
  /// Sets three numbers and updates their comparisons together.
  void set(std::array<std::size_t, 3> indices, std::array<double, 3> numbers) {
    for (std::size_t k = 0; k < 3; ++k) min_[leaves_ + indices[k]] = numbers[k];
    std::size_t a = leaves_ + indices[0], b = leaves_ + indices[1], c = leaves_ + indices[2];
    while (a > 1) {
      compare(a /= 2);
      compare(b /= 2);
      compare(c /= 2);
    }
  }
  std::uint32_t index() const { return index_[1]; }
  double min() const { return min_[1]; }

 private:
  void compare(std::size_t node) {
    const double left = min_[2 * node], right = min_[2 * node + 1];
    const std::uint32_t left_index = index_[2 * node], right_index = index_[2 * node + 1];
    const bool is_right = right < left;
    min_[node] = is_right ? right : left;
    index_[node] = is_right ? right_index : left_index;
  }

  std::size_t leaves_;
  // For each node of the tree, the minimum below it and its index.
  std::vector<double> min_;
  std::vector<std::uint32_t> index_;
};

}  // namespace

ReductionOrder reduction_order(const GrassLeaf& leaf, const std::vector<std::vector<double>>& also) {
  const std::size_t count = leaf.point_count();
  if (count < 2) throw std::invalid_argument("a leaf to reduce needs at least 2 points");
  for (const std::vector<double>& list : also) {
    if (list.size() != count) throw std::invalid_argument("each list of a reduction needs one number per point");
  }
  const auto are_finite = [](const std::vector<double>& list) {
    return std::all_of(list.begin(), list.end(), [](double number) { return std::isfinite(number); });
  };
  if (!are_finite(leaf.x) || !are_finite(leaf.y) || !are_finite(leaf.s) || !are_finite(leaf.r) ||
      !std::all_of(also.begin(), also.end(), are_finite)) {
    throw std::invalid_argument("the numbers of a reduction must be finite");
  }
  std::vector<std::uint32_t> before(count), after(count);
  for (std::size_t k = 0; k < count; ++k) {
    before[k] = static_cast<std::uint32_t>(k - 1);
    after[k] = static_cast<std::uint32_t>(k + 1);
  }
  const auto squared_error = [&](std::size_t k) {
    const std::size_t a = before[k], b = after[k];
    double square = squared_distance(leaf.x, leaf.y, k, a, b) + squared_distance(leaf.s, leaf.r, k, a, b);
    for (const std::vector<double>& list : also) {
      square += squared_distance(leaf.s, list, k, a, b);
    }
    return square;
  };

  MinOf errors(count);
  for (std::size_t k = 1; k + 1 < count; ++k) errors.place(k, squared_error(k));
  errors.compare_all();
  ReductionOrder order;
  order.points.reserve(count - 2);
  order.errors.reserve(count - 2);
  double largest = 0;
  for (std::size_t step = 2; step < count; ++step) {
    const std::uint32_t gone = errors.index();
    largest = std::max(largest, errors.min());
    order.points.push_back(gone);
    order.errors.push_back(std::sqrt(largest));
    const std::uint32_t a = before[gone], b = after[gone];
    after[a] = b;
    before[b] = a;
    errors.set({gone, a, b}, {kUnreachable, a > 0 ? squared_error(a) : kUnreachable,
                              b + 1 < count ? squared_error(b) : kUnreachable});
  }
  return order;
}

namespace {

std::vector<std::uint32_t> all_but(const ReductionOrder& order, std::size_t gone) {
  std::vector<bool> stays(order.points.size() + 2, true);
  for (std::size_t k = 0; k < gone; ++k) stays[order.points[k]] = false;
  std::vector<std::uint32_t> kept;
  for (std::size_t k = 0; k < stays.size(); ++k) {
    if (stays[k]) kept.push_back(static_cast<std::uint32_t>(k));
  }
  return kept;
}

}  // namespace

std::vector<std::uint32_t> points_kept(const ReductionOrder& order, std::size_t pieces) {
  const std::size_t inner = std::max<std::size_t>(pieces, 1) - 1;
  return all_but(order, order.points.size() - std::min(inner, order.points.size()));
}

std::vector<std::uint32_t> points_within(const ReductionOrder& order, double error) {
  const auto above = std::upper_bound(order.errors.begin(), order.errors.end(), error);
  return all_but(order, static_cast<std::size_t>(above - order.errors.begin()));
}

GrassLeaf reduced(const GrassLeaf& leaf, const std::vector<std::uint32_t>& points) {
  GrassLeaf now{.length = leaf.length, .width = leaf.width, .s = {}, .x = {}, .y = {}, .r = {}};
  for (std::vector<double>* list : {&now.s, &now.x, &now.y, &now.r}) list->reserve(points.size());
  for (const std::uint32_t k : points) {
    now.s.push_back(leaf.s[k]);
    now.x.push_back(leaf.x[k]);
    now.y.push_back(leaf.y[k]);
    now.r.push_back(leaf.r[k]);
  }
  const double left = area(now);
  if (left > 0) now.width *= area(leaf) / left;
  return now;
}

}  // namespace meristem
