// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "meristem/grow/prune/tree_state.h"
#include "meristem/grow/prune/work.h"
#include "meristem/plant/operation_record.h"

namespace meristem {

/// Records the effects of an operation before it is applied. Lengths and positions are in metres from the root.
class WorkRecorder {
 public:
  /// Returns the radius at a metamer's end in metres.
  using RadiusOf = std::function<double(MetamerIndex)>;

  /// `number` is the number of the tree's root. `radius_of` is called for few metamers.
  WorkRecorder(const TreeState& tree, const TreeOperation& operation, std::uint32_t number, RadiusOf radius_of)
      : tree_(tree), operation_(operation), number_(number), radius_of_(std::move(radius_of)) {}

  struct Noted {
    MetamerIndex at = 0;  ///< the metamer at whose end it is done
    OperationRecord record;
    double section = 0;  ///< cross-section of the cut wood, square metres; 0 for other operations
  };
  /// Returns a record for each effect, in the order of OperationWork. Cost: proportional to the effects, not to the
  /// tree.
  std::vector<Noted> note(const OperationWork& work) const;

 private:
  Noted at_end(MetamerIndex metamer, const char* act) const;
  Noted at_base(MetamerIndex first, const char* act) const;
  Noted cut(MetamerIndex first, std::vector<MetamerIndex>& beyond) const;

  TreeState tree_;
  const TreeOperation& operation_;
  std::uint32_t number_;
  RadiusOf radius_of_;
};

}  // namespace meristem
