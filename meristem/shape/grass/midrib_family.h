// SPDX-License-Identifier: Apache-2.0
// How a leaf's form changes with age, and what of it can be seen.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/shape/grass/grass_leaf.h"

namespace meristem {

/// The midribs of one leaf at several ages, of equal pieces each. Between ages the directions of its pieces are
/// interpolated, so that the length is kept.
class MidribFamily {
 public:
  /// One leaf's own form at `age`, above 0, which was straight along the stem at age 0. Throws std::invalid_argument
  /// for other ages.
  explicit MidribFamily(const GrassLeaf& leaf, double age = 1);
  /// Ages that rise strictly, at least two, with the midrib of each. Throws std::invalid_argument otherwise.
  explicit MidribFamily(const std::vector<std::pair<double, GrassLeaf>>& midribs);

  double first_age() const { return ages_.front(); }                  ///< the least age
  double last_age() const { return ages_.back(); }                    ///< the greatest age
  std::size_t piece_count() const { return angles_.front().size(); }  ///< pieces of each midrib
  /// Radians away from the stem of each piece. Ages outside the family count as its nearest.
  std::vector<double> angles(double age) const;

 private:
  std::vector<double> ages_;
  std::vector<std::vector<double>> angles_;  // by age, then piece
};

/// The share of its last length that a leaf shows at `age`: it rises evenly to all of it at `full_age`.
double visible_share(double age, double full_age);

/// The leaf at `age`: its midrib from the family, and of its widths those that have come out, since the tip comes
/// first. `leaf` is full grown; its length and width are the last ones. Where nothing of it can be seen its length is
/// 0. Based on: Fournier and Pradal (2012), equation 8, with the share that is visible in place of l.
GrassLeaf aged(const GrassLeaf& leaf, const MidribFamily& family, double age, double full_age = 1);

/// What a step of a leaf's own life multiplies: 1 each is the plain leaf.
struct GrowthRates {
  double age = 1;     ///< how fast it ages
  double length = 1;  ///< how much length comes out with each step of age
  double width = 1;   ///< width of the leaf that comes out
  double bend = 1;    ///< how far its pieces turn with each step of age
};

/// The rates for a leaf that has lived for `lived` (in the unit of ages) and shows the share `visible` of its length.
using RatesOf = FunctionRef<GrowthRates(double lived, double visible)>;

/// The most steps of one life.
inline constexpr double kMostLifeSteps = 100'000;

/// The leaf after living up to `time` in steps of `step`, each with its own rates. With rates of 1 it is the aged one.
/// Negative rates of age, length and width count as 0; a negative bend turns pieces the other way. Throws
/// std::invalid_argument for a step that is not above 0 or over kMostLifeSteps of them. Based on: Fournier and Pradal
/// (2012), section 2.4.
GrassLeaf lived(const GrassLeaf& leaf, const MidribFamily& family, double time, double step, RatesOf rates,
                double full_age = 1);

}  // namespace meristem
