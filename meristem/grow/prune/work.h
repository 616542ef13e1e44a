// SPDX-License-Identifier: Apache-2.0
// What operations do to a tree, worked out from its metamers alone; the tree applies it.
#pragma once

#include <optional>
#include <vector>

#include "meristem/grow/prune/operation.h"
#include "meristem/grow/prune/tree_state.h"

namespace meristem {

/// A ring in the bark at the base of a metamer.
struct Ring {
  MetamerIndex metamer = 0;
  double share = 1;  ///< of what leaves above make that does not pass
  int iterations = 1;
};

/// A stretch of a shoot that is bent.
struct Bow {
  MetamerIndex first = 0;
  MetamerIndex last = 0;         ///< bent so long until this one rises as it should, or has been drawn near
  MetamerIndex tip = 0;          ///< of the shoot
  double inclination = 0;        ///< radians
  int iterations = 1;            ///< that are left for it
  std::optional<Vec3> toward{};  ///< metres from the root; drawn there instead of bent to an inclination
  double gap = 0;                ///< metres at which it is near enough
};

/// What is to be done, in this order.
struct Work {
  std::vector<AxisIndex> marked;      ///< axes that get a mark
  std::uint32_t mark = 0;             ///< which
  std::vector<AxisIndex> headless;    ///< axes that nothing shall succeed
  std::vector<MetamerIndex> pinched;  ///< metamers whose open terminal buds are damaged
  std::vector<MetamerIndex> lifted;   ///< metamers whose open lateral buds are damaged
  std::vector<MetamerIndex> gone;     ///< metamers that go with all that they bear
  std::vector<Ring> rings;
  std::vector<Bow> bows;
  bool renews = false;  ///< lateral buds at which shoots went may grow again, as those at the base of a spur do
};

/// What `operation` does to a tree. Throws InputError at its document path where it names a shoot that is not there, or
/// has nothing to take from a shoot that it names.
Work find_work(const TreeState& tree, const Operation& operation);

// The kinds of operations; `shoots` are those that were chosen.

Work cut(const TreeState& tree, const Operation& operation, const Cut& what, const std::vector<Shoot>& shoots);
Work spur(const TreeState& tree, const Spur& what, const std::vector<Shoot>& shoots);
Work limit(const Limit& what, const std::vector<Shoot>& shoots);
Work girdle(const Operation& operation, const Girdle& what, const std::vector<Shoot>& shoots);
Work bend(const TreeState& tree, const Operation& operation, const Bend& what, const std::vector<Shoot>& shoots);
Work tie(const TreeState& tree, const Operation& operation, const Tie& what, const std::vector<Shoot>& shoots);
Work layer(const TreeState& tree, const Layers& what);

}  // namespace meristem
