// SPDX-License-Identifier: Apache-2.0
// Finds the positions of cuts. A cut is given by the first metamer that it removes.
//
// Based on: J. Stevens: Automatische generatie van gesnoeide boom modellen, Universiteit Hasselt 2023, sections 4.2.3
// and 4.2.4. In the source, the shoot is cut back to the first bud near the middle that faces down. Here, `window` also
// allows choosing the best-facing bud.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/frame.h"
#include "meristem/grow/prune/work.h"

namespace meristem {

namespace {

[[noreturn]] void refuse(const TreeOperation& operation, const char* key, std::string message, std::string expected) {
  throw InputError(Diagnostic{.message = std::move(message),
                              .expected = std::move(expected),
                              .path = fmt::format("{}.{}", operation.path, key)});
}

bool is_alive(Bud bud) { return bud.is_open() || bud.is_grown(); }

class Cutter {
 public:
  Cutter(const TreeState& tree, const TreeOperation& operation, const CutOperation& what)
      : tree_(tree), metamers_(tree.metamers), operation_(operation), what_(what) {}

  /// Returns the first removed metamers of a shoot.
  std::vector<MetamerIndex> cuts(const Shoot& shoot) const {
    if (shoot.path.empty()) return {};
    if (what_.place == CutOperation::Place::outside) return outside(shoot);
    const std::optional<std::size_t> stays = find_stay(shoot);
    if (!stays) return {};
    const std::size_t kept = *stays == 0 ? 0 : above_bud(shoot.path, *stays);
    if (kept >= shoot.path.size() || (kept == 0 && shoot.axis == 0)) return {};
    return {shoot.path[kept]};
  }

 private:
  bool is_named() const { return operation_.shoots.kind == ShootChoice::Kind::label; }

  /// Returns how many metamers of a shoot should stay, or nothing if there is nothing to cut.
  std::optional<std::size_t> find_stay(const Shoot& shoot) const {
    switch (what_.place) {
      case CutOperation::Place::above:
        return stay_above(shoot);
      case CutOperation::Place::above_lateral:
        return stay_above_lateral(shoot);
      default:
        return stay_to_bud(shoot);
    }
  }

  std::optional<std::size_t> stay_above(const Shoot& shoot) const {
    const auto above = static_cast<std::size_t>(what_.above);
    if (above < shoot.path.size() && (above > 0 || shoot.axis != 0)) return above;
    if (!is_named()) return std::nullopt;
    if (above == 0) refuse(operation_, "above", "nothing would be left of the tree", "a whole number of at least 1");
    refuse(operation_, "above",
           fmt::format("'{}' has {} metamers after iteration {}, and none above that", operation_.shoots.text,
                       shoot.path.size(), tree_.iteration),
           "fewer metamers that stay, or a later iteration");
  }

  std::optional<std::size_t> stay_above_lateral(const Shoot& shoot) const {
    const RandomKey key = tree_.key.child(metamers_.axes[shoot.axis].key.bits());
    const double wanted = std::floor(what_.lateral.evaluate({}, key) + 0.5);
    double found = 0;
    for (std::size_t k = 0; k < shoot.path.size(); ++k) {
      const Bud bud = metamers_.lateral[shoot.path[k]];
      const bool is_lateral = bud.is_grown() && (k + 1 == shoot.path.size() || bud.metamer() != shoot.path[k + 1]);
      if (is_lateral && ++found == wanted) return k + 1;
    }
    if (!is_named()) return std::nullopt;
    refuse(operation_, "above_lateral",
           fmt::format("'{}' has {:.0f} lateral shoots after iteration {}, and the cut is above number {:.6g}",
                       operation_.shoots.text, found, tree_.iteration, wanted),
           "the number of a lateral shoot that exists, from 1");
  }

  /// Returns the desired direction of a bud at a metamer.
  Vec3 wanted_way(MetamerIndex metamer) const {
    const Vec3 tip = metamers_.tip[metamer];
    switch (what_.toward) {
      case CutOperation::Toward::up:
        return kUp;
      case CutOperation::Toward::down:
        return -kUp;
      case CutOperation::Toward::out:
        return normalized_or(Vec3(tip.x, 0, tip.z), metamers_.heading(metamer));
      default:
        return what_.direction;
    }
  }

  /// Finds the dormant bud that faces the desired direction, near the middle of the youngest section. A bud faces the
  /// direction if it points there more than its mirror image on the other side of the shoot.
  std::optional<std::size_t> stay_to_bud(const Shoot& shoot) const {
    const std::vector<MetamerIndex>& path = shoot.path;
    std::size_t begin = path.size();
    while (begin > 0 && metamers_.axis[path[begin - 1]] == metamers_.axis[path.back()]) --begin;
    const auto middle = static_cast<std::ptrdiff_t>(begin + (path.size() - begin - 1) / 2);
    std::optional<std::ptrdiff_t> best;
    double best_facing = 0;
    for (std::ptrdiff_t away = 0; away < static_cast<std::ptrdiff_t>(path.size()); ++away) {
      if (best && away > what_.window) break;
      for (const std::ptrdiff_t at : {middle + away, middle - away}) {
        // At least one metamer must be left to cut.
        if (at < static_cast<std::ptrdiff_t>(begin) || at + 1 >= static_cast<std::ptrdiff_t>(path.size())) continue;
        const MetamerIndex metamer = path[static_cast<std::size_t>(at)];
        if (!metamers_.lateral[metamer].is_open()) continue;
        const double facing = glm::dot(metamers_.side[metamer], wanted_way(metamer));
        if (facing <= best_facing) continue;
        best = at;
        best_facing = facing;
      }
    }
    if (best) return static_cast<std::size_t>(*best) + 1;
    if (!is_named()) return std::nullopt;
    refuse(operation_, "to_bud",
           fmt::format("no sleeping bud of '{}' faces that way after iteration {}", operation_.shoots.text,
                       tree_.iteration),
           "another side, or another shoot");
  }

  /// Returns the nearest number of metamers that may stay: the last one has a living lateral bud or shoot, and pairs
  /// stay complete.
  std::size_t above_bud(const std::vector<MetamerIndex>& path, std::size_t stays) const {
    if (tree_.in_pairs && stays < path.size() && metamers_.number[path[stays - 1]] % 2 != 0) ++stays;
    std::size_t kept = std::min(stays, path.size());
    while (kept > 1 && !is_alive(metamers_.lateral[path[kept - 1]])) --kept;
    // Without a living bud, the whole shoot is removed, except for the stem, which must not vanish.
    if (kept == 1 && !is_alive(metamers_.lateral[path[0]]) && metamers_.axis[path[0]] != 0) return 0;
    return kept;
  }

  std::vector<MetamerIndex> outside(const Shoot& shoot) const {
    for (std::size_t k = 0; k < shoot.path.size(); ++k) {
      if (what_.outside->contains(metamers_.tip[shoot.path[k]])) continue;
      // Remove a pair completely if the surface separates it.
      const bool parts_pair = tree_.in_pairs && k > 0 && metamers_.number[shoot.path[k - 1]] % 2 != 0;
      const std::size_t within = parts_pair ? k - 1 : k;
      const std::size_t kept = within == 0 ? 0 : above_bud(shoot.path, within);
      if (kept == 0 && shoot.axis == 0) return {};
      return {shoot.path[kept]};
    }
    return {};
  }

  const TreeState& tree_;
  const Metamers& metamers_;
  const TreeOperation& operation_;
  const CutOperation& what_;
};

}  // namespace

OperationWork cut(const TreeState& tree, const TreeOperation& operation, const CutOperation& what,
                  const std::vector<Shoot>& shoots) {
  const Cutter cutter(tree, operation, what);
  OperationWork work;
  work.stub = what.stub;
  for (const Shoot& shoot : shoots) {
    for (const MetamerIndex metamer : cutter.cuts(shoot)) {
      work.gone.push_back(metamer);
      if (!what.has_successor && !tree.metamers.begins_shoot(metamer)) {
        work.headless.push_back(tree.metamers.axis[metamer]);
      }
    }
  }
  return work;
}

}  // namespace meristem
