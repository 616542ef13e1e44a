// SPDX-License-Identifier: Apache-2.0
// Some plants of a data set, made one after another: the task of a thread, a process or a machine.
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
  std::uint64_t end = 0;    ///< behind the number of the last plant

  std::uint64_t count() const { return end - begin; }  ///< number of plants
  bool operator==(const PlantRange&) const = default;
};

/// Plants that were made apart from the folder of their data set.
struct MadeRange {
  PlantRange range;  ///< the plants
  std::string rows;  ///< of the manifest
  /// Path below the folder of the data set, and content.
  std::vector<std::pair<std::string, std::string>> files;
};

/// Whether this machine sees the folder of a data set that the plan has begun.
bool sees_dataset(const DatasetPlan& plan, const std::string& folder);

/// Makes the plants of a range in the folder of their data set: each plant's files appear under their names once all of
/// them are whole, and the rows of the range appear as a file in `partial/` last. May be called on any machine that
/// sees the folder, also twice for one range. Throws MachineError (disk), Cancelled.
void make_range(PlantMaker& maker, const DatasetPlan& plan, PlantRange range, const std::string& folder,
                Progress& progress);

/// Makes the plants of a range in memory. `scratch` is a folder for files on their way. Throws as make_range.
MadeRange make_range_apart(PlantMaker& maker, const DatasetPlan& plan, PlantRange range, const std::string& scratch,
                           Progress& progress);

/// Writes what make_range_apart has made, as make_range would have.
void put_range(const MadeRange& made, const DatasetPlan& plan, const std::string& folder);

/// The file in `partial/` that holds the rows of a range. Its last line has the hash of all others.
std::string rows_path(const std::string& folder, PlantRange range);

/// Returns the files in `partial/` with rows of each table, in order.
std::map<std::uint64_t, std::vector<std::string>> row_parts(const DatasetInfo& info, const std::string& folder);

}  // namespace meristem
