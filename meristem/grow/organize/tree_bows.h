// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/grow/organize/sag.h"
#include "meristem/grow/prune/work.h"

namespace meristem {

/// The stretches of a tree's shoots that are being bent.
class TreeBows {
 public:
  bool empty() const { return bows_.empty(); }
  /// Begins to bend a stretch; of another one that begins there nothing more is done.
  void add(const Bow& bow);
  /// How the metamers stand after one more iteration of bending: each bow has turned by its share of what is left, and
  /// what it bears has moved and turned along. Nothing comes below the ground, which is level at the root; obstacles
  /// are not asked. Bows that are done are forgotten.
  Pose bend(const Metamers& metamers);
  /// Follows Metamers::remove(). A stretch that has lost a part is bent no further.
  void remove(const std::vector<std::uint8_t>& gone);

 private:
  std::vector<Bow> bows_;
};

}  // namespace meristem
