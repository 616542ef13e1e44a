// SPDX-License-Identifier: Apache-2.0
// The curves from which a grass leaf is drawn, in the form of protocol.md.
#pragma once

#include "grower.h"
#include "meristem/graph/table/value.h"
#include "request.h"

namespace meristem::studio {

/// Returns the curves. Returns null if the component is no grass leaf. Throws InputError.
Value curves_value(const GrownPlant& grown, const CurvesRequest& request);

}  // namespace meristem::studio
