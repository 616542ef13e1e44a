// SPDX-License-Identifier: Apache-2.0
// What of a plan has no table, and is the same for all documents: seeds, and where pictures are taken from.
#pragma once

#include "meristem/dataset/dataset_plan.h"
#include "meristem/graph/table/reader.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// A distribution has at least this share of its values within its bounds, so that drawing ends.
inline constexpr double kLeastShareWithin = 0.01;

/// Hash of what a plan says, names and words aside.
std::string hash_of_plan(const Value& tree);

/// Reads the seeds of a plan into it, with faults at their places.
void read_plan_seeds(const Value& given, const DocumentPath& path, ParameterReader& reader, DatasetPlan& plan);

/// Reads the views of `pictures`, whose table has been read, with faults at their places.
void read_plan_views(const Value& given, const DocumentPath& path, ParameterReader& reader, PicturePlan& pictures);

}  // namespace meristem
