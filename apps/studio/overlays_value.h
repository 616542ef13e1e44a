// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "grower.h"
#include "meristem/base/progress.h"
#include "meristem/graph/table/value.h"
#include "meristem/output/packet/packet_arrays.h"
#include "request.h"

namespace meristem::studio {

/// What overlays show of what has grown, as protocol.md has it; positions and colours go to the arrays. Throws
/// InputError for parts that are not known, and Cancelled.
Value overlays_value(const LastGrown& last, const OverlaysRequest& request, const Progress& progress,
                     PacketArrays& arrays);

/// All parts that a page can show.
Value overlay_parts_value();

}  // namespace meristem::studio
