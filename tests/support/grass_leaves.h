// SPDX-License-Identifier: Apache-2.0
// Grass leaves for tests and benchmarks: of known form, random, synthetic, and measured ones if the data exist.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "meristem/base/math.h"
#include "meristem/base/random.h"
#include "meristem/base/read_file.h"
#include "meristem/shape/grass/fit_leaf.h"
#include "meristem/shape/grass/measured_leaves.h"
#include "tests/support/test_data.h"

namespace meristem {

/// A leaf of equal pieces and constant width. Its direction changes linearly from `first` to `last` radians away from
/// the stem.
inline GrassLeaf arching_leaf(std::size_t pieces, double first, double last) {
  GrassLeaf leaf{.length = 0.3, .width = 0.015, .s = {0}, .x = {0}, .y = {0}, .r = {1}};
  const auto count = static_cast<double>(pieces);
  for (std::size_t k = 1; k <= pieces; ++k) {
    const double angle = first + (last - first) * (static_cast<double>(k) - 0.5) / count;
    leaf.s.push_back(k == pieces ? 1 : static_cast<double>(k) / count);
    leaf.x.push_back(leaf.x.back() + math::sin(angle) / count);
    leaf.y.push_back(leaf.y.back() + math::cos(angle) / count);
    leaf.r.push_back(1);
  }
  return leaf;
}

/// Sets the widths of a blade: 0.6 at its base, 1 at a third, and a pointed tip.
inline GrassLeaf with_blade(GrassLeaf leaf) {
  for (std::size_t k = 0; k < leaf.point_count(); ++k) {
    const double s = leaf.s[k];
    leaf.r[k] = s < 1.0 / 3 ? 1 - 0.4 * (1 - 3 * s) * (1 - 3 * s) : 1 - (1.5 * s - 0.5) * (1.5 * s - 0.5);
  }
  return leaf;
}

/// A leaf of equal pieces with random turns.
inline GrassLeaf random_leaf(const RandomKey& key, std::size_t pieces) {
  GrassLeaf leaf{.length = 0.3, .width = 0.015, .s = {0}, .x = {0}, .y = {0}, .r = {key.uniform(0)}};
  double angle = key.uniform(1);
  for (std::size_t k = 1; k <= pieces; ++k) {
    angle += key.uniform(2 * k, -0.3, 0.4);
    leaf.s.push_back(k == pieces ? 1 : static_cast<double>(k) / static_cast<double>(pieces));
    leaf.x.push_back(leaf.x.back() + math::sin(angle) / static_cast<double>(pieces));
    leaf.y.push_back(leaf.y.back() + math::cos(angle) / static_cast<double>(pieces));
    leaf.r.push_back(key.uniform(2 * k + 1));
  }
  return leaf;
}

/// Returns the largest distance between two points with equal index, in leaf lengths.
inline double largest_shift(const GrassLeaf& a, const GrassLeaf& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.point_count(); ++k) {
    largest = std::max(largest, std::hypot(a.x[k] - b.x[k], a.y[k] - b.y[k]));
  }
  return largest;
}

inline double distance_to_midrib(glm::dvec2 point, const GrassLeaf& leaf) {
  double nearest = 1e300;
  for (std::size_t k = 0; k + 1 < leaf.point_count(); ++k) {
    const glm::dvec2 a(leaf.x[k], leaf.y[k]), along = glm::dvec2(leaf.x[k + 1], leaf.y[k + 1]) - a;
    const double share = std::clamp(glm::dot(point - a, along) / glm::dot(along, along), 0.0, 1.0);
    nearest = std::min(nearest, glm::distance(point, a + share * along));
  }
  return nearest;
}

inline double median(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers.empty() ? 0 : 0.5 * (numbers[(numbers.size() - 1) / 2] + numbers[numbers.size() / 2]);
}

/// Widths that fit any midrib.
inline MeasuredCurve plain_widths() {
  return {.points = {{0, 0.6}, {0.1, 0.8}, {0.3, 1}, {0.5, 0.95}, {0.7, 0.75}, {0.9, 0.35}, {1, 0}}};
}

/// The leaves of a species as their observers list them.
struct MeasuredGrass {
  std::string name;
  std::vector<MeasuredCurve> midribs;
  std::vector<MeasuredCurve> by_age;  ///< midribs of classes of leaves at many ages
  std::vector<MeasuredCurve> widths;  ///< one profile for each class of ranks

  /// Fits about `count` leaves, evenly spread over the midribs, with the widths of the classes in turn. Fits all leaves
  /// if there are fewer.
  std::vector<GrassLeaf> fitted(std::size_t count) const {
    std::vector<GrassLeaf> leaves;
    for (std::size_t k = 0; k < midribs.size(); k += std::max<std::size_t>(1, midribs.size() / count)) {
      leaves.push_back(fit_leaf(midribs[k], widths[k % widths.size()]).leaf);
    }
    return leaves;
  }
};

/// Returns the synthetic leaves of the project, and the leaves of wheat if their measurements are on this machine.
inline std::vector<MeasuredGrass> measured_grasses() {
  const std::string own = "tests/data/grass/", wheat = "grass/";
  const std::vector<std::string> files =
      data_files({own + "midribs.csv", own + "midribs_by_age.csv", own + "widths.csv"},
                 {wheat + "So99.csv", wheat + "median_leaf_trajectories_Soissons_Grignon2010_byleafclass.csv",
                  wheat + "SRSo.csv"});
  std::vector<Diagnostic> warnings;
  const auto text = [&](std::size_t k) { return read_file(files[k], SizeLimits{}.file_bytes); };
  std::vector<MeasuredGrass> grasses;
  for (std::size_t k = 0; k + 2 < files.size(); k += 3) {
    grasses.push_back({.name = k == 0 ? "synthetic leaves" : "leaves of wheat",
                       .midribs = read_midribs(text(k), {}, warnings),
                       .by_age = read_midribs(text(k + 1), {}, warnings),
                       .widths = read_widths(text(k + 2), {}, warnings)});
  }
  return grasses;
}

}  // namespace meristem
