// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "meristem/grow/metamer/metamers.h"
#include "meristem/plant/operation_record.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// The cuts at the ends of a tree's metamers, by metamer.
class CutWounds {
 public:
  /// Adds a cut at a metamer's end. `section` is the cross-section of the cut wood in square metres.
  void add(std::size_t metamers, MetamerIndex metamer, const OperationRecord& record, double section);
  /// Updates the indices after Metamers::remove().
  void remove(const std::vector<std::uint8_t>& gone);
  /// Makes wood swell around its cuts, as callus grows over them. The cross-section of the skeleton, whose radii must
  /// be set, increases by the share `callus` of the sections of all cuts at a node. Toward the root, the increase
  /// halves every kCallusReach radii. Stems that are often cut back to one place therefore grow heads.
  void swell(double callus, Skeleton& skeleton) const;
  static constexpr double kCallusReach = 2;
  /// Writes the columns of the tree's skeleton after `iteration`. `closure` is OrganizeParameters::closure.
  void write(Skeleton& skeleton, std::optional<double> closure, int iteration) const;
  /// Calls `visit(metamer, iteration, metamers)` for each metamer with a cut: the iteration of its last cut, and the
  /// number of metamers that all of its cuts have removed.
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::size_t k = 0; k < wounds_.size(); ++k) {
      if (wounds_[k].at > 0) visit(static_cast<MetamerIndex>(k), wounds_[k].at, wounds_[k].metamers);
    }
  }

 private:
  struct Wound {
    float at = 0;  // iteration; 0: never
    float metamers = 0, length = 0, wood = 0, light = 0;
    double section = 0;  // square metres
  };
  std::vector<Wound> wounds_;  // for the first metamers; later metamers have no wounds
};

}  // namespace meristem
