// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "meristem/components/parts/crown_table.h"
#include "meristem/graph/component.h"

namespace meristem {

/// A body in which the stems of everything below are kept.
struct Trim : ComponentBase {
  std::optional<CrownParameters> body;  ///< in the component's frame
  bool off = false;                     ///< first ends the trims above
};

ComponentType trim_component();

}  // namespace meristem
