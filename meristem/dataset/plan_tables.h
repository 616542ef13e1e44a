// SPDX-License-Identifier: Apache-2.0
// The structs that the tables of a plan fill. Parts without a table are read in plan_parts.h and plan_reader.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meristem/dataset/dataset_plan.h"

namespace meristem {

/// A document as the plan names it.
struct PlanDocument {
  std::string file;
  std::string name;
};

/// The plain keys of a plan.
struct PlanHead {
  int format = kDatasetPlanFormat;
  std::string name;
  std::string description;
  std::string author;
  std::string licence;
  std::uint64_t seed = 1;
  int rows = 1000;
  double time = 0;
  std::vector<PlanDocument> documents;
  std::optional<PicturePlan> pictures;
};

const ParameterTable& plan_document_table();  ///< the rows of PlanDocument

}  // namespace meristem
