// SPDX-License-Identifier: Apache-2.0
// Finds the metamers at which shoots are ringed, bent and tied.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/frame.h"
#include "meristem/base/math.h"
#include "meristem/grow/prune/choose_shoots.h"
#include "meristem/grow/prune/draw.h"
#include "meristem/grow/prune/work.h"

namespace meristem {

namespace {

/// Returns true if a shoot has a metamer above the given number. Throws InputError if it does not and the operation
/// names the shoot.
bool reaches(const TreeOperation& operation, const Shoot& shoot, int below) {
  if (static_cast<std::size_t>(below) < shoot.path.size()) return true;
  if (operation.shoots.kind != ShootChoice::Kind::label) return false;
  throw InputError(Diagnostic{
      .message = fmt::format("'{}' has {} metamers, and none above that", operation.shoots.text, shoot.path.size()),
      .expected = "fewer metamers below, or a later iteration",
      .path = operation.path + ".below"});
}

/// Returns the turn in radians from the present heading of `last` to the inclination.
double turn_of(const Metamers& metamers, MetamerIndex last, double inclination) {
  const double rise = std::clamp(static_cast<double>(metamers.heading(last).y), -1.0, 1.0);
  return std::abs(inclination - math::asin(rise));
}

/// Returns true if the wood is thicker than the radius of the bend. If the operation names the shoot, throws InputError
/// at `key` instead.
bool would_break(const TreeOperation& operation, const char* key, double thick, double length, double turn) {
  if (length >= thick * turn) return false;
  if (operation.shoots.kind == ShootChoice::Kind::condition) return true;
  throw InputError(Diagnostic{
      .message = fmt::format("the wood would break: it has a radius of {:.3g} m, and the bend one of {:.3g} m", thick,
                             length / turn),
      .expected = "a bend over more metamers, by a smaller angle, or at an earlier iteration",
      .path = fmt::format("{}.{}", operation.path, key)});
}

/// Returns the end of the string of a shoot tied at `tied`: vertically below on the ground, or the nearest point of one
/// of the shoots `anchors`. Returns nothing if the shoot itself is the only anchor.
std::optional<Vec3> string_end(const Metamers& metamers, const std::vector<Shoot>* anchors, AxisIndex own, Vec3 tied) {
  if (anchors == nullptr) return Vec3(tied.x, 0, tied.z);
  std::optional<Vec3> nearest;
  for (const Shoot& anchor : *anchors) {
    if (anchor.axis == own) continue;
    for (const MetamerIndex metamer : anchor.path) {
      const Vec3 tip = metamers.tip[metamer];
      if (!nearest || squared_length(tip - tied) < squared_length(*nearest - tied)) nearest = tip;
    }
  }
  return nearest;
}

}  // namespace

OperationWork girdle(const TreeOperation& operation, const GirdleOperation& what, const std::vector<Shoot>& shoots) {
  OperationWork work;
  for (const Shoot& shoot : shoots) {
    if (!reaches(operation, shoot, what.below)) continue;
    work.rings.push_back({shoot.path[static_cast<std::size_t>(what.below)], what.share, what.iterations});
  }
  return work;
}

OperationWork bend(const TreeState& tree, const TreeOperation& operation, const BendOperation& what,
                   const std::vector<Shoot>& shoots) {
  const Metamers& metamers = tree.metamers;
  const std::vector<float> radius = pipe_radii(metamers.parent, metamers.lost_tips, tree.radii);
  OperationWork work;
  for (const Shoot& shoot : shoots) {
    if (!reaches(operation, shoot, what.below)) continue;
    const auto first = static_cast<std::size_t>(what.below);
    const std::size_t last = std::min(first + static_cast<std::size_t>(what.metamers), shoot.path.size()) - 1;
    double length = 0;
    for (std::size_t k = first; k <= last; ++k) length += metamers.length(shoot.path[k]);
    const double turn = turn_of(metamers, shoot.path[last], what.inclination);
    if (would_break(operation, "metamers", radius[shoot.path[first]], length, turn)) continue;
    work.bows.push_back({shoot.path[first], shoot.path[last], shoot.path.back(), what.inclination, what.iterations});
  }
  return work;
}

OperationWork tie(const TreeState& tree, const TreeOperation& operation, const TieOperation& what,
                  const std::vector<Shoot>& shoots) {
  const Metamers& metamers = tree.metamers;
  std::vector<Shoot> anchors;
  if (what.to) {
    TreeOperation other;
    other.shoots = *what.to;
    other.path = operation.path;
    other.shoots.key = "anchor";
    anchors = choose_shoots(tree, other);
  }
  const std::vector<float> radius = pipe_radii(metamers.parent, metamers.lost_tips, tree.radii);
  OperationWork work;
  for (const Shoot& shoot : shoots) {
    if (shoot.axis == 0 || !reaches(operation, shoot, what.below ? *what.below - 1 : 0)) continue;
    const std::size_t tied = what.below ? static_cast<std::size_t>(*what.below) : shoot.path.size();
    const Vec3 base = metamers.tip[metamers.parent[shoot.path[0]]];
    std::vector<Vec3> points{base};
    double length = 0;
    for (std::size_t k = 0; k < tied; ++k) {
      points.push_back(metamers.tip[shoot.path[k]]);
      length += metamers.length(shoot.path[k]);
    }
    const auto end = string_end(metamers, what.to ? &anchors : nullptr, shoot.axis, points.back());
    if (!end) continue;
    const double turn = draw_toward(points, *end, what.length).angle;
    if (would_break(operation, "length", radius[shoot.path[0]], length, turn)) continue;
    work.bows.push_back(
        {shoot.path[0], shoot.path[tied - 1], shoot.path.back(), 0, what.iterations, *end, what.length});
  }
  return work;
}

}  // namespace meristem
