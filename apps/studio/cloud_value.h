// SPDX-License-Identifier: Apache-2.0
// The attraction points of a crown, which the page draws as its outline, in the form of protocol.md.
#pragma once

#include <string>

#include "grower.h"
#include "meristem/base/progress.h"
#include "meristem/export/packet/packet_arrays.h"
#include "meristem/graph/table/value.h"

namespace meristem::studio {

/// Returns the attraction points of a component; positions go to the arrays. Returns null if the component fills no
/// crown with points. Throws what crown_cloud throws.
Value cloud_value(const LastGrown& last, const std::string& component, Progress& progress, PacketArrays& arrays);

}  // namespace meristem::studio
