// SPDX-License-Identifier: Apache-2.0
// What the page is told of an instance that somebody has pointed at, as protocol.md writes it.
#pragma once

#include <string>

#include "grower.h"
#include "meristem/base/progress.h"
#include "meristem/graph/table/site.h"
#include "meristem/graph/table/value.h"
#include "request.h"

namespace meristem::studio {

/// 16 hexadecimal digits that tell an instance from all others of its component, as long as its place in the graph, the
/// names on the way there and the seed stay what they are.
std::string instance_key(const Site& site);

/// Null where it is not known which instance made what is seen, as of plants of documents of their own. Throws what
/// find_instance throws.
Value instance_value(const GrownWish& grown, const InstanceRequest& request, Progress& progress, GrowthCache& cache);

}  // namespace meristem::studio
