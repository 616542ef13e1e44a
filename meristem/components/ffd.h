// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/components/parts/deforming.h"

namespace meristem {

/// A free-form deformation by functions of the position.
struct Ffd : ComponentBase {
  SpaceFunctions functions;
  Deforming deforming;
};

ComponentType ffd_component();

}  // namespace meristem
