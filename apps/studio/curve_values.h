// SPDX-License-Identifier: Apache-2.0
// The curves that a grass leaf is drawn from, as protocol.md writes them.
#pragma once

#include "grower.h"
#include "meristem/graph/table/value.h"
#include "request.h"

namespace meristem::studio {

/// Null where the component is no grass leaf. Throws InputError.
Value curves_value(const GrownWish& grown, const CurvesRequest& request);

}  // namespace meristem::studio
