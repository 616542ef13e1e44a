// SPDX-License-Identifier: Apache-2.0
// What the page is told of an instance that somebody has pointed at, as protocol.md writes it.
#pragma once

#include "grower.h"
#include "meristem/base/progress.h"
#include "meristem/graph/table/value.h"
#include "request.h"

namespace meristem::studio {

/// Null where it is not known which instance made what is seen, as of plants of documents of their own. Throws what
/// find_instance throws.
Value instance_value(const GrownWish& grown, const InstanceRequest& request, Progress& progress, GrowthCache& cache);

}  // namespace meristem::studio
