// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/grow/organize/sag.h"
#include "meristem/grow/prune/work.h"

namespace meristem {

/// The sections of a tree's shoots that are being bent.
class TreeBows {
 public:
  bool empty() const { return bows_.empty(); }
  /// Begins to bend a section. Ends the bending of another section with the same first metamer.
  void add(const Bow& bow);
  /// Returns the metamers after one more iteration of bending. Each bow turns by its share of the remaining angle,
  /// together with everything that it bears. No metamer moves below the ground, which is horizontal at the root.
  /// Obstacles are ignored. Removes completed bows.
  TreePose bend(const Metamers& metamers);
  /// Updates the indices after Metamers::remove(). A section that has lost a part is bent no further.
  void remove(const std::vector<std::uint8_t>& gone);

 private:
  std::vector<Bow> bows_;
};

}  // namespace meristem
