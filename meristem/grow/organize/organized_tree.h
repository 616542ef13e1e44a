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

namespace meristem {

/// What part of an iteration's growth comes at once.
enum class Flush {
  whole,
  first,  ///< the share of each shoot that comes before summer operations
  rest,   ///< what these shoots were still to grow, and what buds of shoots that were cut answer
};

/// One self-organizing tree as it grows. `species` and `space` outlive it.
class OrganizedTree {
 public:
  /// `number` is that of its root.
  OrganizedTree(const OrganizedSpecies& species, StandSpace& space, const OrganizeSeed& seed, RandomKey key,
                int number);
  OrganizedTree(const OrganizedTree&) = delete;
  OrganizedTree& operator=(const OrganizedTree&) = delete;

  /// Lets wood that stood already stand as metamers of iteration 0; once, before the first sense(). Throws InputError
  /// where it is too far from the world's origin.
  void stand(const Skeleton& wood);
  /// Counts the light of all buds as the stand's space is now, and divides the resource that it makes.
  void sense(int iteration, const Progress& progress);
  /// Finds the buds that will grow in this iteration; after sense(). Returns how many metamers they will make at most.
  std::uint64_t plan(Flush flush);
  /// Grows, sags, sheds, and people do to it what they will; after plan().
  void iterate(int iteration, Flush flush, const Progress& progress);
  /// Tells the stand's space of all that.
  void tell() { tree_.tell(); }

  const Metamers& metamers() const { return tree_.metamers(); }
  bool has_grown() const { return has_grown_; }
  const ResourceFlow& flow() const { return flow_; }  ///< of the last sense()
  /// An operation that has found no shoot of the name it asks for, or nothing there to take.
  struct Miss {
    std::size_t operation = 0;
    InputError error;
  };
  const std::vector<Miss>& misses() const { return misses_; }  ///< of the last iterate()
  /// In world space; to be called once.
  Skeleton take_skeleton(const Progress& progress);
  /// What take_skeleton() would give after sense(), but for what has fallen.
  Skeleton skeleton(const Progress& progress) const;
  /// The ways that its buds found in the last iterate(), and all that it has lost so far, where they are recorded.
  const std::vector<TracedWay>& ways() const { return ways_; }
  const std::vector<TracedLoss>& losses() const { return losses_; }
  /// Whether do_plan() makes a tree of what the last winter's operations would leave: it was asked to record that.
  bool has_outcome() const { return outcome_ != nullptr; }
  /// Does what was planned, after take_skeleton(); sense() and take_skeleton() may follow once more.
  void do_plan();
  /// The room that its buds look for; null where they look for light.
  BudSense::OwnRoom room() const { return senses_->room(); }

 private:
  /// What people have done to the tree, as far as its metamers do not tell it.
  struct Upkeep {
    Leads leads;
    std::vector<std::uint8_t> is_done;  // by operation
    CutWounds wounds;
    TreeBows bows;
    std::vector<float> ringed;                // share that a ring at its base keeps, by metamer; empty: no rings
    std::vector<std::uint16_t> ringed_until;  // iteration
  };

  /// All of the tree that operations change.
  struct State {
    StandingTree::State tree;
    ResourceFlow flow;
    Upkeep upkeep;
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
    float length = 0;  // of each
    Vec3 way{0};       // to light or room: a unit vector, or 0
    int left = 0;      // metamers that wait for the rest of the iteration
  };

  /// What the first flush of an iteration has left to a shoot.
  struct Owed {
    int metamers = 0;
    float length = 0;  // of each
  };

  /// What the metamers of a sprout have in common.
  struct Growth {
    const Sprout& sprout;
    int iteration = 1;
    int rank = 0;
    std::uint32_t tie = 0;
  };

  bool is_pruned() const { return !species_->parameters.operations.empty(); }
  /// Gives the buds of standing wood the states that its columns tell, if it has such.
  void close_buds(const Skeleton& wood, NodeIndex node, MetamerIndex metamer);
  void grow(const Sprout& sprout, int iteration);
  Vec3 wanted_heading(const Growth& growth, MetamerIndex from, Vec3 bud) const;
  std::optional<Vec3> free_heading(MetamerIndex from, Vec3 wanted, float length, RandomKey key, double jitter) const;
  Vec3 next_side(MetamerIndex from, bool is_lateral, std::uint32_t number, Vec3 heading, RandomKey key) const;
  bool is_open(Vec3 from, Vec3 to) const;
  void shed(int iteration);
  void cut_off(MetamerIndex first, const BudsLeft& after, int iteration, const LossReason& why);
  void record_loss(MetamerIndex first, int iteration, const LossReason& why);
  void record_ways(const std::vector<Sprout>& sprouts, Flush flush);
  Skeleton skeleton_of(Metamers metamers, std::vector<OperationRecord> records, const Progress& progress) const;
  bool clear_away();
  void forget(const std::vector<std::uint8_t>& gone);
  /// What an operation sees of the tree in an iteration.
  TreeState state_for(std::size_t operation, int iteration) const;
  void tie_shoots(int iteration);
  void operate(int iteration, bool in_summer, const Progress& progress);
  void perform(int iteration, bool in_summer, const Progress& progress);
  State state() const { return {tree_.state(), flow_, upkeep_, wood_, fallen_, losses_, records_}; }
  void restore(State state);
  std::uint64_t name_of_bud(MetamerIndex metamer) const;
  void apply(const Work& work, int iteration, std::size_t operation, bool in_summer);
  /// Notes the shoots whose buds may answer to what is about to be cut.
  void note_answering(const Work& work);
  void record(const Work& work, int iteration, const Operation& operation);
  /// Notes for the plan that an operation would take a metamer and all that it bears.
  void note_planned(MetamerIndex first, int operation);
  void ring(const Ring& ring, int iteration);
  void bend(const Bow& bow, std::size_t operation);
  /// What rings keep in an iteration, by metamer; empty where there is none.
  const std::vector<float>& ringed(int iteration);

  const OrganizedSpecies* species_;
  Vec3 root_;
  RandomKey key_;
  int number_ = 0;
  CrownPointer room_;  // that shoots do not leave; null: all space
  StandingTree tree_;
  const Metamers& metamers_;  // of the tree
  std::unique_ptr<BudSense> senses_;
  BudLight light_;
  ResourceFlow flow_;
  std::vector<Sprout> sprouts_;  // of the iteration
  StandingWood wood_;
  FallenShoots fallen_;  // where they are kept
  // For trees with operations alone.
  TreeTies ties_;
  Upkeep upkeep_;
  std::unordered_map<std::uint64_t, Owed> owed_;  // of the first flush's shoots, by the name of their last metamer
  std::unordered_set<std::uint64_t> answering_;   // shoots that this summer's operations have cut, by their keys
  std::vector<OperationRecord> records_;
  std::vector<Miss> misses_;
  std::optional<WoodGirth> girth_;        // before this winter's or summer's operations; made when it is asked for
  std::vector<std::uint16_t> plan_cuts_;  // number of the operation that would cut a metamer; empty: not planned yet
  std::unique_ptr<State> outcome_;        // of the plan, where it is recorded
  bool is_outcome_ = false;
  // Where they are recorded.
  std::vector<TracedWay> ways_;
  std::vector<TracedLoss> losses_;
  bool has_grown_ = false;
};

}  // namespace meristem
