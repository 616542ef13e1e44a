// SPDX-License-Identifier: Apache-2.0
// Plants that grow together: round after round all of them take a step side by side, each then tells what it has done,
// and what they compete for is brought up to date before the next round. So all see the same state, none is served
// first, and threads decide nothing.
#pragma once

#include <cstddef>
#include <memory>
#include <typeindex>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/progress.h"
#include "meristem/grow/growth_trace.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// One plant growing among others. A growth model implements it; a stand drives it.
class Grower {
 public:
  Frame place;  ///< frame of the instance that grows, which traces tell

  virtual ~Grower() = default;
  /// The most steps it will take; 0 for a member that does not grow.
  virtual int step_limit() const = 0;
  /// Grows one step, while others do: it reads the commons and changes nothing but itself. Returns whether it may grow
  /// further; once it does not, step() is not called again.
  virtual bool step(Progress& progress) = 0;
  /// Tells the commons what the step has done; called after each one, once all have taken theirs, in the members'
  /// order.
  virtual void tell() {}
  /// Does what it has only planned, where it was asked to record the outcome; called once, when all have grown, so that
  /// no growth feels it. Returns whether it did anything. If so, tell() and see_outcome() follow.
  virtual bool do_plan(Progress&) { return false; }
  /// Finds what light and room it has after that.
  virtual void see_outcome(Progress&) {}
  /// What it has recorded where that was asked for, else null; called once, after the last step and before
  /// take_skeleton().
  virtual std::unique_ptr<GrowthTrace> take_trace() { return nullptr; }
  /// The finished skeleton, post-processed, with radii, axes and orders; called once, after the last step, while others
  /// finish theirs.
  virtual Skeleton take_skeleton(Progress& progress) = 0;
};

/// What the plants of a stand share and compete for, such as a cloud of attraction points.
class Commons {
 public:
  virtual ~Commons() = default;
  /// Takes account of what the plants did in the round before; called before each round.
  virtual void begin_round(Progress& progress) = 0;
  /// Takes account of what they did in the last round, where somebody records that; called once, when all have grown.
  virtual void end_record(Progress&) {}
};

class Stand {
 public:
  /// The stand's one T, made at its first use. Members keep references to it.
  template <class T>
  T& commons() {
    for (const Shared& shared : commons_) {
      if (shared.type == typeid(T)) return static_cast<T&>(*shared.commons);
    }
    commons_.push_back({typeid(T), std::make_unique<T>()});
    return static_cast<T&>(*commons_.back().commons);
  }

  void add(std::unique_ptr<Grower> member) { members_.push_back(std::move(member)); }

  /// Grows all members together, step by step, until none can grow further or all have reached their step limits.
  /// Passes on what members throw: InputError when one exceeds its limits, Cancelled when asked to stop.
  void grow(Progress& progress);

  /// What the members have recorded, in their order; null for those that record nothing. To be called once, between
  /// grow() and take_skeletons().
  std::vector<std::unique_ptr<GrowthTrace>> take_traces(Progress& progress);

  /// The skeletons in the members' order; to be called once, after grow().
  std::vector<Skeleton> take_skeletons(Progress& progress);

 private:
  void see_outcomes(Progress& progress);

  struct Shared {
    std::type_index type;
    std::unique_ptr<Commons> commons;
  };
  std::vector<Shared> commons_;
  std::vector<std::unique_ptr<Grower>> members_;
};

}  // namespace meristem
