// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/organize/standing_tree.h"

#include <utility>

namespace meristem {

StandingTree::StandingTree(const Place& place, StandSpace& space, Metamers seed, const std::optional<BranchSag>& sag,
                           const PipeModel& radii)
    : space_(space), root_(place.root), metamers_(std::move(seed)), scene_light_(place.scene, place.root) {
  if (sag) load_.emplace(*sag, radii, place.directions, place.root);
}

MetamerIndex StandingTree::grow(MetamerIndex from, bool is_lateral, int iteration, Vec3 tip, Vec3 side) {
  const MetamerIndex made = metamers_.grow(from, is_lateral, iteration);
  metamers_.tip[made] = tip;
  metamers_.side[made] = side;
  scene_light_.add(world(made));
  if (space_.is_felt()) changes_.grow(world(made), metamers_.length(made));
  return made;
}

void StandingTree::leave_stub(MetamerIndex from, bool is_lateral, Vec3 tip, float lost) {
  // A stub is as old as the wood that bears it, so it has no leaves.
  const MetamerIndex made = grow(from, is_lateral, metamers_.birth[from], tip, metamers_.side[from]);
  metamers_.terminal[made] = Bud::damaged();
  metamers_.lateral[made] = Bud::dead();
  metamers_.lost_tips[made] = lost;
  metamers_.lost_tips[from] -= lost;
}

void StandingTree::move(TreePose pose) {
  const std::vector<Vec3> before = std::exchange(metamers_.tip, std::move(pose.tip));
  metamers_.side = std::move(pose.side);
  if (load_ && !pose.moment.empty()) load_->take(std::move(pose.moment));
  for (MetamerIndex metamer = 1; metamer < metamers_.count(); ++metamer) {
    const MetamerIndex parent = metamers_.parent[metamer];
    if (metamers_.tip[metamer] == before[metamer] && metamers_.tip[parent] == before[parent]) continue;
    scene_light_.move(metamer, world(metamer));
    if (!space_.is_felt()) continue;
    changes_.lose(root_ + before[metamer], glm::distance(before[metamer], before[parent]));
    changes_.grow(world(metamer), metamers_.length(metamer));
  }
}

void StandingTree::sag(int iteration) {
  if (load_) move(load_->bend(metamers_, iteration));
}

void StandingTree::settle() {
  constexpr int kNever = -1;  // an iteration without leaves
  if (load_) load_->take(load_->bend(metamers_, kNever).moment);
}

void StandingTree::restore(State state) {
  changes_ = std::move(state.changes);
  metamers_ = std::move(state.metamers);
  scene_light_.restore(std::move(state.scene_light));
  if (load_) load_->restore(std::move(*state.load));
}

void StandingTree::close(MetamerIndex metamer, bool is_lateral, Bud closed) {
  Bud& bud = (is_lateral ? metamers_.lateral : metamers_.terminal)[metamer];
  if (bud.is_open()) bud = closed;
}

void StandingTree::cut_off(MetamerIndex first, const BudsLeft& after) {
  if (space_.is_felt()) {
    for (const MetamerIndex metamer : metamers_.with_borne(first)) {
      changes_.lose(world(metamer), metamers_.length(metamer));
    }
  }
  metamers_.cut_off(first, after);
}

std::vector<std::uint8_t> StandingTree::clear_away() {
  std::vector<std::uint8_t> gone = metamers_.clear_away();
  if (gone.empty()) return gone;
  scene_light_.remove(gone);
  if (load_) load_->remove(gone);
  return gone;
}

}  // namespace meristem
