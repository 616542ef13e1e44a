// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/prune/work.h"

#include <variant>

#include "meristem/grow/prune/choose_shoots.h"

namespace meristem {

namespace {

OperationWork mark(const TreeState& tree, const MarkOperation& what, const std::vector<Shoot>& shoots) {
  OperationWork work;
  work.mark = what.state;
  for (const Shoot& shoot : shoots) {
    const RandomKey key = tree.key.child(tree.metamers.axes[shoot.axis].key.bits());
    if (key.uniform(0) < what.chance) work.marked.push_back(shoot.axis);
  }
  return work;
}

}  // namespace

OperationWork find_work(const TreeState& tree, const TreeOperation& operation) {
  if (const auto* layers = std::get_if<LayersOperation>(&operation.what)) return layer(tree, *layers);
  if (std::holds_alternative<TrainingSupport>(operation.what)) return {};
  const std::vector<Shoot> shoots = choose_shoots(tree, operation);
  if (const auto* what = std::get_if<CutOperation>(&operation.what)) return cut(tree, operation, *what, shoots);
  if (const auto* what = std::get_if<SpurOperation>(&operation.what)) return spur(tree, *what, shoots);
  if (const auto* what = std::get_if<LimitOperation>(&operation.what)) return limit(tree, *what, shoots);
  if (const auto* what = std::get_if<GirdleOperation>(&operation.what)) return girdle(operation, *what, shoots);
  if (const auto* what = std::get_if<BendOperation>(&operation.what)) return bend(tree, operation, *what, shoots);
  if (const auto* what = std::get_if<TieOperation>(&operation.what)) return tie(tree, operation, *what, shoots);
  return mark(tree, std::get<MarkOperation>(operation.what), shoots);
}

}  // namespace meristem
