// SPDX-License-Identifier: Apache-2.0
// The content of dataset.json, and the names of the parts of a data set's folder:
//
//   documents/NAME/     each document, and the files that it names
//   plan.json           the plan, with the documents below
//   dataset.json        what this data set is, with the hashes of its tables; a folder without it is none yet
//   plants/0000/        the files of a thousand plants
//   manifest/00000.csv  a table of the manifest, once all of its plants are made
//   checks/             a copy of the plan, and hashes of rows and columns of each table
//   partial/            rows of other tables, and files of plants that are being made
//   README.md           the data card, once all plants are made
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meristem/dataset/dataset_plan.h"

namespace meristem {

/// A document of a data set.
struct DatasetDocument {
  std::string name;                                          ///< name of the document in the plan
  std::string document;                                      ///< path of its file below documents/NAME
  std::string hash;                                          ///< of the file and all that it names
  std::vector<std::pair<std::string, std::string>> files{};  ///< path below documents/NAME and hash of each file; empty
                                                             ///< in format 1

  /// Returns true for an equal name and equal content.
  bool is_same(const DatasetDocument& other) const {
    return name == other.name && document == other.document && hash == other.hash;
  }
};

/// The format of dataset.json that this program writes. Format 1 has no hashes of tables and files.
inline constexpr int kDatasetFormat = 2;

/// The content of dataset.json.
struct DatasetInfo {
  int format = kDatasetFormat;                 ///< format of dataset.json
  std::string version;                         ///< version of the program that began it
  std::string name;                            ///< name of the data set, as its plan says
  std::string plan;                            ///< hash of the plan
  std::uint64_t plants = 0;                    ///< plants of the plan
  std::uint64_t rows = 0;                      ///< rows in a table of the manifest
  std::vector<DatasetDocument> documents;      ///< documents of the plan
  std::vector<std::string> tables{};           ///< hash of each table; empty until all plants of the table are made
  std::map<std::string, std::string> files{};  ///< hashes of plan, data card and arrays, by path
  bool is_as_written = true;                   ///< false if somebody has edited the file since
  /// Name of a part that only a later format than `format` has, such as "'hash'" or "checks/plan.json". Empty if no
  /// such part was found.
  std::string later_part{};

  std::uint64_t table_count() const { return (plants + rows - 1) / rows; }  ///< tables of the manifest
};

/// Names of parts of a folder.
inline constexpr const char* kDatasetInfoName = "dataset.json";
inline constexpr const char* kFolderPlanName = "plan.json";       ///< the plan, within the folder
inline constexpr const char* kDocumentsName = "documents";        ///< folder of the documents
inline constexpr const char* kChecksName = "checks";              ///< folder of hashes and of a copy of the plan
inline constexpr const char* kPlanCopyName = "checks/plan.json";  ///< copy of the plan
inline constexpr const char* kDataCardName = "README.md";         ///< the data card

/// Returns the path of dataset.json in a folder.
std::string dataset_info_path(const std::string& folder);
/// Returns the path of the plan in a folder.
std::string folder_plan_path(const std::string& folder);
/// Returns the path of the folder of documents in a folder.
std::string documents_path(const std::string& folder);

/// Returns the content of dataset.json for the data set of a plan.
DatasetInfo info_of(const DatasetPlan& plan);

/// Reads dataset.json of a folder. Returns nothing if the file does not exist. Throws InputError if it cannot be read,
/// or if it names files outside of the folder.
std::optional<DatasetInfo> read_dataset_info(const std::string& folder);

/// Returns the error that a folder holds no data set.
InputError no_dataset(const std::string& folder);

/// Returns the text of dataset.json.
std::string dataset_info_text(const DatasetInfo& info);

/// Returns the text of the plan with which the data set was begun: plan.json, or its copy in checks/ if plan.json has
/// changed since. Returns plan.json if it is unknown which one is right.
std::string begun_plan_text(const std::string& folder);

/// Returns the text of plan.json: a plan with the folder's own documents that describes the data set of `plan`.
std::string folder_plan_text(const DatasetPlan& plan);

/// Returns the path of a table of the manifest in the folder.
std::string manifest_path(const std::string& folder, std::uint64_t table);

}  // namespace meristem
