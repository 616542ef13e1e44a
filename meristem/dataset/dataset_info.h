// SPDX-License-Identifier: Apache-2.0
// What a folder says of the data set in it, and the names of its parts:
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
  std::vector<std::pair<std::string, std::string>> files{};  ///< path below documents/NAME and hash; none in format 1

  /// Returns true for the same name and content.
  bool is_same(const DatasetDocument& other) const {
    return name == other.name && document == other.document && hash == other.hash;
  }
};

/// The format of dataset.json that this program writes. Format 1 has no hashes of tables and files.
inline constexpr int kDatasetFormat = 2;

/// What dataset.json says.
struct DatasetInfo {
  int format = kDatasetFormat;                 ///< format of dataset.json
  std::string version;                         ///< of the program that began it
  std::string name;                            ///< name of the data set, as its plan says
  std::string plan;                            ///< hash of the plan
  std::uint64_t plants = 0;                    ///< plants of the plan
  std::uint64_t rows = 0;                      ///< of a table of the manifest
  std::vector<DatasetDocument> documents;      ///< documents of the plan
  std::vector<std::string> tables{};           ///< hash of each table; empty until all plants of the table are made
  std::map<std::string, std::string> files{};  ///< hashes of plan, data card and arrays, by path
  bool is_as_written = true;                   ///< false if somebody has edited the file since
  /// Names a part of a later format than `format`, such as "'hash'" or "checks/plan.json". Empty: no such part was
  /// found.
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

/// Where these lie in a folder.
std::string dataset_info_path(const std::string& folder);
/// Returns the path of the plan in a folder.
std::string folder_plan_path(const std::string& folder);
/// Returns the path of the folder of documents in a folder.
std::string documents_path(const std::string& folder);

/// What the data set of a plan says of itself.
DatasetInfo info_of(const DatasetPlan& plan);

/// dataset.json of a folder; nothing where there is none. Throws InputError where it cannot be read as one,
/// or names files outside of the folder.
std::optional<DatasetInfo> read_dataset_info(const std::string& folder);

/// Says that a folder holds no data set.
InputError no_dataset(const std::string& folder);

/// The text of dataset.json.
std::string dataset_info_text(const DatasetInfo& info);

/// Returns the text of the plan as the data set was begun with it: plan.json, or its copy in checks/ if plan.json has
/// changed since. Returns plan.json if nothing tells which one is right.
std::string begun_plan_text(const std::string& folder);

/// The text of plan.json: a plan that reads as the same data set from the folder, with its own documents.
std::string folder_plan_text(const DatasetPlan& plan);

/// The path of a table of the manifest, in the folder.
std::string manifest_path(const std::string& folder, std::uint64_t table);

}  // namespace meristem
