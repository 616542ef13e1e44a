// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "meristem/components/crown_table.h"
#include "meristem/graph/component.h"

namespace meristem {

/// The attraction points of a crown as dots, to see what a crown or a distribution is before a tree grows into it.
struct Cloud : ComponentBase {
  std::optional<CrownForm> crown;
  PointsForm points;
  double size = 0.03;  ///< metres across a dot
};

ComponentType cloud_component();

}  // namespace meristem
