// SPDX-License-Identifier: Apache-2.0
// The clocks that a plant's components begin, for a page that draws time.
#pragma once

#include "grower.h"
#include "meristem/base/progress.h"
#include "meristem/graph/table/value.h"

namespace meristem::studio {

/// A list of {"component", "count", "blocks": [[start, speed], ...]} as protocol.md says: the clocks that have begun up
/// to a time of the document, in seconds. Throws what begun_clocks and document_at throw.
Value clocks_value(const GrownWish& grown, double up_to, Progress& progress, GrowthCache& cache);

}  // namespace meristem::studio
