// SPDX-License-Identifier: Apache-2.0
// The effects of operations on the trees of a component, in the form of protocol.md.
#pragma once

#include "grower.h"
#include "meristem/base/progress.h"
#include "meristem/graph/table/value.h"
#include "request.h"

namespace meristem::studio {

/// Returns {"iteration", "acts", "places", "left"}: how often each operation acted after each iteration, and where the
/// requested operation acted. Takes time in proportion to the nodes and records of the plant. Throws Cancelled.
Value operations_value(const GrownPlant& grown, const OperationsRequest& request, const Progress& progress);

}  // namespace meristem::studio
