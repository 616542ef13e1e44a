// SPDX-License-Identifier: Apache-2.0
// Bends a leaf by changing the angles of its midrib's pieces, or turns it as a whole about its collar. The lengths of
// pieces stay. Changes of the width multiply the widths of points.
#include "meristem/shape/grass/bend_leaf.h"

#include <algorithm>
#include <stdexcept>

#include "meristem/base/math.h"

namespace meristem {

namespace {

constexpr double kMaxWidthFactor = 100;

}  // namespace

GrassLeaf turned(const GrassLeaf& leaf, const std::vector<LocalTurn>& turns) {
  for (const LocalTurn& turn : turns) {
    if (!(turn.from >= 0 && turn.to >= turn.from && turn.to <= 1)) {
      throw std::invalid_argument("a turn of a leaf must lie between two positions from 0 to 1");
    }
  }
  GrassLeaf now = leaf;
  std::vector<double> angles = piece_angles(leaf);
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const double middle = 0.5 * (leaf.s[k] + leaf.s[k + 1]);
    for (const LocalTurn& turn : turns) {
      const double length = turn.to - turn.from;
      const double share = length > 0           ? std::clamp((middle - turn.from) / length, 0.0, 1.0)
                           : middle > turn.from ? 1
                                                : 0;
      angles[k] += share * turn.angle;
    }
  }
  set_piece_angles(now, angles);
  return now;
}

GrassLeaf widened(const GrassLeaf& leaf, const std::vector<LocalWidth>& widths) {
  for (const LocalWidth& width : widths) {
    if (!(width.from >= 0 && width.to > width.from && width.to <= 1)) {
      throw std::invalid_argument("a change of a leaf's width must lie between two positions from 0 to 1");
    }
    if (!(width.factor >= 0 && width.factor <= kMaxWidthFactor)) {
      throw std::invalid_argument("the factor of a leaf's width must be at least 0, and at most 100");
    }
  }
  GrassLeaf now = leaf;
  double widest = 0;
  for (std::size_t k = 0; k < leaf.point_count(); ++k) {
    double factor = 1;
    for (const LocalWidth& width : widths) {
      const double u = (leaf.s[k] - width.from) / (width.to - width.from);
      if (u <= 0 || u >= 1) continue;
      const double rise = 4 * u * (1 - u);  // 1 in the middle; its square has no edge at the ends
      factor = std::min(factor * (1 + (width.factor - 1) * rise * rise), kMaxWidthFactor);
    }
    now.r[k] *= factor;
    widest = std::max(widest, now.r[k]);
  }
  if (widest > 1) {
    now.width *= widest;
    for (double& share : now.r) share /= widest;
  }
  return now;
}

double inclination(const GrassLeaf& leaf) { return math::atan2(leaf.x[1] - leaf.x[0], leaf.y[1] - leaf.y[0]); }

GrassLeaf inclined(const GrassLeaf& leaf, double angle) {
  GrassLeaf now = leaf;
  const double turn = angle - inclination(leaf);
  const double sine = math::sin(turn), cosine = math::cos(turn);
  for (std::size_t k = 0; k < leaf.point_count(); ++k) {
    now.x[k] = cosine * leaf.x[k] + sine * leaf.y[k];
    now.y[k] = cosine * leaf.y[k] - sine * leaf.x[k];
  }
  return now;
}

}  // namespace meristem
