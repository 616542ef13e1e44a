// SPDX-License-Identifier: Apache-2.0
// Applies the operations to a tree. The effect of each operation is computed in grow/prune from the metamers alone.
// Supports are set before the growth of an iteration, so that the new metamers follow them; all other operations act
// after the growth, in the document's order.
#include <algorithm>
#include <variant>

#include "meristem/grow/organize/organized_tree.h"
#include "meristem/grow/prune/choose_shoots.h"

namespace meristem {

TreeState OrganizedTree::state_for(std::size_t operation, int iteration) const {
  const OrganizeParameters& parameters = species_->parameters;
  return {.metamers = metamers_,
          .leads = leads_,
          .flow = flow_,
          .radii = parameters.radii,
          .iteration = iteration,
          .key = key_.child("operations").child(operation).child(static_cast<std::uint64_t>(iteration)),
          .in_pairs = parameters.phyllotaxis.kind == Phyllotaxis::Kind::decussate};
}

/// Ties shoots and buds to the supports that stand in this iteration, and unties those whose time is over.
void OrganizedTree::tie_shoots(int iteration) {
  misses_.clear();
  leads_ = find_leads(metamers_);
  ties_.forget_buds();
  const std::vector<Operation>& operations = species_->parameters.operations;
  for (std::size_t k = 0; k < operations.size(); ++k) {
    const Operation& operation = operations[k];
    if (operation.tree && *operation.tree != number_) continue;
    if (const auto* support = std::get_if<Support>(&operation.what); support && iteration > support->until) {
      for (AxisIndex axis = 0; axis < metamers_.axes.size(); ++axis) {
        if (metamers_.axes[axis].tie == ties_.line_of(k)) tree_.tie(axis, 0);
      }
      continue;
    }
    if (!operation.when.is_in_turn(iteration) || (operation.when.once && is_done_[k] != 0)) continue;
    const TreeState state = state_for(k, iteration - 1);
    if (const auto* layers = std::get_if<Layers>(&operation.what)) {
      if (holds(state, operation.when)) ties_.add_arms(find_arms(metamers_, leads_, *layers), ties_.line_of(k));
      continue;
    }
    if (!std::holds_alternative<Support>(operation.what) || !holds(state, operation.when)) continue;
    try {
      for (const Shoot& shoot : choose_shoots(state, operation)) {
        tree_.tie(shoot.axis, ties_.line_of(k));
        for (const MetamerIndex metamer : shoot.path) tree_.tie(metamers_.axis[metamer], ties_.line_of(k));
      }
      is_done_[k] = 1;
    } catch (const InputError& error) {
      misses_.push_back({k, error});
    }
  }
}

/// Performs the operations of this iteration.
void OrganizedTree::operate(int iteration, const Progress& progress) {
  const std::vector<Operation>& operations = species_->parameters.operations;
  leads_ = find_leads(metamers_);
  for (std::size_t k = 0; k < operations.size(); ++k) {
    const Operation& operation = operations[k];
    if (!operation.when.is_in_turn(iteration) || (operation.when.once && is_done_[k] != 0)) continue;
    if ((operation.tree && *operation.tree != number_) || std::holds_alternative<Support>(operation.what)) continue;
    progress.check();
    const TreeState state = state_for(k, iteration);
    if (!holds(state, operation.when)) continue;
    try {
      apply(find_work(state, operation), iteration, k);
      is_done_[k] = 1;
    } catch (const InputError& error) {
      misses_.push_back({k, error});
    }
  }
  if (!bows_.empty()) tree_.move(bows_.bend(metamers_));
}

void OrganizedTree::ring(const Ring& ring, int iteration) {
  ringed_.resize(metamers_.count(), 0);
  ringed_until_.resize(metamers_.count(), 0);
  ringed_[ring.metamer] = static_cast<float>(ring.share);
  ringed_until_[ring.metamer] = static_cast<std::uint16_t>(std::min(iteration + ring.iterations, kLastIteration));
}

const std::vector<float>& OrganizedTree::ringed(int iteration) {
  if (ringed_.empty()) return ringed_;
  ringed_.resize(metamers_.count(), 0);
  ringed_until_.resize(metamers_.count(), 0);
  bool any = false;
  for (std::size_t metamer = 0; metamer < ringed_.size(); ++metamer) {
    if (ringed_until_[metamer] < iteration) ringed_[metamer] = 0;
    any = any || ringed_[metamer] > 0;
  }
  if (!any) ringed_.clear();
  return ringed_;
}

/// Begins to bend a shoot, and ties what lies beyond the bend.
void OrganizedTree::bend(const Bow& bow, std::size_t operation) {
  bows_.add(bow);
  for (MetamerIndex metamer = bow.tip;; metamer = metamers_.parent[metamer]) {
    tree_.tie(metamers_.axis[metamer], ties_.line_of(operation));
    if (metamer == bow.first) return;
  }
}

void OrganizedTree::apply(const Work& work, int iteration, std::size_t operation) {
  const bool damages = species_->parameters.damage;
  for (const AxisIndex axis : work.marked) tree_.mark(axis);
  for (const Ring& place : work.rings) ring(place, iteration);
  for (const Bow& bow : work.bows) bend(bow, operation);
  for (const AxisIndex axis : work.headless) tree_.deny_heir(axis);
  if (damages) {
    for (const MetamerIndex metamer : work.pinched) tree_.damage(metamer, false);
    for (const MetamerIndex metamer : work.lifted) tree_.damage(metamer, true);
  }
  if (!work.gone.empty()) {
    std::vector<std::uint8_t> gone(metamers_.count(), 0);
    cut_at_.resize(metamers_.count(), 0);
    for (const MetamerIndex metamer : work.gone) {
      gone[metamer] = 1;
      cut_at_[metamers_.parent[metamer]] = static_cast<std::uint16_t>(iteration);
    }
    const Bud after = damages ? Bud::damaged() : Bud();
    remove(gone, {after, work.renews ? Bud() : after}, iteration);
  }
  const bool is_changed = !work.headless.empty() || !work.gone.empty() || !work.pinched.empty();
  if (is_changed || !work.lifted.empty()) leads_ = find_leads(metamers_);
}

}  // namespace meristem
