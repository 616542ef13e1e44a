// SPDX-License-Identifier: Apache-2.0
// Bends a leaf under loads. The midrib is a chain of straight pieces whose joints are springs. It rests where its
// energy is minimal, which is the energy of the joints minus the work of the loads. A piece moves everything beyond it
// along a single direction, so the second derivatives of the energy form a tridiagonal matrix, and a Newton step is
// linear in pieces. If a step would raise the energy, the diagonal is increased until it does not. The result is
// therefore stable.
//
// Loads are raised in steps. Wind depends on the orientation of the pieces: its forces are computed from the present
// form, and again from the new form, until both agree. The rest angles of the joints follow from the given form, which
// is in balance with its weight.
//
// Based on: the elastica of Euler as a chain of springs; Fournier and Pradal (2012), section 2.5, which names the
// forces and leaves the mechanics open. Tried first: integration from the tip to the base, with the tip's direction as
// the only unknown. It fails for a fifth of measured leaves in wind, since errors grow toward the base of a limp leaf.
#include "meristem/shape/grass/load_leaf.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "meristem/base/math.h"
#include "meristem/base/vec.h"

namespace meristem {

namespace {

constexpr double kStiffWidth = 0.02;  // share of the largest width: joints of narrower pieces have the stiffness of
                                      // this width
constexpr double kSettled = 1e-10;    // radians; last step of pieces that have come to rest
constexpr double kBalanced = 1e-8;    // radians; like kSettled, between rounds of wind
constexpr double kMaxTurn = 0.5;      // radians; maximum turn of a piece in one step
constexpr int kSearchSteps = 400;
constexpr int kRounds = 300;  // maximum number of rounds of wind
constexpr int kLoadSteps = 8;
constexpr double kMaxLoad = 1000;
constexpr double kAgreed = 0.01;  // share of the requested turn

using Vec = glm::dvec2;

/// The chain of a leaf. Lengths are relative to the leaf's length, forces to its weight per area times squared length.
class LoadedChain {
 public:
  LoadedChain(const GrassLeaf& leaf, const LeafStrip& strip, const LeafLoads& loads) : angles_(piece_angles(leaf)) {
    const double ratio = leaf.width / leaf.length;
    for (std::size_t k = 0; k < angles_.size(); ++k) {
      const Vec along(leaf.x[k + 1] - leaf.x[k], leaf.y[k + 1] - leaf.y[k]);
      lengths_.push_back(glm::length(along));
      areas_.push_back(lengths_[k] * ratio * 0.5 * (leaf.r[k] + leaf.r[k + 1]));
      const double thickness = 1 - (1 - strip.tip_thickness) * leaf.s[k];
      const double share = std::max(kStiffWidth, leaf.r[k]) * thickness * thickness * thickness;
      // Compute the stiffness of the joint before this piece.
      const double spacing = k == 0 ? lengths_[0] : 0.5 * (lengths_[k - 1] + lengths_[k]);
      stiffness_.push_back(strip.stiffness * ratio * share / spacing);
    }
    rest_.assign(angles_.size(), 0);
    const std::vector<double> moments =
        moments_of(angles_, {.pull = {}, .wind = {}, .gravity = loads.measured_gravity});
    for (std::size_t k = 1; k < angles_.size(); ++k)
      rest_[k] = angles_[k] - angles_[k - 1] - moments[k] / stiffness_[k];
  }

  const std::vector<double>& given() const { return angles_; }

  /// Moves `angles` to the equilibrium under loads. Returns false if no equilibrium is found.
  bool settle(std::vector<double>& angles, const LeafLoads& loads) {
    const bool has_wind = loads.wind != Vec(0);
    forces_.assign(angles.size(), Vec(0));
    for (int round = 0; round < kRounds; ++round) {
      // Later rounds apply less of the wind's change, so a leaf that flutters finds its mean.
      const double share = round < 10 ? 1 : 10.0 / round;
      for (std::size_t k = 0; k < angles.size(); ++k) {
        const Vec now = load(k, Vec(math::sin(angles[k]), math::cos(angles[k])), loads);
        forces_[k] = round == 0 ? now : glm::mix(forces_[k], now, share);
      }
      const std::vector<double> before = angles;
      if (!minimize(angles)) return false;
      if (!has_wind) return true;
      double change = 0;
      for (std::size_t k = 0; k < angles.size(); ++k) change = std::max(change, std::abs(angles[k] - before[k]));
      if (change < kBalanced) break;
    }
    return true;
  }

 private:
  /// Returns the load on a piece.
  Vec load(std::size_t k, Vec along, const LeafLoads& loads) const {
    const Vec across(along.y, -along.x);
    const double square = glm::length(loads.wind);
    // The pressure on a plate that the wind meets at an angle with this sine. Along the plate, the wind glides without
    // force.
    const double met = square > 0 ? glm::dot(loads.wind, across) / square : 0;
    return areas_[k] * (loads.pull + loads.gravity + square * met * std::abs(met) * across);
  }

  std::vector<double> moments_of(const std::vector<double>& angles, const LeafLoads& loads) const {
    std::vector<double> moments(angles.size(), 0);
    Vec force(0);
    double moment = 0;
    for (std::size_t k = angles.size(); k-- > 0;) {
      const Vec along(math::sin(angles[k]), math::cos(angles[k]));
      const Vec own = load(k, along, loads);
      moment += lengths_[k] * glm::dot(Vec(along.y, -along.x), 0.5 * own + force);
      force += own;
      moments[k] = moment;
    }
    return moments;
  }

  /// Returns the energy under constant forces, and computes its derivatives by the angles of all pieces except the
  /// fixed first one.
  double differentiate(const std::vector<double>& angles) {
    const std::size_t count = angles.size();
    gradient_.assign(count, 0);
    diagonal_.assign(count, 1);
    scale_.assign(count, 1);
    double energy = 0;
    Vec beyond(0);
    for (std::size_t k = count; k-- > 0;) {
      const Vec along(math::sin(angles[k]), math::cos(angles[k]));
      const Vec pull = lengths_[k] * (0.5 * forces_[k] + beyond);
      energy -= glm::dot(along, pull);
      beyond += forces_[k];
      if (k == 0) break;
      const double own = angles[k] - angles[k - 1] - rest_[k];
      energy += 0.5 * stiffness_[k] * own * own;
      gradient_[k] = stiffness_[k] * own - glm::dot(Vec(along.y, -along.x), pull);
      diagonal_[k] = stiffness_[k] + glm::dot(along, pull);
      scale_[k] = stiffness_[k] + glm::length(pull);
      if (k + 1 < count) {
        gradient_[k] -= stiffness_[k + 1] * (angles[k + 1] - angles[k] - rest_[k + 1]);
        diagonal_[k] += stiffness_[k + 1];
        scale_[k] += stiffness_[k + 1];
      }
    }
    return energy;
  }

  /// Computes the Newton step with the diagonal raised by `more` of its scale. Returns false if the result is not
  /// convex.
  bool find_step(double more) {
    const std::size_t count = gradient_.size();
    step_.assign(count, 0);
    pivots_.assign(count, 1);
    double carried = 0;
    for (std::size_t k = 1; k < count; ++k) {
      const double link = k > 1 ? -stiffness_[k] : 0;
      pivots_[k] = diagonal_[k] + more * scale_[k] - (k > 1 ? link * link / pivots_[k - 1] : 0);
      if (!(pivots_[k] > 1e-14 * scale_[k])) return false;
      carried = -gradient_[k] - (k > 1 ? link * carried / pivots_[k - 1] : 0);
      step_[k] = carried;
    }
    for (std::size_t k = count; k-- > 1;) {
      if (k + 1 < count) step_[k] += stiffness_[k + 1] * step_[k + 1];
      step_[k] /= pivots_[k];
    }
    return true;
  }

  /// Turns the pieces to the minimum of the energy, always downhill.
  bool minimize(std::vector<double>& angles) {
    double more = 0;
    double energy = differentiate(angles);
    for (int k = 0; k < kSearchSteps; ++k) {
      if (!find_step(more)) {
        more = std::max(1e-6, 4 * more);
        continue;
      }
      double farthest = 0;
      for (const double turn : step_) farthest = std::max(farthest, std::abs(turn));
      if (farthest < kSettled) return true;
      const double share = std::min(1.0, kMaxTurn / farthest);
      tried_ = angles;
      for (std::size_t i = 1; i < angles.size(); ++i) tried_[i] += share * step_[i];
      const double reached = differentiate(tried_);
      if (reached <= energy + 1e-15 * std::abs(energy)) {
        angles.swap(tried_);
        energy = reached;
        more = more < 1e-6 ? 0 : more / 4;
      } else {
        // The step is below the precision of the energy, so the leaf is at rest within this precision.
        if (farthest < 1e-6) return true;
        more = std::max(1e-6, 4 * more);
        energy = differentiate(angles);
      }
    }
    return false;
  }

  std::vector<double> angles_;     // given angles
  std::vector<double> lengths_;    // lengths of the pieces
  std::vector<double> areas_;      // areas of the pieces, in squared lengths
  std::vector<double> stiffness_;  // stiffness of the joints before the pieces: moment per radian
  std::vector<double> rest_;       // turns of the joints without load
  std::vector<Vec> forces_;        // forces on the pieces, in the present form
  std::vector<double> gradient_, diagonal_, scale_, step_, pivots_, tried_;
};

LeafLoads scaled(const LeafLoads& loads, double factor) {
  LeafLoads now = loads;
  now.pull *= factor;
  now.wind *= factor;
  now.gravity = glm::mix(loads.measured_gravity, loads.gravity, factor);
  return now;
}

void check(const GrassLeaf& leaf, const LeafStrip& strip, const LeafLoads& loads) {
  check_grass_leaf(leaf);
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw std::invalid_argument(message);
  };
  require(std::isfinite(strip.stiffness) && strip.stiffness > 0, "the stiffness of a leaf must be above 0");
  require(strip.tip_thickness > 0 && strip.tip_thickness <= 1,
          "the thickness of a leaf's tip must be above 0 and at most that of its base");
  for (const Vec vector : {loads.pull, loads.wind, loads.gravity, loads.measured_gravity}) {
    require(std::isfinite(vector.x + vector.y), "the loads on a leaf must be finite");
  }
}

}  // namespace

GrassLeaf loaded(const GrassLeaf& leaf, const LeafStrip& strip, const LeafLoads& loads) {
  check(leaf, strip, loads);
  LoadedChain chain(leaf, strip, loads);
  std::vector<double> angles = chain.given();
  for (int k = 1; k <= kLoadSteps; ++k) {
    if (!chain.settle(angles, scaled(loads, static_cast<double>(k) / kLoadSteps))) {
      throw std::invalid_argument("no form of the leaf was found under these loads: the leaf is too limp");
    }
  }
  GrassLeaf now = leaf;
  set_piece_angles(now, angles);
  return now;
}

double load_for_turn(const GrassLeaf& leaf, const LeafStrip& strip, const LeafLoads& loads, double place,
                     double angle) {
  check(leaf, strip, loads);
  if (!(place > 0 && place <= 1)) throw std::invalid_argument("the position of a turn must be above 0 and at most 1");
  if (angle == 0) return 0;
  LeafLoads growing = loads;
  growing.gravity = loads.measured_gravity;
  LoadedChain chain(leaf, strip, growing);
  const double given = angle_along(leaf, chain.given(), place);
  std::vector<double> angles = chain.given(), tried;
  double turn = 0;
  // Returns true if the turn exceeds the requested angle with the loads at a factor.
  const auto passes = [&](double factor) {
    tried = angles;
    if (!chain.settle(tried, scaled(growing, factor)))
      throw std::invalid_argument("no such load turns the leaf that far");
    turn = angle_along(leaf, tried, place) - given;
    return angle > 0 ? turn >= angle : turn <= angle;
  };

  // Raise the loads until the turn is exceeded, then bisect.
  double low = 0, high = 0.01;
  while (!passes(high)) {
    angles = tried;
    low = high;
    high *= 1.3;
    if (high > kMaxLoad) throw std::invalid_argument("no such load turns the leaf that far");
  }
  while (high - low > 1e-9 * high) {
    const double middle = 0.5 * (low + high);
    if (passes(middle)) {
      high = middle;
    } else {
      angles = tried;
      low = middle;
    }
  }
  passes(high);
  if (std::abs(turn - angle) > kAgreed * std::abs(angle)) {
    throw std::invalid_argument("no load holds the leaf at that turn: it snaps past it");
  }
  return high;
}

}  // namespace meristem
