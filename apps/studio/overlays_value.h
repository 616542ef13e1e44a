// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "grower.h"
#include "meristem/base/progress.h"
#include "meristem/export/packet/packet_arrays.h"
#include "meristem/graph/table/value.h"
#include "request.h"

namespace meristem::studio {

/// Returns the overlays of the grown plant in the form of protocol.md. Positions and colours go to the arrays. Throws
/// InputError for unknown parts, and Cancelled.
Value overlays_value(const LastGrown& last, const OverlaysRequest& request, const Progress& progress,
                     PacketArrays& arrays);

/// Returns all parts that a page can show.
Value overlay_parts_value();

}  // namespace meristem::studio
