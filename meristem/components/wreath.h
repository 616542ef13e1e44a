// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/components/parts/around.h"

namespace meristem {

/// Sites for children on a ring.
struct Wreath : ComponentBase {
  Around around;
  double diameter = 0.1;  ///< metres
};

ComponentType wreath_component();

}  // namespace meristem
