// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "meristem/components/crown_table.h"
#include "meristem/graph/component.h"
#include "meristem/grow/colonize/colonize.h"

namespace meristem {

/// A tree that grows into the attraction points of its crown.
struct Colonize : ComponentBase {
  std::optional<CrownForm> crown;
  PointsForm points;
  ColonizeParameters growth;
  Surface surface;
};

ComponentType colonize_component();

}  // namespace meristem
