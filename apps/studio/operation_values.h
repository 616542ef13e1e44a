// SPDX-License-Identifier: Apache-2.0
// What operations have done to the trees of a component, as protocol.md writes it.
#pragma once

#include "grower.h"
#include "meristem/base/progress.h"
#include "meristem/graph/table/value.h"
#include "request.h"

namespace meristem::studio {

/// {"iteration", "acts", "places", "left"}: how often each operation acted after each iteration, and where the one that
/// is asked for did. Linear in the nodes and records of the plant. Throws Cancelled.
Value operations_value(const GrownWish& grown, const OperationsRequest& request, const Progress& progress);

}  // namespace meristem::studio
