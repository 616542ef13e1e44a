// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/trimmed_stem.h"

namespace meristem {

/// Returns the thickness of a trimmed stem at the position `to` of its rest, as a share of the thickness at the
/// position `from` of the whole stem. Returns 1 for a cut stem.
float thickness_left(const TrimmedStem& stem, StemPosition from, StemPosition to);

}  // namespace meristem
