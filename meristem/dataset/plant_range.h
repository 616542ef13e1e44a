// SPDX-License-Identifier: Apache-2.0
// Ranges of plants of a data set. A thread, a process or a machine makes a range as one task.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/dataset/dataset_info.h"
#include "meristem/dataset/dataset_plan.h"
#include "meristem/dataset/plant_maker.h"

namespace meristem {

/// The plants [begin, end) of a plan, all in one table of the manifest.
struct PlantRange {
  std::uint64_t begin = 0;  ///< number of the first plant
  std::uint64_t end = 0;    ///< number after the last plant

  std::uint64_t count() const { return end - begin; }  ///< number of plants
  bool operator==(const PlantRange&) const = default;
};

/// Plants that were made outside the folder of their data set.
struct MadeRange {
  PlantRange range;  ///< the plants
  std::string rows;  ///< rows of the manifest
  /// Path below the folder of the data set, and content, of each file.
  std::vector<std::pair<std::string, std::string>> files;
};

/// Returns true if this machine can see the folder of a data set that the plan has begun.
bool sees_dataset(const DatasetPlan& plan, const std::string& folder);

/// Makes the plants of a range in the folder of their data set. A plant's files get their names once all of them are
/// complete, and the rows of the range appear last, as a file in `partial/`. May be called on any machine that can see
/// the folder, also twice for one range. Throws MachineError (disk), Cancelled.
void make_range(PlantMaker& maker, const DatasetPlan& plan, PlantRange range, const std::string& folder,
                Progress& progress);

/// Makes the plants of a range in memory. `scratch` is a folder for temporary files. Throws as make_range.
MadeRange make_range_apart(PlantMaker& maker, const DatasetPlan& plan, PlantRange range, const std::string& scratch,
                           Progress& progress);

/// Writes the result of make_range_apart to the folder, as make_range would have done.
void put_range(const MadeRange& made, const DatasetPlan& plan, const std::string& folder);

/// Returns the path of the file in `partial/` with the rows of a range. Its last line has the hash of all other lines.
std::string rows_path(const std::string& folder, PlantRange range);

/// Returns the files in `partial/` with rows of each table, in order.
std::map<std::uint64_t, std::vector<std::string>> row_parts(const DatasetInfo& info, const std::string& folder);

}  // namespace meristem
