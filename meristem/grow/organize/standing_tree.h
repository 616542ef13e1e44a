// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "meristem/grow/metamer/metamers.h"
#include "meristem/grow/organize/bud_sense.h"
#include "meristem/grow/organize/sag.h"
#include "meristem/grow/stand_space.h"

namespace meristem {

/// A tree's metamers at their positions in a scene. Each change of metamers also updates everything that depends on
/// positions. This includes shade and occupied space (bitwise exact), the light of the scene at each metamer, and the
/// load of the branches. tell() reports the changes to the stand. `scene` and `space` must outlive it. It cannot be
/// moved, because other objects keep references to its parts.
class StandingTree {
 public:
  /// The surroundings of the tree.
  struct Place {
    const Scene& scene;
    const Directions& directions;  ///< gravity
    Vec3 root{0};                  ///< world space
  };
  /// `seed` has one metamer, at the place's root. Branches bend under their load if `sag` is set.
  StandingTree(const Place& place, StandSpace& space, Metamers seed, const std::optional<BranchSag>& sag,
               const PipeModel& radii);
  StandingTree(const StandingTree&) = delete;
  StandingTree& operator=(const StandingTree&) = delete;

  const Metamers& metamers() const { return metamers_; }
  const SceneLight& scene_light() const { return scene_light_; }
  /// Returns the end of a metamer in world space.
  Vec3 world(MetamerIndex metamer) const { return root_ + metamers_.tip[metamer]; }

  void reserve(std::size_t metamers) { metamers_.reserve(metamers); }
  /// Grows an open bud into a metamer that ends at `tip` (metres from the root). Its lateral bud points to `side`.
  MetamerIndex grow(MetamerIndex from, bool is_lateral, int iteration, Vec3 tip, Vec3 side);
  /// Moves all metamers to the positions of `pose`. The result is as if they had grown there. Cost: small for metamers
  /// that do not move. Without moments, the load keeps its last moments.
  void move(TreePose pose);
  /// Bends the branches by the increase of their load; see BranchLoad.
  void sag(int iteration);
  /// Removes metamers in two steps, like Metamers::cut_off() and Metamers::clear_away().
  void cut_off(MetamerIndex first, const BudsLeft& after);
  std::vector<std::uint8_t> clear_away();
  /// Damages a metamer's terminal or lateral bud if it is open.
  void damage(MetamerIndex metamer, bool is_lateral) { close(metamer, is_lateral, Bud::damaged()); }
  /// Sets an open terminal or lateral bud to the state `closed`, damaged or dead.
  void close(MetamerIndex metamer, bool is_lateral, Bud closed);
  /// Leaves a dead stub from the tip of `from` to `tip` where a shoot was cut off, and gives it the `lost` tips of that
  /// shoot, so that it is as thick as the shoot was. Call it after clear_away().
  void leave_stub(MetamerIndex from, bool is_lateral, Vec3 tip, float lost);
  /// Treats the present load as already borne: only changes of it will bend the branches.
  void settle();
  /// Ties a shoot to the line with this number; 0 unties it.
  void tie(AxisIndex axis, std::uint32_t line) { metamers_.axes[axis].tie = line; }
  /// Prevents other shoots from succeeding this one.
  void deny_heir(AxisIndex axis) { metamers_.axes[axis].has_no_heir = true; }
  /// Gives a shoot the mark with this number, below kMaxMarks.
  void mark(AxisIndex axis, std::uint32_t state) { metamers_.axes[axis].marks |= 1U << state; }
  /// Reports all growth, moves and removals since the last call to the stand's space.
  void tell() { space_.take(changes_); }
  /// The complete state of a tree except its place.
  struct State {
    ShootChanges changes;
    Metamers metamers;
    SceneLight scene_light;
    std::optional<BranchLoad> load;
  };
  State state() const { return {changes_, metamers_, scene_light_, load_}; }
  /// Restores an earlier state.
  void restore(State state);
  /// Returns the changes that have not been reported, and clears them.
  ShootChanges take_changes() { return std::exchange(changes_, {}); }
  /// Moves the metamers out of this object.
  Metamers take_metamers() { return std::move(metamers_); }

 private:
  StandSpace& space_;
  ShootChanges changes_;
  Vec3 root_;
  Metamers metamers_;
  SceneLight scene_light_;
  std::optional<BranchLoad> load_;
};

}  // namespace meristem
