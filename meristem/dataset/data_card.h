// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/progress.h"
#include "meristem/dataset/dataset_plan.h"

namespace meristem {

/// The data card of a data set whose manifest is whole, in Markdown: what it is, how it was made, licence, counts, what
/// failed, files by their endings, and the distribution of each value and measure. The tables are read twice, row by
/// row, so that memory does not rise with the plants.
std::string data_card(const DatasetPlan& plan, const std::string& folder, Progress& progress);

}  // namespace meristem
