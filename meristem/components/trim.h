// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "meristem/components/parts/crown_table.h"
#include "meristem/graph/component.h"

namespace meristem {

/// A body that limits the stems of all descendants.
struct Trim : ComponentBase {
  std::optional<CrownParameters> body;  ///< in the component's frame
  bool off = false;                     ///< true: first ends the trims above
};

ComponentType trim_component();

}  // namespace meristem
