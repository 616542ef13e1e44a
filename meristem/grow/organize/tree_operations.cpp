// SPDX-License-Identifier: Apache-2.0
// Applies the operations to a tree. grow/prune computes the effect of each operation from the metamers alone. Supports
// are set before the growth of an iteration, so that the new metamers follow them. All other operations act after the
// growth, in the document's order.
#include <algorithm>
#include <utility>
#include <variant>

#include "meristem/grow/organize/organized_tree.h"
#include "meristem/grow/prune/choose_shoots.h"
#include "meristem/grow/prune/work_recorder.h"

namespace meristem {

TreeState OrganizedTree::state_for(std::size_t operation, int iteration) const {
  const OrganizeParameters& parameters = species_->parameters;
  return {.metamers = metamers_,
          .leads = upkeep_.leads,
          .flow = flow_,
          .radii = parameters.radii,
          .iteration = iteration,
          .key = key_.child("operations").child(operation).child(static_cast<std::uint64_t>(iteration)),
          .in_pairs = parameters.phyllotaxis.kind == Phyllotaxis::Kind::decussate,
          .marks = parameters.marks.size()};
}

/// Ties shoots and buds to the supports of this iteration, and unties them from expired supports.
void OrganizedTree::tie_shoots(int iteration) {
  misses_.clear();
  upkeep_.leads = find_leads(metamers_);
  ties_.forget_buds();
  const std::vector<TreeOperation>& operations = species_->parameters.operations;
  for (std::size_t k = 0; k < operations.size(); ++k) {
    const TreeOperation& operation = operations[k];
    if (operation.tree && *operation.tree != number_) continue;
    if (const auto* support = std::get_if<TrainingSupport>(&operation.what); support && iteration > support->until) {
      for (AxisIndex axis = 0; axis < metamers_.axes.size(); ++axis) {
        if (metamers_.axes[axis].tie == ties_.line_of(k)) tree_.tie(axis, 0);
      }
      continue;
    }
    if (!operation.when.is_in_turn(iteration) || (operation.when.once && upkeep_.is_done[k] != 0)) continue;
    const TreeState state = state_for(k, iteration - 1);
    if (const auto* layers = std::get_if<LayersOperation>(&operation.what)) {
      if (holds(state, operation.when)) ties_.add_arms(find_arms(metamers_, upkeep_.leads, *layers), ties_.line_of(k));
      continue;
    }
    if (!std::holds_alternative<TrainingSupport>(operation.what) || !holds(state, operation.when)) continue;
    try {
      for (const Shoot& shoot : choose_shoots(state, operation)) {
        tree_.tie(shoot.axis, ties_.line_of(k));
        for (const MetamerIndex metamer : shoot.path) tree_.tie(metamers_.axis[metamer], ties_.line_of(k));
      }
      upkeep_.is_done[k] = 1;
    } catch (const InputError& error) {
      misses_.push_back({k, error});
    }
  }
}

/// Performs the operations of this iteration's summer or winter. If the last winter is only planned, computes the
/// effect of its operations.
void OrganizedTree::operate(int iteration, bool in_summer, const Progress& progress) {
  if (in_summer || !species_->parameters.plans || iteration != species_->parameters.iterations) {
    return perform(iteration, in_summer, progress);
  }
  // Each operation depends on the earlier ones. Therefore perform all of them, then restore the tree.
  State before = state();
  tree_.take_changes();  // reported by the restored tree and, for the plan, by its outcome
  std::vector<OperationRecord> all = std::exchange(records_, {});
  plan_cuts_.assign(metamers_.count(), 0);
  perform(iteration, in_summer, progress);
  before.records = records_;
  if (species_->parameters.request.has(TracePart::outcome)) {
    all.insert(all.end(), records_.begin(), records_.end());
    records_ = std::move(all);
    outcome_ = std::make_unique<State>(state());
  }
  restore(std::move(before));
}

void OrganizedTree::restore(State state) {
  tree_.restore(std::move(state.tree));
  flow_ = std::move(state.flow);
  upkeep_ = std::move(state.upkeep);
  crop_ = std::move(state.crop);
  wood_ = std::move(state.wood);
  fallen_ = std::move(state.fallen);
  losses_ = std::move(state.losses);
  records_ = std::move(state.records);
}

void OrganizedTree::do_plan() {
  restore(std::move(*outcome_));
  outcome_.reset();
  is_outcome_ = true;
  senses_->look_again();
}

void OrganizedTree::note_planned(MetamerIndex first, int operation) {
  for (const MetamerIndex metamer : metamers_.with_borne(first)) {
    plan_cuts_[metamer] = static_cast<std::uint16_t>(operation);
  }
}

void OrganizedTree::perform(int iteration, bool in_summer, const Progress& progress) {
  const std::vector<TreeOperation>& operations = species_->parameters.operations;
  upkeep_.leads = find_leads(metamers_);
  girth_.reset();
  for (std::size_t k = 0; k < operations.size(); ++k) {
    const TreeOperation& operation = operations[k];
    if (!operation.when.is_in_turn(iteration) || operation.when.in_summer != in_summer) continue;
    if (operation.when.once && upkeep_.is_done[k] != 0) continue;
    if ((operation.tree && *operation.tree != number_) || std::holds_alternative<TrainingSupport>(operation.what))
      continue;
    progress.check();
    const TreeState state = state_for(k, iteration);
    if (!holds(state, operation.when)) continue;
    try {
      apply(find_work(state, operation), iteration, k, in_summer);
      upkeep_.is_done[k] = 1;
    } catch (const InputError& error) {
      misses_.push_back({k, error});
    }
  }
  girth_.reset();
  // Clear away once for all operations, so that the cost depends on what is removed and not on the tree.
  if (clear_away()) {
    leave_stubs();
    upkeep_.leads = find_leads(metamers_);
  }
  if (!in_summer && !upkeep_.bows.empty()) tree_.move(upkeep_.bows.bend(metamers_));
}

void OrganizedTree::ring(const Ring& ring, int iteration) {
  upkeep_.ringed.resize(metamers_.count(), 0);
  upkeep_.ringed_until.resize(metamers_.count(), 0);
  upkeep_.ringed[ring.metamer] = static_cast<float>(ring.share);
  upkeep_.ringed_until[ring.metamer] =
      static_cast<std::uint16_t>(std::min(iteration + ring.iterations, kLastIteration));
}

const std::vector<float>& OrganizedTree::ringed(int iteration) {
  if (upkeep_.ringed.empty()) return upkeep_.ringed;
  upkeep_.ringed.resize(metamers_.count(), 0);
  upkeep_.ringed_until.resize(metamers_.count(), 0);
  bool any = false;
  for (std::size_t metamer = 0; metamer < upkeep_.ringed.size(); ++metamer) {
    if (upkeep_.ringed_until[metamer] < iteration) upkeep_.ringed[metamer] = 0;
    any = any || upkeep_.ringed[metamer] > 0;
  }
  if (!any) upkeep_.ringed.clear();
  return upkeep_.ringed;
}

/// Begins to bend a shoot, and ties the part beyond the bend.
void OrganizedTree::bend(const Bow& bow, std::size_t operation) {
  upkeep_.bows.add(bow);
  for (MetamerIndex metamer = bow.tip;; metamer = metamers_.parent[metamer]) {
    tree_.tie(metamers_.axis[metamer], ties_.line_of(operation));
    if (metamer == bow.first) return;
  }
}

/// Records the effects of an operation before it is applied.
void OrganizedTree::record(const OperationWork& work, int iteration, const TreeOperation& operation) {
  // Compute the radii on first use, before anything is cut.
  const auto radius_of = [&](MetamerIndex metamer) {
    if (!girth_) girth_.emplace(metamers_, wood_, species_->parameters.radii);
    return girth_->radius(metamer);
  };
  const WorkRecorder recorder({.metamers = metamers_,
                               .leads = upkeep_.leads,
                               .flow = flow_,
                               .radii = species_->parameters.radii,
                               .iteration = iteration,
                               .key = RandomKey()},
                              operation, static_cast<std::uint32_t>(number_), radius_of);
  for (WorkRecorder::Noted& noted : recorder.note(work)) {
    if (noted.record.act == "cut") upkeep_.wounds.add(metamers_.count(), noted.at, noted.record, noted.section);
    records_.push_back(std::move(noted.record));
  }
}

void OrganizedTree::note_answering(const OperationWork& work) {
  const auto note = [&](MetamerIndex metamer) {
    answering_.insert(metamers_.axes[metamers_.axis[metamer]].key.bits());
  };
  for (const MetamerIndex metamer : work.pinched) note(metamer);
  for (const MetamerIndex metamer : work.gone) note(metamers_.parent[metamer]);
}

void OrganizedTree::apply(const OperationWork& work, int iteration, std::size_t operation, bool in_summer) {
  const bool damages = species_->parameters.damage;
  if (in_summer) note_answering(work);
  record(work, iteration, species_->parameters.operations[operation]);
  for (const AxisIndex axis : work.marked) tree_.mark(axis, work.mark);
  for (const Ring& place : work.rings) ring(place, iteration);
  for (const Bow& bow : work.bows) bend(bow, operation);
  for (const AxisIndex axis : work.headless) tree_.deny_heir(axis);
  if (damages) {
    for (const MetamerIndex metamer : work.pinched) tree_.damage(metamer, false);
    for (const MetamerIndex metamer : work.lifted) tree_.damage(metamer, true);
  }
  // Metamers beyond a cut have larger indices, so sorting finds the outermost cuts first.
  std::vector<MetamerIndex> gone = work.gone;
  std::ranges::sort(gone);
  const Bud after = damages ? Bud::damaged() : Bud();
  const LossReason why{LossCause::cut, species_->parameters.operations[operation].path};
  for (const MetamerIndex metamer : gone) {
    if (metamers_.is_loose(metamer)) continue;
    if (!plan_cuts_.empty()) note_planned(metamer, species_->parameters.operations[operation].number);
    const MetamerIndex from = metamers_.parent[metamer];
    const float lost = metamers_.lost_tips[from];
    const Vec3 tip = glm::mix(metamers_.tip[from], metamers_.tip[metamer], static_cast<float>(work.stub));
    const bool is_lateral = metamers_.begins_shoot(metamer);
    cut_off(metamer, {after, work.renews ? Bud() : after}, iteration, why);
    if (work.stub > 0 && from != 0) stubs_.push_back({from, is_lateral, tip, metamers_.lost_tips[from] - lost});
  }
  const bool is_changed = !work.headless.empty() || !work.gone.empty() || !work.pinched.empty();
  if (is_changed || !work.lifted.empty()) upkeep_.leads = find_leads(metamers_);
}

}  // namespace meristem
