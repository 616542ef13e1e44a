// SPDX-License-Identifier: Apache-2.0
// Parts of a plan that have no table and are equal for all documents: seeds, and the views of pictures.
#pragma once

#include "meristem/dataset/dataset_plan.h"
#include "meristem/graph/table/reader.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Minimum share of a distribution's values within its bounds. A smaller share would need too many draws.
inline constexpr double kMinShareWithin = 0.01;

/// Returns a hash of a plan, without names and descriptions.
std::string hash_of_plan(const Value& tree);

/// Reads the seeds of a plan and reports faults at their positions.
void read_plan_seeds(const Value& given, const DocumentPath& path, ParameterReader& reader, DatasetPlan& plan);

/// Reads the views of `pictures`, whose table has been read, and reports faults at their positions.
void read_plan_views(const Value& given, const DocumentPath& path, ParameterReader& reader, PicturePlan& pictures);

}  // namespace meristem
