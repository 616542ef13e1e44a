// SPDX-License-Identifier: Apache-2.0
// Makes the plants of a plan, one after another: grows each, writes its files, measures it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "meristem/base/progress.h"
#include "meristem/dataset/dataset_plan.h"
#include "meristem/dataset/manifest.h"
#include "meristem/document/grow.h"

namespace meristem {

/// Where makers find the documents of a plan.
struct DocumentFolders {
  std::string documents;  ///< folder in which unpack_documents has unpacked them
  std::string models{};   ///< folder of shipped models, which documents may name
};

/// Writes the documents of a plan, with the files that they name, below a folder. Throws MachineError.
void unpack_documents(const DatasetPlan& plan, const std::string& folder);

/// The file of a document where unpack_documents has put it.
std::string unpacked_document(const PlannedDocument& document, const std::string& folder);

/// One at a time; what documents have in common (files that they name, textures) is made once. The plants are the same
/// whatever was made before.
class PlantMaker {
 public:
  /// `plan` and `registry` outlive it.
  PlantMaker(const DatasetPlan& plan, const Registry& registry, DocumentFolders folders);
  ~PlantMaker();
  PlantMaker(const PlantMaker&) = delete;
  PlantMaker& operator=(const PlantMaker&) = delete;

  /// The document with the values and the seed of a plant. Throws InputError.
  Document document_of(const PlannedPlant& plant) const;

  /// Makes the plant of a number. Its files appear in `folder`, which exists and is empty, with paths that the data set
  /// will have. A plant that its values do not allow is told by MadePlant::error. Throws MachineError, Cancelled.
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

/// The folder below a data set in which the files of a plant lie: "plants/0000".
std::string plant_folder(const PlannedPlant& plant);

}  // namespace meristem
