// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "meristem/components/parts/crown_table.h"
#include "meristem/components/parts/world_field.h"
#include "meristem/graph/component.h"

namespace meristem {

/// A body that stems keep out of.
struct AvoidParameters {
  CrownParameters body;
  double reach = 0.3;  ///< metres from the body at which stems begin to turn; larger: smoother
};

/// Fields of light and gravity for all descendants, in the component's frame.
struct World : ComponentBase {
  std::optional<WorldField> light;
  std::optional<WorldField> gravity;
  std::optional<AvoidParameters> avoid;
  bool off = false;  ///< true: first ends the fields above
};

ComponentType world_component();

}  // namespace meristem
