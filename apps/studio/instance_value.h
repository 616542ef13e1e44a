// SPDX-License-Identifier: Apache-2.0
// Values about an instance that the user has pointed at, in the form of protocol.md.
#pragma once

#include <string>

#include "grower.h"
#include "meristem/base/progress.h"
#include "meristem/graph/table/site.h"
#include "meristem/graph/table/value.h"
#include "request.h"

namespace meristem::studio {

/// Returns 16 hexadecimal digits that identify an instance among all instances of its component. The key stays valid
/// while the instance's place in the graph, the names on the path to it and the seed do not change.
std::string instance_key(const Site& site);

/// Returns the instance that made the visible part. Returns null if the instance is unknown, as for plants of other
/// documents. Throws what find_instance throws.
Value instance_value(const GrownPlant& grown, const InstanceRequest& request, Progress& progress, GrowthCache& cache);

/// Returns the instance of the shoot that the request names, or of a neighbouring shoot. Returns null if that shoot
/// does not exist.
Value shoot_instance_value(const GrownPlant& grown, const ShootRequest& request, Progress& progress,
                           GrowthCache& cache);

/// Returns the frame of the site on which the first instance of a component stands, before the component's own `frame`.
/// The frame has 12 numbers, three rows of [axes, origin]. Returns null if there is no instance. Throws what
/// find_instance throws.
Value stand_value(const GrownPlant& grown, const std::string& component, Progress& progress, GrowthCache& cache);

/// Returns the values of expressions, by their paths. An expression that differs from instance to instance is evaluated
/// at the first instance of the component, any other one with the variables of the document. Expressions with an
/// unknown value are omitted. Throws what find_instance throws.
Value worked_out_value(const GrownPlant& grown, const WorkedOutRequest& request, Progress& progress,
                       GrowthCache& cache);

}  // namespace meristem::studio
