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

/// A tree's metamers where they stand in a scene. What changes them changes by the same call what depends on their
/// positions: the light and room that the stand's plants take from each other, to the last bit, the light of the scene
/// that reaches each metamer, and the load of the branches. The stand's plants hear of it by tell(). `scene` and
/// `space` outlive it; it stays where it is, as others keep references to its parts.
class StandingTree {
 public:
  /// What surrounds the tree.
  struct Place {
    const Scene& scene;
    const Directions& directions;  ///< of gravity
    Vec3 root{0};                  ///< world space
  };
  /// `seed` is one metamer, at the place's root. Branches bend under their load where a `sag` is given.
  StandingTree(const Place& place, StandSpace& space, Metamers seed, const std::optional<Sag>& sag,
               const PipeModel& radii);
  StandingTree(const StandingTree&) = delete;
  StandingTree& operator=(const StandingTree&) = delete;

  const Metamers& metamers() const { return metamers_; }
  const SceneLight& scene_light() const { return scene_light_; }
  /// The end of a metamer in world space.
  Vec3 world(MetamerIndex metamer) const { return root_ + metamers_.tip[metamer]; }

  void reserve(std::size_t metamers) { metamers_.reserve(metamers); }
  /// Grows an open bud into a metamer that ends at `tip` (metres from the root) with its lateral bud on `side`.
  MetamerIndex grow(MetamerIndex from, bool is_lateral, int iteration, Vec3 tip, Vec3 side);
  /// Brings all metamers to where `pose` has them; afterwards everything is as if they had grown there. Those that stay
  /// where they are cost nothing but a look. Without moments the load stays as it was taken last.
  void move(Pose pose);
  /// Bends the branches by what their load has grown; see BranchLoad.
  void sag(int iteration);
  /// Takes metamers away in two steps, as Metamers::cut_off() and Metamers::clear_away().
  void cut_off(MetamerIndex first, const BudsLeft& after);
  std::vector<std::uint8_t> clear_away();
  /// Damages a metamer's terminal or lateral bud if that is open.
  void damage(MetamerIndex metamer, bool is_lateral) { close(metamer, is_lateral, Bud::damaged()); }
  /// Makes a metamer's terminal or lateral bud a damaged or dead one if it is open.
  void close(MetamerIndex metamer, bool is_lateral, Bud closed);
  /// Takes the present load as one that the branches stand under already: only more of it will bend them.
  void settle();
  /// Ties a shoot to a line by its number, 0 to none.
  void tie(AxisIndex axis, std::uint32_t line) { metamers_.axes[axis].tie = line; }
  /// Lets no other shoot succeed this one.
  void deny_heir(AxisIndex axis) { metamers_.axes[axis].has_no_heir = true; }
  /// Gives a shoot the mark of this number, below kMostMarks.
  void mark(AxisIndex axis, std::uint32_t state) { metamers_.axes[axis].marks |= 1U << state; }
  /// Tells the stand's space what was grown, moved and removed since the last time.
  void tell() { space_.take(changes_); }
  /// All of a tree but where it stands.
  struct State {
    ShootChanges changes;
    Metamers metamers;
    SceneLight scene_light;
    std::optional<BranchLoad> load;
  };
  State state() const { return {changes_, metamers_, scene_light_, load_}; }
  /// Makes it what it was.
  void restore(State state);
  /// What the stand's space has not been told yet; then nothing is left of it to tell.
  ShootChanges take_changes() { return std::exchange(changes_, {}); }
  /// What has grown; then nothing is left.
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
