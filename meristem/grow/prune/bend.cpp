// SPDX-License-Identifier: Apache-2.0
// Finds the metamers at which shoots are ringed and bent.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/frame.h"
#include "meristem/base/math.h"
#include "meristem/grow/prune/work.h"

namespace meristem {

namespace {

/// Whether a shoot has a metamer above the given number. Throws InputError where it has none and the operation names
/// the shoot.
bool reaches(const Operation& operation, const Shoot& shoot, int below) {
  if (static_cast<std::size_t>(below) < shoot.path.size()) return true;
  if (operation.shoots.kind != ShootChoice::Kind::label) return false;
  throw InputError(Diagnostic{
      .message = fmt::format("'{}' has {} metamers, and none above that", operation.shoots.text, shoot.path.size()),
      .expected = "fewer metamers below, or a later iteration",
      .path = operation.path + ".below"});
}

/// The turn of a bend from how `last` heads now, radians.
double turn_of(const Metamers& metamers, MetamerIndex last, double inclination) {
  const double rise = std::clamp(static_cast<double>(metamers.heading(last).y), -1.0, 1.0);
  return std::abs(inclination - math::asin(rise));
}

}  // namespace

Work girdle(const Operation& operation, const Girdle& what, const std::vector<Shoot>& shoots) {
  Work work;
  for (const Shoot& shoot : shoots) {
    if (!reaches(operation, shoot, what.below)) continue;
    work.rings.push_back({shoot.path[static_cast<std::size_t>(what.below)], what.share, what.iterations});
  }
  return work;
}

Work bend(const TreeState& tree, const Operation& operation, const Bend& what, const std::vector<Shoot>& shoots) {
  const Metamers& metamers = tree.metamers;
  const std::vector<float> radius = pipe_radii(metamers.parent, metamers.lost_tips, tree.radii);
  Work work;
  for (const Shoot& shoot : shoots) {
    if (!reaches(operation, shoot, what.below)) continue;
    const auto first = static_cast<std::size_t>(what.below);
    const std::size_t last = std::min(first + static_cast<std::size_t>(what.metamers), shoot.path.size()) - 1;
    double length = 0;
    for (std::size_t k = first; k <= last; ++k) length += metamers.length(shoot.path[k]);
    // Wood that is thicker than the arc it is bent to would break; a condition passes over it.
    const double turn = turn_of(metamers, shoot.path[last], what.inclination);
    const double thick = radius[shoot.path[first]];
    if (length < thick * turn) {
      if (operation.shoots.kind == ShootChoice::Kind::condition) continue;
      throw InputError(Diagnostic{
          .message = fmt::format("the wood would break: it has a radius of {:.3g} m, and the bend one of {:.3g} m",
                                 thick, length / turn),
          .expected = "a bend over more metamers, by a smaller angle, or at an earlier iteration",
          .path = operation.path + ".metamers"});
    }
    work.bows.push_back({shoot.path[first], shoot.path[last], shoot.path.back(), what.inclination, what.iterations});
  }
  return work;
}

}  // namespace meristem
