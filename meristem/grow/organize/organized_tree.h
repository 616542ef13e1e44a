// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/progress.h"
#include "meristem/grow/metamer/metamers.h"
#include "meristem/grow/metamer/resource.h"
#include "meristem/grow/organize/bud_sense.h"
#include "meristem/grow/organize/crop.h"
#include "meristem/grow/organize/cut_wounds.h"
#include "meristem/grow/organize/fallen_shoots.h"
#include "meristem/grow/organize/species.h"
#include "meristem/grow/organize/standing_tree.h"
#include "meristem/grow/organize/standing_wood.h"
#include "meristem/grow/organize/tree_bows.h"
#include "meristem/grow/organize/tree_ties.h"
#include "meristem/grow/organize/wood_girth.h"
#include "meristem/grow/prune/leads.h"
#include "meristem/grow/prune/work.h"
#include "meristem/grow/stand_space.h"
#include "meristem/plant/operation_record.h"

namespace meristem {

/// The part of an iteration's growth that one call performs.
enum class Flush {
  whole,
  first,  ///< the share of each shoot that grows before summer operations
  rest,   ///< the rest of these shoots, and new growth of buds of shoots that were cut
};

/// One self-organizing tree during growth. `species` and `space` must outlive it.
class OrganizedTree {
 public:
  /// `number` is the number of the tree's root.
  OrganizedTree(const OrganizedSpecies& species, StandSpace& space, const OrganizeSeed& seed, RandomKey key,
                int number);
  OrganizedTree(const OrganizedTree&) = delete;
  OrganizedTree& operator=(const OrganizedTree&) = delete;

  /// Converts existing wood to metamers of iteration 0. Call it once, before the first sense(). Throws InputError if
  /// the wood is too far from the world's origin.
  void stand(const Skeleton& wood);
  /// Computes the light of all buds from the current state of the stand's space, and divides the resulting resource.
  void sense(int iteration, const Progress& progress);
  /// Finds the buds that will grow in this iteration. Call it after sense(). Returns an upper bound for the number of
  /// new metamers.
  std::uint64_t plan(Flush flush);
  /// Grows, sags and sheds, and performs the operations. Call it after plan().
  void iterate(int iteration, Flush flush, const Progress& progress);
  /// Reports the changes to the stand's space.
  void tell() { tree_.tell(); }

  const Metamers& metamers() const { return tree_.metamers(); }
  bool has_grown() const { return has_grown_; }
  const ResourceFlow& flow() const { return flow_; }  ///< of the last sense()
  /// An operation whose named shoot does not exist or has nothing to remove.
  struct Miss {
    std::size_t operation = 0;
    InputError error;
  };
  const std::vector<Miss>& misses() const { return misses_; }  ///< of the last iterate()
  /// Returns the skeleton in world space. Call it once.
  Skeleton take_skeleton(const Progress& progress);
  /// Returns the skeleton as take_skeleton() does, but without fallen shoots. Valid after sense().
  Skeleton skeleton(const Progress& progress) const;
  /// The directions that its buds found in the last iterate(), and all losses so far, if recorded.
  const std::vector<TracedWay>& ways() const { return ways_; }
  const std::vector<TracedLoss>& losses() const { return losses_; }
  /// Returns true if do_plan() produces a tree after the planned operations, because the outcome was requested.
  bool has_outcome() const { return outcome_ != nullptr; }
  /// Performs the planned operations. Call it after take_skeleton(). sense() and take_skeleton() may be called once
  /// more afterwards.
  void do_plan();
  /// Returns the space that its buds search; null if they use light.
  BudSense::OwnRoom room() const { return senses_->room(); }

 private:
  /// Effects of operations that are not stored in the metamers.
  struct Upkeep {
    TreeLeads leads;
    std::vector<std::uint8_t> is_done;  // by operation
    CutWounds wounds;
    TreeBows bows;
    std::vector<float> ringed;                // share held back by a ring at the metamer's base; empty: no rings
    std::vector<std::uint16_t> ringed_until;  // iteration
  };

  /// A stub that will stay where a metamer is cut off. Positions are relative to the root.
  struct Stub {
    MetamerIndex from = 0;
    bool is_lateral = false;
    Vec3 tip{0};
    float lost = 0;  // tips of the removed shoot
  };

  /// The whole state that operations change.
  struct State {
    StandingTree::State tree;
    ResourceFlow flow;
    Upkeep upkeep;
    Crop crop;
    StandingWood wood;
    FallenShoots fallen;
    std::vector<TracedLoss> losses;
    std::vector<OperationRecord> records;
  };

  /// A bud that grows in this iteration.
  struct Sprout {
    MetamerIndex from = 0;
    bool is_lateral = false;
    int metamers = 1;
    float length = 0;  // of each metamer
    Vec3 way{0};       // direction to light or space: a unit vector, or 0
    int left = 0;      // metamers left for the second part of the iteration
    bool is_water_shoot = false;
  };

  /// The growth that the first part of an iteration leaves to a shoot.
  struct Owed {
    int metamers = 0;
    float length = 0;  // of each metamer
  };

  /// Common data of the metamers of a sprout.
  struct Growth {
    const Sprout& sprout;
    int iteration = 1;
    int rank = 0;
    std::uint32_t tie = 0;
  };

  bool is_pruned() const { return !species_->parameters.operations.empty(); }
  /// Sets the states of the buds of existing wood from its columns, if it has them.
  void close_buds(const Skeleton& wood, NodeIndex node, MetamerIndex metamer);
  void grow(const Sprout& sprout, int iteration);
  Vec3 wanted_heading(const Growth& growth, MetamerIndex from, Vec3 bud) const;
  std::optional<Vec3> free_heading(MetamerIndex from, Vec3 wanted, float length, RandomKey key, double jitter) const;
  Vec3 next_side(MetamerIndex from, bool is_lateral, std::uint32_t number, Vec3 heading, RandomKey key) const;
  bool is_open(Vec3 from, Vec3 to) const;
  bool stays_in_room(Vec3 from, Vec3 to) const;
  std::vector<std::uint8_t> near_wounds() const;
  void shed(int iteration);
  void cut_off(MetamerIndex first, const BudsLeft& after, int iteration, const LossReason& why);
  void record_loss(MetamerIndex first, int iteration, const LossReason& why);
  void record_ways(const std::vector<Sprout>& sprouts, Flush flush);
  Skeleton skeleton_of(Metamers metamers, std::vector<OperationRecord> records, const Progress& progress) const;
  bool clear_away();
  void leave_stubs();
  void forget(const std::vector<std::uint8_t>& gone);
  /// Returns the tree as an operation sees it in an iteration.
  TreeState state_for(std::size_t operation, int iteration) const;
  void tie_shoots(int iteration);
  void operate(int iteration, bool in_summer, const Progress& progress);
  void perform(int iteration, bool in_summer, const Progress& progress);
  State state() const { return {tree_.state(), flow_, upkeep_, crop_, wood_, fallen_, losses_, records_}; }
  void restore(State state);
  std::uint64_t name_of_bud(MetamerIndex metamer) const;
  void apply(const OperationWork& work, int iteration, std::size_t operation, bool in_summer);
  /// Records the shoots whose buds may react to the planned cuts.
  void note_answering(const OperationWork& work);
  void record(const OperationWork& work, int iteration, const TreeOperation& operation);
  /// Records for the plan that an operation would remove a metamer and everything that it bears.
  void note_planned(MetamerIndex first, int operation);
  void ring(const Ring& ring, int iteration);
  void bend(const Bow& bow, std::size_t operation);
  /// Returns the shares held back by rings in an iteration, by metamer; empty if there are no rings.
  const std::vector<float>& ringed(int iteration);

  const OrganizedSpecies* species_;
  Vec3 root_;
  RandomKey key_;
  int number_ = 0;
  CrownPointer room_;  // shoots stay inside; null: all of space
  StandingTree tree_;
  const Metamers& metamers_;  // the metamers of `tree_`
  std::unique_ptr<BudSense> senses_;
  BudLight light_;
  ResourceFlow flow_;
  std::vector<Sprout> sprouts_;  // of the iteration
  Crop crop_;                    // used if the tree bears
  int iteration_ = 0;            // of the last sense()
  StandingWood wood_;
  FallenShoots fallen_;  // used if fallen shoots are kept
  // For trees with operations only.
  TreeTies ties_;
  Upkeep upkeep_;
  // Shoots of the first part of the iteration, by the name of their last metamer.
  std::unordered_map<std::uint64_t, Owed> owed_;
  std::unordered_set<std::uint64_t> answering_;  // keys of the shoots cut by this summer's operations
  std::vector<Stub> stubs_;                      // of the current operations
  std::vector<OperationRecord> records_;
  std::vector<Miss> misses_;
  std::optional<WoodGirth> girth_;        // before the current operations; computed on demand
  std::vector<std::uint16_t> plan_cuts_;  // number of the operation that would cut the metamer; empty until planned
  std::unique_ptr<State> outcome_;        // after the planned operations, if recorded
  bool is_outcome_ = false;
  // Used if they are recorded.
  std::vector<TracedWay> ways_;
  std::vector<TracedLoss> losses_;
  bool has_grown_ = false;
};

}  // namespace meristem
