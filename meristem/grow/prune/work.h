// SPDX-License-Identifier: Apache-2.0
// The effects of operations on a tree, computed from its metamers alone. The tree applies them.
#pragma once

#include <optional>
#include <vector>

#include "meristem/grow/prune/operation.h"
#include "meristem/grow/prune/tree_state.h"

namespace meristem {

/// A ring in the bark at the base of a metamer.
struct Ring {
  MetamerIndex metamer = 0;
  double share = 1;  ///< share of the resource made above that does not pass
  int iterations = 1;
};

/// A section of a shoot that is bent.
struct Bow {
  MetamerIndex first = 0;
  MetamerIndex last = 0;   ///< bent until this metamer has the inclination or is near `toward`
  MetamerIndex tip = 0;    ///< last metamer of the shoot
  double inclination = 0;  ///< radians
  int iterations = 1;      ///< number of remaining iterations
  /// Metres from the root; if set, the section is drawn there instead of bent to an inclination.
  std::optional<Vec3> toward{};
  double gap = 0;  ///< distance that counts as near enough, metres
};

/// The effects, in the order of application.
struct OperationWork {
  std::vector<AxisIndex> marked;      ///< axes that get a mark
  std::uint32_t mark = 0;             ///< number of the mark
  std::vector<AxisIndex> headless;    ///< axes that must not be succeeded
  std::vector<MetamerIndex> pinched;  ///< metamers whose open terminal buds are damaged
  std::vector<MetamerIndex> lifted;   ///< metamers whose open lateral buds are damaged
  std::vector<MetamerIndex> gone;     ///< metamers that are removed with everything that they bear
  std::vector<Ring> rings;
  std::vector<Bow> bows;
  double stub = 0;      ///< length of the stubs that stay of removed metamers, as a share of the metamer
  bool renews = false;  ///< true: lateral buds of removed shoots may grow again, like those at the base of a spur
};

/// Returns the effects of `operation` on a tree. Throws InputError at its document path if it names a shoot that does
/// not exist, or if a named shoot has nothing to remove.
OperationWork find_work(const TreeState& tree, const TreeOperation& operation);

// The kinds of operations. `shoots` are the chosen shoots.

OperationWork cut(const TreeState& tree, const TreeOperation& operation, const CutOperation& what,
                  const std::vector<Shoot>& shoots);
OperationWork spur(const TreeState& tree, const SpurOperation& what, const std::vector<Shoot>& shoots);
OperationWork limit(const TreeState& tree, const LimitOperation& what, const std::vector<Shoot>& shoots);
OperationWork girdle(const TreeOperation& operation, const GirdleOperation& what, const std::vector<Shoot>& shoots);
OperationWork bend(const TreeState& tree, const TreeOperation& operation, const BendOperation& what,
                   const std::vector<Shoot>& shoots);
OperationWork tie(const TreeState& tree, const TreeOperation& operation, const TieOperation& what,
                  const std::vector<Shoot>& shoots);
OperationWork layer(const TreeState& tree, const LayersOperation& what);

}  // namespace meristem
