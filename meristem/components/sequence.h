// SPDX-License-Identifier: Apache-2.0
// A clock for the descendants of a component. A blossom whose opening is described once opens on each site at its own
// time.
//
// Based on: B. Lintermann and O. Deussen's rule-based objects, cascaded key frames.
#pragma once

#include "meristem/graph/component.h"

namespace meristem {

struct Sequence : ComponentBase {
  double delay = 0;   ///< seconds from the appearance of the instance to the start of its clock
  double speed = 1;   ///< seconds of its clock per second of the outer clock
  bool waits = true;  ///< true: descendants exist before the clock starts
};

ComponentType sequence_component();

}  // namespace meristem
