// SPDX-License-Identifier: Apache-2.0
// The folder in which a data set comes about: what is there, what is missing, and the tables of its manifest. It makes
// no plants itself: a program takes ranges of missing plants, has them made wherever it likes, and tells when they are.
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

/// What a folder is opened for.
enum class DatasetOpening {
  resume,  ///< go on with what is there, if its files are there with their sizes
  repair,  ///< go on with what is there, if all of it has its hashes; put back what belongs to the folder
  fresh,   ///< begin; a folder that holds anything is refused
};

/// One data set while it is made. One program at a time.
class DatasetFolder {
 public:
  /// Begins the data set in `folder`, which is made, or goes on with it. Throws InputError where the folder holds
  /// something else, a data set of another plan, or one of a document that has been edited since; MachineError where
  /// the disk refuses, another program is at work in it, or a repair lacks what it needs. Nothing that is there is
  /// changed then. `plan` outlives it.
  DatasetFolder(const DatasetPlan& plan, std::string folder, DatasetOpening opening, Progress& progress);
  ~DatasetFolder();
  DatasetFolder(const DatasetFolder&) = delete;
  DatasetFolder& operator=(const DatasetFolder&) = delete;

  const std::string& path() const;  ///< path of the folder, as it was given
  std::uint64_t total() const;      ///< plants of the plan
  std::uint64_t done() const;       ///< plants that are there
  std::uint64_t found() const;      ///< plants that were there when it was opened
  /// Faults of the folder's content, which is made again: one line each, the first hundred.
  const std::vector<std::string>& faults() const;
  std::uint64_t fault_count() const;  ///< number of all faults

  /// Plants that are there with an error and without files.
  std::uint64_t failed() const;
  /// Key and error of the first of them, one line each, at most ten.
  const std::vector<std::string>& failures() const;
  /// "7 of 12 plants written, 5 failed: 000002: ..."; empty if none has failed.
  std::string failed_text() const;

  /// The next missing plants, about as many as are made in `seconds`; nothing once all were given.
  std::optional<PlantRange> next(double seconds = 0.5);
  /// Tells that a range was made, which make_range or put_range has written, and how many seconds that took. Its table
  /// of the manifest appears once it was the last one of it. Throws MachineError.
  void add(PlantRange range, double seconds);

  /// Writes the data card and removes what was partial. All plants must be there.
  void finish(Progress& progress);
  /// Adds the hash of a file of the folder to dataset.json, such as manifest.npz. The file goes when a table changes.
  void add_file(const std::string& name);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace meristem
