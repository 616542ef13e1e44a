// SPDX-License-Identifier: Apache-2.0
// The clocks that a plant's components begin, for a page that shows time.
#pragma once

#include "grower.h"
#include "meristem/base/progress.h"
#include "meristem/graph/table/value.h"

namespace meristem::studio {

/// Returns a list of {"component", "count", "blocks": [[start, speed], ...]} as protocol.md defines it: the clocks that
/// begin up to a time of the document, seconds. Throws what begun_clocks and document_at throw.
Value clocks_value(const GrownPlant& grown, double up_to, Progress& progress, GrowthCache& cache);

}  // namespace meristem::studio
