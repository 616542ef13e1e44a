// SPDX-License-Identifier: Apache-2.0
// The attraction points over which the outline of a crown is drawn, as protocol.md writes them.
#pragma once

#include <string>

#include "grower.h"
#include "meristem/base/progress.h"
#include "meristem/graph/table/value.h"
#include "meristem/output/packet/packet_arrays.h"

namespace meristem::studio {

/// Null where the component fills no crown with points; positions go to the arrays. Throws what crown_cloud throws.
Value cloud_value(const LastGrown& last, const std::string& component, Progress& progress, PacketArrays& arrays);

}  // namespace meristem::studio
