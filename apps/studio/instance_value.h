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

/// The same of the shoot that is asked for by name, or of the one beside it. Null where there is none.
Value shoot_instance_value(const GrownWish& grown, const ShootRequest& request, Progress& progress, GrowthCache& cache);

/// The frame of the site on which the first instance of a component stands, before the component's own `frame`: 12
/// numbers, three rows of [axes, origin]. Null where it has none. Throws what find_instance throws.
Value stand_value(const GrownWish& grown, const std::string& component, Progress& progress, GrowthCache& cache);

/// What expressions come to, by their paths: those that differ from instance to instance at the first instance of the
/// component, all others by the variables of the document. Those that are not known are not told. Throws what
/// find_instance throws.
Value worked_out_value(const GrownWish& grown, const WorkedOutRequest& request, Progress& progress, GrowthCache& cache);

}  // namespace meristem::studio
