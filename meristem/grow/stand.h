// SPDX-License-Identifier: Apache-2.0
// Plants that grow together. In each round, all plants take one step in parallel. Then each plant reports its changes,
// and the shared resources are updated before the next round. All plants of a round therefore read equal state, and the
// order of threads does not matter.
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

/// One plant of a stand. Growth models implement it; the stand calls it.
class Grower {
 public:
  Frame place;  ///< frame of the growing instance, copied to its trace

  virtual ~Grower() = default;
  /// Returns the largest number of steps that it will take; 0 for a member that does not grow.
  virtual int step_limit() const = 0;
  /// Grows one step in parallel with other members. Reads the commons and changes only this object. Returns true if it
  /// may grow further. After false, step() is not called again.
  virtual bool step(Progress& progress) = 0;
  /// Reports the changes of the step to the commons. Called for each member in order, after all members have taken the
  /// step.
  virtual void tell() {}
  /// Executes the planned operations if the outcome is requested. Called once after all growth, so that it affects no
  /// growth. Returns true if anything was done; then tell() and see_outcome() are called.
  virtual bool do_plan(Progress&) { return false; }
  /// Computes the light and the space that are available after the planned operations.
  virtual void see_outcome(Progress&) {}
  /// Returns the recorded trace, or null if none was requested. Called once, after the last step and before
  /// take_skeleton().
  virtual std::unique_ptr<GrowthTrace> take_trace() { return nullptr; }
  /// Returns the finished skeleton: post-processed, with radii, axes and orders. Called once after the last step, in
  /// parallel with other members.
  virtual Skeleton take_skeleton(Progress& progress) = 0;
};

/// A resource that the plants of a stand share and compete for, such as a cloud of attraction points.
class StandCommons {
 public:
  virtual ~StandCommons() = default;
  /// Applies the changes that plants reported in the previous round. Called before each round.
  virtual void begin_round(Progress& progress) = 0;
  /// Applies the changes of the last round if they are recorded. Called once after all growth.
  virtual void end_record(Progress&) {}
};

/// Plants that grow together, and what they share. Add all plants, then call grow() and take_skeletons().
class Stand {
 public:
  /// Returns the shared object of type T, created on first use. References stay valid for the lifetime of the stand.
  template <class T>
  T& commons() {
    for (const Shared& shared : commons_) {
      if (shared.type == typeid(T)) return static_cast<T&>(*shared.commons);
    }
    commons_.push_back({typeid(T), std::make_unique<T>()});
    return static_cast<T&>(*commons_.back().commons);
  }

  /// Adds a plant. Its index among the skeletons is the number of earlier members.
  void add(std::unique_ptr<Grower> member) { members_.push_back(std::move(member)); }

  /// Grows all members together, step by step, until none can grow further or all have reached their step limits.
  /// Throws what members throw: InputError if one exceeds its limits, Cancelled if stopped.
  void grow(Progress& progress);

  /// Returns the recorded traces in the order of the members; null for members without a trace. Call it once, between
  /// grow() and take_skeletons().
  std::vector<std::unique_ptr<GrowthTrace>> take_traces(Progress& progress);

  /// Returns the skeletons in the order of the members. Call it once, after grow().
  std::vector<Skeleton> take_skeletons(Progress& progress);

 private:
  void see_outcomes(Progress& progress);

  struct Shared {
    std::type_index type;
    std::unique_ptr<StandCommons> commons;
  };
  std::vector<Shared> commons_;
  std::vector<std::unique_ptr<Grower>> members_;
};

}  // namespace meristem
