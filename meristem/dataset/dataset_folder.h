// SPDX-License-Identifier: Apache-2.0
// The folder of a data set that is being made: existing plants, missing plants, and the tables of its manifest. This
// class makes no plants. A program takes ranges of missing plants, makes them on any thread or machine, and reports
// them back.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/dataset/dataset_plan.h"
#include "meristem/dataset/plant_range.h"

namespace meristem {

/// The purpose for which a folder is opened.
enum class DatasetOpening {
  resume,  ///< continue with the existing plants if their files exist with the right sizes
  repair,  ///< continue with the existing plants if all their hashes are right; restore missing parts of the folder
  fresh,   ///< begin a new data set; the folder must be empty
};

/// A data set while it is made. Only one program at a time may use it.
class DatasetFolder {
 public:
  /// Begins a data set in `folder`, or continues with an existing one. The folder is created if necessary. Throws
  /// InputError if the folder holds something else, a data set of another plan, or a data set of a document that has
  /// been edited since. Throws MachineError if writing fails, if another program is using the folder, or if a repair
  /// lacks what it needs. After an exception, existing files are unchanged. `plan` must outlive this object.
  DatasetFolder(const DatasetPlan& plan, std::string folder, DatasetOpening opening, Progress& progress);
  ~DatasetFolder();
  DatasetFolder(const DatasetFolder&) = delete;
  DatasetFolder& operator=(const DatasetFolder&) = delete;

  const std::string& path() const;  ///< path of the folder, as it was given
  std::uint64_t total() const;      ///< plants of the plan
  std::uint64_t done() const;       ///< number of existing plants
  std::uint64_t found() const;      ///< number of plants that existed when the folder was opened
  /// Faults of existing plants, which will be made again: one line each, at most the first hundred.
  const std::vector<std::string>& errors() const;
  std::uint64_t error_count() const;  ///< number of all faults

  /// Number of plants that have failed: their row has an error, and they have no files.
  std::uint64_t failed() const;
  /// Key and error of the first failed plants, one line each, at most ten.
  const std::vector<std::string>& failures() const;
  /// Returns a summary such as "7 of 12 plants written, 5 failed: 000002: ...". Returns an empty text if no plant has
  /// failed.
  std::string failed_text() const;

  /// Returns the next missing plants, about as many as are made in `seconds`. Returns nothing once all were given.
  std::optional<PlantRange> next(double seconds = 0.5);
  /// Reports that make_range or put_range has written a range, and the seconds that this took. A table of the manifest
  /// appears with the last range in it. Throws MachineError.
  void add(PlantRange range, double seconds);

  /// Writes the data card and removes partial files. All plants must exist.
  void finish(Progress& progress);
  /// Adds the hash of a file of the folder, such as manifest.npz, to dataset.json. The file is removed when a table
  /// changes.
  void add_file(const std::string& name);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace meristem
