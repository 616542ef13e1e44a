// SPDX-License-Identifier: Apache-2.0
// Converts a midrib between points and angles of pieces, resamples it, and interpolates along it. Angles are unwrapped,
// so that neighbouring pieces differ by at most pi.
#include "meristem/shape/grass/grass_leaf.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "meristem/base/math.h"
#include "meristem/base/vec.h"

namespace meristem {

namespace {

double middle_of(const GrassLeaf& leaf, std::size_t piece) { return 0.5 * (leaf.s[piece] + leaf.s[piece + 1]); }

}  // namespace

void check_grass_leaf(const GrassLeaf& leaf) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw std::invalid_argument(message);
  };
  const std::size_t points = leaf.point_count();
  require(std::isfinite(leaf.length) && leaf.length > 0, "a grass leaf needs a length above 0");
  require(std::isfinite(leaf.width) && leaf.width > 0, "a grass leaf needs a width above 0");
  require(points >= 2, "a grass leaf needs at least 2 points");
  require(leaf.x.size() == points && leaf.y.size() == points && leaf.r.size() == points,
          "the lists of a grass leaf must be equally long");
  for (std::size_t k = 0; k < points; ++k) {
    require(std::isfinite(leaf.s[k] + leaf.x[k] + leaf.y[k] + leaf.r[k]), "the numbers of a grass leaf must be finite");
    require(k == 0 || leaf.s[k] > leaf.s[k - 1], "the positions s along a grass leaf must rise");
    require(leaf.r[k] >= 0, "the widths r of a grass leaf must be at least 0");
  }
  require(leaf.s.front() == 0 && leaf.s.back() == 1, "the positions s along a grass leaf must go from 0 to 1");
}

double area(const GrassLeaf& leaf) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < leaf.point_count(); ++k) {
    const double dx = leaf.x[k + 1] - leaf.x[k], dy = leaf.y[k + 1] - leaf.y[k];
    sum += 0.5 * std::sqrt(dx * dx + dy * dy) * (leaf.r[k] + leaf.r[k + 1]);
  }
  return leaf.length * leaf.width * sum;
}

std::vector<double> widths_by_area(const GrassLeaf& leaf) {
  double mean = 0;
  for (std::size_t k = 0; k + 1 < leaf.point_count(); ++k) {
    mean += 0.5 * (leaf.s[k + 1] - leaf.s[k]) * (leaf.r[k] + leaf.r[k + 1]);
  }
  std::vector<double> shares = leaf.r;
  if (mean > 0) {
    for (double& share : shares) share /= mean;
  }
  return shares;
}

std::vector<double> piece_angles(const GrassLeaf& leaf) {
  std::vector<double> angles(leaf.point_count() - 1);
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const double before = k == 0 ? 0 : angles[k - 1];
    const double angle = math::atan2(leaf.x[k + 1] - leaf.x[k], leaf.y[k + 1] - leaf.y[k]);
    angles[k] = angle - 2 * kPi * std::floor((angle - before) / (2 * kPi) + 0.5);
  }
  return angles;
}

void set_piece_angles(GrassLeaf& leaf, const std::vector<double>& angles) {
  double x = 0, y = 0;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const double dx = leaf.x[k + 1] - leaf.x[k], dy = leaf.y[k + 1] - leaf.y[k];
    const double length = std::sqrt(dx * dx + dy * dy);
    leaf.x[k] = x;
    leaf.y[k] = y;
    x += length * math::sin(angles[k]);
    y += length * math::cos(angles[k]);
  }
  leaf.x.back() = x;
  leaf.y.back() = y;
}

double along_leaf(const GrassLeaf& leaf, const std::vector<double>& list, double place) {
  if (place <= 0) return list.front();
  if (place >= 1) return list.back();
  const auto above = std::upper_bound(leaf.s.begin(), leaf.s.end(), place);
  const auto k = static_cast<std::size_t>(above - leaf.s.begin());
  const double share = (place - leaf.s[k - 1]) / (leaf.s[k] - leaf.s[k - 1]);
  return list[k - 1] + share * (list[k] - list[k - 1]);
}

double angle_along(const GrassLeaf& leaf, const std::vector<double>& angles, double place) {
  const auto above = std::upper_bound(leaf.s.begin(), leaf.s.end(), place);
  std::size_t piece = above == leaf.s.begin() ? 0 : static_cast<std::size_t>(above - leaf.s.begin()) - 1;
  piece = std::min(piece, angles.size() - 1);
  if (place < middle_of(leaf, piece)) {
    if (piece == 0) return angles[0];
    --piece;
  }
  if (piece + 1 == angles.size()) return angles[piece];
  const double low = middle_of(leaf, piece), high = middle_of(leaf, piece + 1);
  return angles[piece] + (place - low) / (high - low) * (angles[piece + 1] - angles[piece]);
}

void lay_even_pieces(GrassLeaf& leaf, const std::vector<double>& angles) {
  const double piece = 1 / static_cast<double>(angles.size());
  double x = 0, y = 0;
  leaf.x.assign(1, 0);
  leaf.y.assign(1, 0);
  for (const double angle : angles) {
    x += piece * math::sin(angle);
    y += piece * math::cos(angle);
    leaf.x.push_back(x);
    leaf.y.push_back(y);
  }
}

GrassLeaf resampled(const GrassLeaf& leaf, std::size_t pieces) {
  const std::vector<double> angles = piece_angles(leaf);
  std::vector<double> even_angles;
  GrassLeaf even{.length = leaf.length, .width = leaf.width, .s = {}, .x = {}, .y = {}, .r = {}};
  const double piece = 1 / static_cast<double>(pieces);
  for (std::size_t k = 0; k <= pieces; ++k) {
    const double place = k == pieces ? 1 : piece * static_cast<double>(k);
    even.s.push_back(place);
    even.r.push_back(along_leaf(leaf, leaf.r, place));
    if (k < pieces) even_angles.push_back(angle_along(leaf, angles, piece * (static_cast<double>(k) + 0.5)));
  }
  lay_even_pieces(even, even_angles);
  return even;
}

}  // namespace meristem
