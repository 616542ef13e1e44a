// SPDX-License-Identifier: Apache-2.0
// Ages a leaf by interpolating the angles of its midrib between ages. A life in steps records how much tissue emerges
// in each step with its own rates. Sources are in the header.
#include "meristem/shape/grass/midrib_family.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "meristem/base/vec.h"

namespace meristem {

namespace {

constexpr double kSharp = 2 * kPi / 3;  // radians; a larger turn may be a fold to either side
constexpr double kMinShare = 1e-6;      // minimum visible share of the length

/// Returns the value at `place` from a list with a number for the middle of each equal piece. Constant beyond the
/// outermost middles.
double at_middles(const std::vector<double>& list, double place) {
  const double at = place * static_cast<double>(list.size()) - 0.5;
  if (at <= 0) return list.front();
  const auto k = static_cast<std::size_t>(at);
  if (k + 1 >= list.size()) return list.back();
  return list[k] + (at - static_cast<double>(k)) * (list[k + 1] - list[k]);
}

/// Returns the turn at a piece: over this piece, or over it and the piece before, because a fold may lie between the
/// ends of pieces.
double turn_into(const std::vector<double>& angles, std::size_t k) {
  const double here = angles[k] - angles[k - 1], wide = k > 1 ? angles[k] - angles[k - 2] : here;
  return std::max(std::abs(here), std::abs(wide));
}

/// Makes folds turn the same way at both ages. A fold by nearly half a turn may be read as one to either side: 175° at
/// one age and 185°, which is -175°, at the next. The part beyond a fold is shifted by whole turns to the side that is
/// nearer to the earlier midrib. Otherwise the leaf would stand up between both ages. Gentle bends have a definite
/// direction and are not changed.
void fold_like(const std::vector<double>& earlier, std::vector<double>& angles) {
  const std::size_t count = angles.size();
  std::vector<std::size_t> folds;
  for (std::size_t k = 1; k < count; ++k) {
    const bool goes_on = !folds.empty() && k == folds.back() + 1;
    if (turn_into(angles, k) > kSharp && !goes_on) folds.push_back(k);
  }
  for (std::size_t fold = 0; fold < folds.size(); ++fold) {
    // The fold itself takes up to two pieces, so compare the pieces beyond it.
    const std::size_t begin = folds[fold], end = fold + 1 < folds.size() ? folds[fold + 1] : count;
    const std::size_t first = std::min(begin + 1, end - 1);
    double apart = 0;
    for (std::size_t k = first; k < end; ++k) apart += angles[k] - earlier[k];
    const double turns = std::floor(apart / static_cast<double>(end - first) / (2 * kPi) + 0.5);
    if (turns == 0) continue;
    for (std::size_t k = begin; k < count; ++k) angles[k] -= 2 * kPi * turns;
  }
}

GrassLeaf unseen(const GrassLeaf& leaf) {
  return {.length = 0, .width = leaf.width, .s = {0, 1}, .x = {0, 0}, .y = {0, 1}, .r = {0, 0}};
}

}  // namespace

MidribFamily::MidribFamily(const GrassLeaf& leaf, double age) : ages_{0, age} {
  if (!(age > 0)) throw std::invalid_argument("the age of a leaf's form must be above 0");
  const std::vector<double> own = piece_angles(resampled(leaf, leaf.point_count() - 1));
  angles_ = {std::vector<double>(own.size(), 0), own};
}

MidribFamily::MidribFamily(const std::vector<std::pair<double, GrassLeaf>>& midribs) {
  if (midribs.size() < 2) throw std::invalid_argument("a family of midribs needs at least 2 ages");
  const std::size_t pieces = midribs.front().second.point_count() - 1;
  for (const auto& [age, leaf] : midribs) {
    if (!ages_.empty() && !(age > ages_.back()))
      throw std::invalid_argument("the ages of a family of midribs must rise");
    ages_.push_back(age);
    std::vector<double> angles = piece_angles(resampled(leaf, pieces));
    if (!angles_.empty()) fold_like(angles_.back(), angles);
    angles_.push_back(std::move(angles));
  }
}

std::vector<double> MidribFamily::angles(double age) const {
  const auto above = std::upper_bound(ages_.begin(), ages_.end(), age);
  if (above == ages_.begin()) return angles_.front();
  if (above == ages_.end()) return angles_.back();
  const auto k = static_cast<std::size_t>(above - ages_.begin());
  const double share = (age - ages_[k - 1]) / (ages_[k] - ages_[k - 1]);
  std::vector<double> between = angles_[k - 1];
  for (std::size_t i = 0; i < between.size(); ++i) between[i] += share * (angles_[k][i] - between[i]);
  return between;
}

double visible_share(double age, double full_age) { return std::clamp(age / full_age, 0.0, 1.0); }

GrassLeaf aged(const GrassLeaf& leaf, const MidribFamily& family, double age, double full_age) {
  if (std::isnan(age)) throw std::invalid_argument("the age of a leaf must be a number");
  if (!(full_age > 0)) throw std::invalid_argument("the age at which a leaf is whole must be above 0");
  const double visible = visible_share(age, full_age);
  if (visible < kMinShare) return unseen(leaf);
  const std::size_t pieces = family.piece_count();
  const std::vector<double> whole = family.angles(age);
  GrassLeaf now{.length = visible * leaf.length, .width = leaf.width, .s = {}, .x = {}, .y = {}, .r = {}};
  std::vector<double> angles;
  for (std::size_t k = 0; k <= pieces; ++k) {
    const double place = k == pieces ? 1 : static_cast<double>(k) / static_cast<double>(pieces);
    now.s.push_back(place);
    now.r.push_back(along_leaf(leaf, leaf.r, visible == 1 ? place : visible * place + 1 - visible));
    if (k == pieces) break;
    angles.push_back(at_middles(whole, visible * (static_cast<double>(k) + 0.5) / static_cast<double>(pieces)));
  }
  lay_even_pieces(now, angles);
  return now;
}

namespace {

/// A position of the leaf, named by the time at which its tissue emerged from the sheath: its distance from the tip in
/// the plain leaf, whose visible share is equal to it at that time.
struct Tissue {
  double from_tip;  // in lengths of the plain leaf
  double length;    // grown length from this position to the tip
  double width;     // factor on the width of the plain leaf
};

/// The tissue that a life has made, and how its pieces are bent.
struct Life {
  std::vector<Tissue> tissue;  // from the tip to the base, at least the tip
  std::vector<double> angles;  // of the whole plain leaf, by piece
};

/// Lives in steps with individual rates. In each step the pieces turn, and the tissue that emerges gets its length and
/// width.
Life live(const MidribFamily& family, double time, double step, RatesOf rates, double full_age) {
  std::vector<double> plain = family.angles(0);
  Life life{.tissue = {{0, 0, 1}}, .angles = plain};
  std::vector<Tissue>& tissue = life.tissue;
  double age = 0;
  const auto steps = static_cast<int>(std::ceil(time / step - 1e-9));
  for (int k = 0; k < steps; ++k) {
    const double begin = k * step, end = std::min(time, begin + step);
    const GrowthRates now = rates(begin, tissue.back().from_tip);
    age += (end - begin) * std::max(0.0, now.age);
    const std::vector<double> next = family.angles(age);
    for (std::size_t i = 0; i < plain.size(); ++i) life.angles[i] += now.bend * (next[i] - plain[i]);
    plain = next;
    const double more = visible_share(age, full_age) - tissue.back().from_tip;
    if (tissue.size() == 1) tissue.front().width = std::max(0.0, now.width);
    if (more > 0) {
      tissue.push_back({tissue.back().from_tip + more, tissue.back().length + more * std::max(0.0, now.length),
                        std::max(0.0, now.width)});
    }
  }
  return life;
}

/// Finds the tissue at positions of the grown leaf, which must come in order from the base to the tip.
class TissueFinder {
 public:
  explicit TissueFinder(const std::vector<Tissue>& tissue) : tissue_(tissue), young_(tissue.size() - 1) {}

  /// Returns the tissue at `place`, from 0 at the base to 1 at the tip. It is interpolated between two steps of the
  /// life.
  Tissue at(double place) {
    const double to_tip = (1 - place) * tissue_.back().length;
    while (young_ > 1 && tissue_[young_ - 1].length >= to_tip) --young_;
    const Tissue& old = tissue_[young_ - 1];
    const Tissue& young = tissue_[young_];
    const double made = young.length - old.length;
    const double share = made > 0 ? std::clamp((to_tip - old.length) / made, 0.0, 1.0) : 1;
    return {.from_tip = old.from_tip + share * (young.from_tip - old.from_tip),
            .length = to_tip,
            .width = old.width + share * (young.width - old.width)};
  }

 private:
  const std::vector<Tissue>& tissue_;
  std::size_t young_;  // index of the younger end of the step at the last position
};

}  // namespace

GrassLeaf lived(const GrassLeaf& leaf, const MidribFamily& family, double time, double step, RatesOf rates,
                double full_age) {
  if (!(step > 0) || !(time / step <= kMaxLifeSteps)) {
    throw std::invalid_argument("the steps of a leaf's life must be above 0, and at most 100,000 in number");
  }
  const Life life = live(family, time, step, rates, full_age);
  const double visible = life.tissue.back().from_tip, grown = life.tissue.back().length;
  if (visible < kMinShare || grown < kMinShare) return unseen(leaf);

  // Lay out the emerged tissue in even pieces. A position of the grown leaf has the form of the plain leaf at the
  // position of its tissue there.
  const std::size_t pieces = family.piece_count();
  GrassLeaf now{.length = grown * leaf.length, .width = leaf.width, .s = {}, .x = {}, .y = {}, .r = {}};
  std::vector<double> angles;
  TissueFinder finder(life.tissue);
  double widest = 0;
  for (std::size_t k = 0; k <= pieces; ++k) {
    const double place = k == pieces ? 1 : static_cast<double>(k) / static_cast<double>(pieces);
    const Tissue here = finder.at(place);
    const double from_base = visible - here.from_tip;
    now.s.push_back(place);
    now.r.push_back(here.width * along_leaf(leaf, leaf.r, std::clamp(from_base + 1 - visible, 0.0, 1.0)));
    widest = std::max(widest, now.r.back());
    if (k == pieces) break;
    const Tissue middle = finder.at((static_cast<double>(k) + 0.5) / static_cast<double>(pieces));
    angles.push_back(at_middles(life.angles, visible - middle.from_tip));
  }
  lay_even_pieces(now, angles);

  // Widths are shares of the largest width.
  if (widest > 1) {
    now.width *= widest;
    for (double& share : now.r) share /= widest;
  }
  return now;
}

}  // namespace meristem
