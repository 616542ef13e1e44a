// SPDX-License-Identifier: Apache-2.0
// A clock for what hangs on it. A blossom whose opening is described once opens at each place at its own time.
//
// Based on: B. Lintermann and O. Deussen's rule-based objects, cascaded key frames.
#pragma once

#include "meristem/graph/component.h"

namespace meristem {

struct Sequence : ComponentBase {
  double delay = 0;   ///< seconds from when the instance appears to when its clock starts
  double speed = 1;   ///< seconds of its clock per second of the clock above
  bool waits = true;  ///< what hangs on it is there before the clock starts
};

ComponentType sequence_component();

}  // namespace meristem
