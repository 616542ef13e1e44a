// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/progress.h"
#include "meristem/dataset/dataset_plan.h"

namespace meristem {

/// Returns the data card of a data set whose manifest is complete, in Markdown. The card describes how the set was
/// made, its licence, its counts and failures, its files by ending, and the distribution of each value and measure. The
/// tables are read twice, row by row, so that memory does not depend on the number of plants.
std::string data_card(const DatasetPlan& plan, const std::string& folder, Progress& progress);

}  // namespace meristem
