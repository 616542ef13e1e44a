// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/prune/work.h"

#include <variant>

#include "meristem/grow/prune/choose_shoots.h"

namespace meristem {

namespace {

Work mark(const TreeState& tree, const Mark& what, const std::vector<Shoot>& shoots) {
  Work work;
  work.mark = what.state;
  for (const Shoot& shoot : shoots) {
    const RandomKey key = tree.key.child(tree.metamers.axes[shoot.axis].key.bits());
    if (key.uniform(0) < what.chance) work.marked.push_back(shoot.axis);
  }
  return work;
}

}  // namespace

Work find_work(const TreeState& tree, const Operation& operation) {
  if (const auto* layers = std::get_if<Layers>(&operation.what)) return layer(tree, *layers);
  if (std::holds_alternative<Support>(operation.what)) return {};
  const std::vector<Shoot> shoots = choose_shoots(tree, operation);
  if (const auto* what = std::get_if<Cut>(&operation.what)) return cut(tree, operation, *what, shoots);
  if (const auto* what = std::get_if<Spur>(&operation.what)) return spur(tree, *what, shoots);
  if (const auto* what = std::get_if<Limit>(&operation.what)) return limit(tree, *what, shoots);
  if (const auto* what = std::get_if<Girdle>(&operation.what)) return girdle(operation, *what, shoots);
  if (const auto* what = std::get_if<Bend>(&operation.what)) return bend(tree, operation, *what, shoots);
  if (const auto* what = std::get_if<Tie>(&operation.what)) return tie(tree, operation, *what, shoots);
  return mark(tree, std::get<Mark>(operation.what), shoots);
}

}  // namespace meristem
