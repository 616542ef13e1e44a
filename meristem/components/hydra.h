// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/components/parts/around.h"

namespace meristem {

/// Sites for children in a star.
struct Hydra : ComponentBase {
  Around around;
  PerChild radius = 0.0;  ///< metres from the centre to a child, along the child's heading
};

ComponentType hydra_component();

}  // namespace meristem
