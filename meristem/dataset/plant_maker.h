// SPDX-License-Identifier: Apache-2.0
// Makes the plants of a plan one after another: grows each plant, writes its files and measures it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "meristem/base/progress.h"
#include "meristem/dataset/dataset_plan.h"
#include "meristem/dataset/manifest.h"
#include "meristem/document/grow.h"

namespace meristem {

/// The folders in which makers find the documents of a plan.
struct DocumentFolders {
  std::string documents;  ///< folder in which unpack_documents has unpacked them
  std::string models{};   ///< folder of shipped models, which documents may name
};

/// Writes the documents of a plan, with the files that they name, below a folder. Creates missing folders. Replaces
/// existing files whose content differs. Throws MachineError.
void unpack_documents(const DatasetPlan& plan, const std::string& folder);

/// Returns the path of a document's file after unpack_documents.
std::string unpacked_document(const PlannedDocument& document, const std::string& folder);

/// Makes plants, one at a time. Things that documents share, such as files and textures, are made once. A plant does
/// not depend on the plants made before it.
class PlantMaker {
 public:
  /// `plan` and `registry` must outlive this object.
  PlantMaker(const DatasetPlan& plan, const Registry& registry, DocumentFolders folders);
  ~PlantMaker();
  PlantMaker(const PlantMaker&) = delete;
  PlantMaker& operator=(const PlantMaker&) = delete;

  /// Returns the document with the values and the seed of a plant. Throws InputError.
  Document document_of(const PlannedPlant& plant) const;

  /// Makes the plant with this number. Its files are written to `folder`, which must exist and be empty.
  /// MadePlant::files lists them by name, with their paths in the data set. If the plant's values are not allowed,
  /// MadePlant::error has the reason, and there are no files and no measures. Throws std::invalid_argument for a number
  /// that is not below DatasetPlan::count(), MachineError, Cancelled.
  MadePlant make(std::uint64_t number, const std::string& folder, Progress& progress);

 private:
  struct Kept;

  std::string relative(std::string text) const;
  void write_files(const PlannedPlant& plant, const Document& document, GrownDocument& grown, const std::string& folder,
                   Progress& progress);

  const DatasetPlan& plan_;
  const Registry& registry_;
  DocumentFolders folders_;
  std::unique_ptr<Kept> kept_;
};

/// Returns the folder of a plant's files, below the data set. A folder has the files of 1000 plants: "plants/0000" of
/// the plants 0 to 999, "plants/0001" of the next 1000.
std::string plant_folder(const PlannedPlant& plant);

}  // namespace meristem
