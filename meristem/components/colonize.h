// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/graph/component.h"
#include "meristem/grow/colonize/colonize.h"

namespace meristem {

/// A tree that grows into the attraction points of its crown.
struct Colonize : ComponentBase {
  struct Crown {
    std::vector<Vec2> profile;  ///< (radius, height), metres over the root
  };
  struct Points {
    std::uint64_t count = 2400;
  };
  Crown crown;
  Points points;
  ColonizeParameters growth;
  Surface surface;
};

ComponentType colonize_component();

}  // namespace meristem
