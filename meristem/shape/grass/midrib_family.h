// SPDX-License-Identifier: Apache-2.0
// The change of a leaf's form with age, and its visible part.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/shape/grass/grass_leaf.h"

namespace meristem {

/// The midribs of one leaf at several ages, each of equal pieces. Between ages, the directions of pieces are
/// interpolated, so the length stays.
class MidribFamily {
 public:
  /// A leaf that has its own form at `age` (above 0), and was straight along the stem at age 0. Throws
  /// std::invalid_argument for other ages.
  explicit MidribFamily(const GrassLeaf& leaf, double age = 1);
  /// Strictly ascending ages, at least two, with the midrib of each. Throws std::invalid_argument otherwise.
  explicit MidribFamily(const std::vector<std::pair<double, GrassLeaf>>& midribs);

  double first_age() const { return ages_.front(); }                  ///< lowest age
  double last_age() const { return ages_.back(); }                    ///< highest age
  std::size_t piece_count() const { return angles_.front().size(); }  ///< number of pieces of each midrib
  /// Returns the angle of each piece in radians away from the stem. Ages outside the family count as the nearest age in
  /// it.
  std::vector<double> angles(double age) const;

 private:
  std::vector<double> ages_;
  std::vector<std::vector<double>> angles_;  // indexed by age, then piece
};

/// Returns the share of its final length that a leaf shows at `age`. It rises evenly from 0 at age 0 to 1 at
/// `full_age`, and is constant before and after. `full_age` must be above 0.
double visible_share(double age, double full_age);

/// Returns the leaf at `age`: its midrib from the family, and the widths of its visible part, since the tip emerges
/// first. `leaf` is the full-grown leaf with its final length and width. The length is 0 if nothing is visible. Throws
/// std::invalid_argument if `age` is not a number, or if `full_age` is not above 0. Based on: Fournier and Pradal
/// (2012), equation 8, with the visible share instead of l.
GrassLeaf aged(const GrassLeaf& leaf, const MidribFamily& family, double age, double full_age = 1);

/// Factors on one step of a leaf's life. With all factors 1, the leaf is the plain leaf.
struct GrowthRates {
  double age = 1;     ///< speed of ageing
  double length = 1;  ///< length that emerges per step of age
  double width = 1;   ///< width of the emerging part
  double bend = 1;    ///< turn of its pieces per step of age
};

/// Returns the rates for a leaf that has lived for `lived` (in the unit of ages) and shows the share `visible` of its
/// length.
using RatesOf = FunctionRef<GrowthRates(double lived, double visible)>;

/// Maximum number of steps of one life.
inline constexpr double kMaxLifeSteps = 100'000;

/// Returns the leaf after a life up to `time` in steps of `step`, each with its own rates. With rates of 1 the result
/// equals the aged leaf. Negative rates of age, length and width count as 0. A negative bend turns pieces the other
/// way. Throws std::invalid_argument for a step that is not above 0, or for more than kMaxLifeSteps steps. Based on:
/// Fournier and Pradal (2012), section 2.4.
GrassLeaf lived(const GrassLeaf& leaf, const MidribFamily& family, double time, double step, RatesOf rates,
                double full_age = 1);

}  // namespace meristem
