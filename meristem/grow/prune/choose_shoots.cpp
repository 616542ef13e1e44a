// SPDX-License-Identifier: Apache-2.0
// Finds the shoots of operations: evaluates a condition over all leads in columns, and computes only the variables that
// it uses.
#include "meristem/grow/prune/choose_shoots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/frame.h"
#include "meristem/base/math.h"

namespace meristem {

namespace {

constexpr std::size_t kShownNames = 12;

[[noreturn]] void refuse_label(const TreeState& tree, const TreeOperation& operation) {
  // Suggest names of shoots on the longest existing prefix of the label.
  const Metamers& metamers = tree.metamers;
  std::string known = operation.shoots.text;
  while (known.find('.') != std::string::npos && !metamers.find_shoot(known)) known.resize(known.find_last_of('.'));
  const AxisIndex on = metamers.find_shoot(known).value_or(0);
  std::vector<std::string> names = metamers.shoots_on(on);
  names.insert(names.begin(), metamers.name_of(on));
  const std::string nearest = nearest_name(operation.shoots.text, names);
  if (names.size() > kShownNames) names.resize(kShownNames);
  throw InputError(Diagnostic{
      .message = fmt::format("there is no shoot '{}' after iteration {}", operation.shoots.text, tree.iteration),
      .expected = fmt::format("a shoot that exists, such as {}", fmt::join(names, ", ")),
      .nearest = nearest,
      .path = operation.path + "." + operation.shoots.key});
}

std::vector<MetamerIndex> axis_path(const Metamers& metamers, AxisIndex axis) {
  std::vector<MetamerIndex> path;
  for (MetamerIndex metamer = metamers.axes[axis].last; metamer != 0; metamer = metamers.parent[metamer]) {
    path.push_back(metamer);
    if (metamer == metamers.axes[axis].first) break;
  }
  std::ranges::reverse(path);
  return path;
}

/// A shoot without its path, which is computed for few shoots only.
struct Candidate {
  AxisIndex axis = 0;
  MetamerIndex first = 0;
  MetamerIndex last = 0;
};

double path_length(const Metamers& metamers, const Candidate& shoot) {
  double length = 0;
  for (MetamerIndex metamer = shoot.last;; metamer = metamers.parent[metamer]) {
    length += metamers.length(metamer);
    if (metamer == shoot.first) return length;
  }
}

double path_length(const Metamers& metamers, const std::vector<MetamerIndex>& path) {
  return path.empty() ? 0 : path_length(metamers, Candidate{0, path.front(), path.back()});
}

/// Returns the metamer in the middle of a shoot; for an even number, the farther one.
MetamerIndex middle_of(const Metamers& metamers, const Candidate& shoot) {
  MetamerIndex middle = shoot.last;
  bool is_second = false;
  for (MetamerIndex metamer = shoot.last; metamer != shoot.first; metamer = metamers.parent[metamer]) {
    if (is_second) middle = metamers.parent[middle];
    is_second = !is_second;
  }
  return middle;
}

/// Returns the distance from the middle of each shoot to the nearest middle of another shoot. Sweeps over the points
/// along the axis of their largest extent.
std::vector<double> clearances(const Metamers& metamers, const std::vector<Candidate>& shoots) {
  struct Place {
    Vec3 middle;
    std::size_t shoot;
  };
  std::vector<Place> places;
  Box around;
  for (std::size_t k = 0; k < shoots.size(); ++k) {
    places.push_back({metamers.tip[middle_of(metamers, shoots[k])], k});
    around.add(places.back().middle);
  }
  const Vec3 extent = around.high - around.low;
  const int along = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
  std::ranges::sort(places, [&](const Place& a, const Place& b) {
    return a.middle[along] != b.middle[along] ? a.middle[along] < b.middle[along] : a.shoot < b.shoot;
  });
  std::vector<double> clearance(shoots.size(), std::numeric_limits<double>::max());
  for (std::size_t k = 0; k < places.size(); ++k) {
    double& best = clearance[places[k].shoot];
    const auto look = [&](std::size_t other) {
      best = std::min(best, static_cast<double>(glm::distance(places[k].middle, places[other].middle)));
      return std::abs(places[k].middle[along] - places[other].middle[along]) < best;
    };
    for (std::size_t other = k; other-- > 0 && look(other);) continue;
    for (std::size_t other = k + 1; other < places.size() && look(other); ++other) continue;
  }
  return clearance;
}

enum Variable : std::size_t {
  rank,
  length,
  age,
  light,
  resource,
  radius,
  height,
  inclination,
  azimuth,
  clearance,
  inward,
  marked,
  variable_count
};

/// The columns of shoot_variables() that a condition uses.
class ShootColumns {
 public:
  ShootColumns(const TreeState& tree, const std::vector<Candidate>& shoots, const Expression& condition)
      : tree_(tree), columns_(variable_count + tree.marks) {
    std::vector<float> radii;
    if (condition.uses(Variable::radius)) {
      radii = pipe_radii(tree.metamers.parent, tree.metamers.lost_tips, tree.radii);
    }
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (!condition.uses(k)) continue;
      if (k == Variable::clearance) {
        columns_[k] = clearances(tree.metamers, shoots);
        continue;
      }
      columns_[k].resize(shoots.size());
      for (std::size_t shoot = 0; shoot < shoots.size(); ++shoot) columns_[k][shoot] = value(k, shoots[shoot], radii);
    }
  }

  std::vector<const double*> pointers() const {
    std::vector<const double*> all;
    for (const std::vector<double>& column : columns_) all.push_back(column.empty() ? nullptr : column.data());
    return all;
  }

 private:
  double value(std::size_t variable, const Candidate& shoot, const std::vector<float>& radii) const {
    const Metamers& metamers = tree_.metamers;
    const auto [axis, first, last] = shoot;
    const Vec3 base = metamers.tip[metamers.parent[first]];
    const Vec3 way = normalized_or(metamers.tip[last] - base, metamers.heading(first));
    const bool was_there = first < tree_.flow.light.size() && first < tree_.flow.resource.size();
    switch (variable) {
      case Variable::rank:
        return tree_.leads.rank[axis];
      case Variable::length:
        return path_length(metamers, shoot);
      case Variable::age:
        return tree_.iteration - metamers.birth[first];
      case Variable::light:
        return was_there ? tree_.flow.light[first] : 0;
      case Variable::resource:
        return was_there ? tree_.flow.resource[first] : 0;
      case Variable::radius:
        return radii[first];
      case Variable::height:
        return metamers.tip[last].y;
      case Variable::inclination:
        return degrees(math::asin(std::clamp(static_cast<double>(way.y), -1.0, 1.0)));
      case Variable::azimuth: {
        const double from_north = degrees(math::atan2(way.x, -way.z));
        return from_north < 0 ? from_north + 360 : from_north;
      }
      case Variable::inward:
        return way.x * base.x + way.z * base.z < 0 ? 1 : 0;
      case Variable::marked:
        return metamers.axes[axis].marks != 0 ? 1 : 0;
      default:  // a mark, by its name
        return (metamers.axes[axis].marks >> (variable - variable_count)) & 1U;
    }
  }

  const TreeState& tree_;
  std::vector<std::vector<double>> columns_;
};

/// Returns all leads of a tree.
std::vector<Candidate> all_shoots(const TreeState& tree) {
  const std::vector<Metamers::Axis>& axes = tree.metamers.axes;
  std::vector<Candidate> shoots;
  for (AxisIndex axis = 0; axis < axes.size(); ++axis) {
    if (tree.leads.is_heir[axis] != 0 || axes[axis].is_loose) continue;
    const MetamerIndex last = axes[lead_end(tree.leads, axis)].last;
    if (last == 0) continue;  // only the seed
    shoots.push_back({axis, axis == 0 ? tree.metamers.terminal[0].metamer() : axes[axis].first, last});
  }
  return shoots;
}

}  // namespace

const std::vector<std::string>& tree_variables() {
  static const std::vector<std::string> names = {"iteration", "height",   "width",
                                                 "metamers",  "laterals", "leader_length"};
  return names;
}

const std::vector<std::string>& shoot_variables() {
  static const std::vector<std::string> names = {"rank",   "length",      "age",     "light",     "resource", "radius",
                                                 "height", "inclination", "azimuth", "clearance", "inward",   "marked"};
  return names;
}

std::vector<Shoot> choose_shoots(const TreeState& tree, const TreeOperation& operation) {
  const ShootChoice& choice = operation.shoots;
  if (choice.kind == ShootChoice::Kind::label) {
    const std::optional<AxisIndex> axis = tree.metamers.find_shoot(choice.text);
    if (!axis) refuse_label(tree, operation);
    return {{*axis, axis_path(tree.metamers, *axis)}};
  }
  if (choice.kind == ShootChoice::Kind::leader) {
    if (tree.leads.leader == kNoAxis) return {};
    return {{0, lead_path(tree.metamers, tree.leads, 0)}};
  }
  const std::vector<Candidate> shoots = all_shoots(tree);
  if (shoots.empty()) return {};
  const ShootColumns columns(tree, shoots, choice.condition);
  std::vector<RandomKey> keys;
  if (choice.condition.is_random()) {
    for (const Candidate& shoot : shoots) keys.push_back(tree.key.child(tree.metamers.axes[shoot.axis].key.bits()));
  }
  std::vector<double> found(shoots.size());
  const std::vector<const double*> pointers = columns.pointers();
  choice.condition.evaluate(shoots.size(), pointers, keys, found.data());
  std::vector<Shoot> chosen;
  for (std::size_t k = 0; k < shoots.size(); ++k) {
    if (!is_true(found[k])) continue;
    chosen.push_back({shoots[k].axis, lead_path(tree.metamers, tree.leads, shoots[k].axis)});
  }
  return chosen;
}

bool holds(const TreeState& tree, const OperationSchedule& when) {
  if (!when.when) return true;
  const Metamers& metamers = tree.metamers;
  Box around;
  std::size_t count = 0;
  for (MetamerIndex metamer = 0; metamer < metamers.count(); ++metamer) {
    if (metamers.is_loose(metamer)) continue;
    around.add(metamers.tip[metamer]);
    ++count;
  }
  const std::vector<MetamerIndex> leader = lead_path(metamers, tree.leads, 0);
  std::size_t laterals = 0;
  for (const MetamerIndex metamer : leader) {
    const Bud bud = metamers.lateral[metamer];
    if (bud.is_grown() && tree.leads.from[metamers.axis[metamer]] != metamer) ++laterals;
  }
  const double width = std::max(around.high.x - around.low.x, around.high.z - around.low.z);
  const double values[] = {static_cast<double>(tree.iteration),
                           around.high.y,
                           width,
                           static_cast<double>(count - 1),
                           static_cast<double>(laterals),
                           path_length(metamers, leader)};
  return is_true(when.when->evaluate(values, tree.key.child("when")));
}

}  // namespace meristem
