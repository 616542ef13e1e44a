// SPDX-License-Identifier: Apache-2.0
// Reads and writes dataset.json. Its last member is a hash of everything before it, which shows whether somebody has
// edited the file. Paths in the file must stay below the folder of the data set.
#include "meristem/dataset/dataset_info.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/version.h"
#include "meristem/base/whole_file.h"
#include "meristem/dataset/table_hashes.h"
#include "meristem/document/json.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

const std::string& text_member(const Value& object, const char* name) {
  static const std::string none;
  const Value* const member = object.find(name);
  return member != nullptr && member->text() != nullptr ? *member->text() : none;
}

std::uint64_t count_member(const Value& object, const char* name) {
  const Value* const member = object.find(name);
  const double* const number = member != nullptr ? member->number() : nullptr;
  const bool is_count = number != nullptr && *number >= 0 && *number <= 1e15 && *number == std::floor(*number);
  return is_count ? static_cast<std::uint64_t>(*number) : 0;
}

Value object_of(const std::map<std::string, std::string>& texts) {
  return Value(Value::Object(texts.begin(), texts.end()));
}

std::vector<std::pair<std::string, std::string>> texts_in(const Value* object) {
  std::vector<std::pair<std::string, std::string>> texts;
  if (object == nullptr || object->object() == nullptr) return texts;
  for (const auto& [name, value] : *object->object()) {
    if (value.text() != nullptr) texts.emplace_back(name, *value.text());
  }
  return texts;
}

/// Returns true if a path stays below the folder of the data set. Files outside the folder are never read or removed.
bool stays_below(const fs::path& path) {
  const fs::path own = path.lexically_normal();
  return !own.empty() && own.is_relative() && *own.begin() != "..";
}

/// Returns true if a document and all of its files lie below documents/.
bool stays_below(const DatasetDocument& document) {
  const fs::path name(document.name);
  return stays_below(name) && std::all_of(document.files.begin(), document.files.end(),
                                          [&name](const auto& file) { return stays_below(name / file.first); });
}

/// Returns a part of the folder that data sets of format 1 do not have, which means that somebody has edited the format
/// number. Returns an empty text if the folder has no such part.
std::string part_of_later_format(const Value& value, const std::string& folder) {
  for (const char* const name : {"hash", "tables", "files"}) {
    if (value.find(name) != nullptr) return fmt::format("'{}'", name);
  }
  const Value* const documents = value.find("documents");
  if (documents != nullptr && documents->list() != nullptr) {
    for (std::size_t k = 0; k < documents->list()->size(); ++k) {
      if ((*documents->list())[k].find("files") != nullptr) return fmt::format("'documents[{}].files'", k);
    }
  }
  std::string first;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(folder) / kChecksName, error)) {
    const std::string name = fmt::format("{}/{}", kChecksName, entry.path().filename().string());
    if (first.empty() || name < first) first = name;
  }
  return first;
}

/// Returns dataset.json without its last member, which is the hash of this text.
Value::Object told_by(const DatasetInfo& info) {
  Value::List documents;
  for (const DatasetDocument& document : info.documents) {
    documents.emplace_back(
        Value::Object{{"name", document.name},
                      {"document", document.document},
                      {"hash", document.hash},
                      {"files", Value(Value::Object(document.files.begin(), document.files.end()))}});
  }
  Value::List tables;
  for (const std::string& hash : info.tables) tables.push_back(hash.empty() ? Value() : Value(hash));
  return {{"meristem_dataset_folder", info.format},
          {"version", info.version},
          {"name", info.name},
          {"plan", info.plan},
          {"plants", static_cast<double>(info.plants)},
          {"rows", static_cast<double>(info.rows)},
          {"documents", std::move(documents)},
          {"files", object_of(info.files)},
          {"tables", std::move(tables)}};
}

}  // namespace

std::string dataset_info_path(const std::string& folder) { return (fs::path(folder) / kDatasetInfoName).string(); }
std::string folder_plan_path(const std::string& folder) { return (fs::path(folder) / kFolderPlanName).string(); }
std::string documents_path(const std::string& folder) { return (fs::path(folder) / kDocumentsName).string(); }

DatasetInfo info_of(const DatasetPlan& plan) {
  DatasetInfo info{.version = std::string(version()),
                   .name = plan.name,
                   .plan = plan.hash,
                   .plants = plan.count(),
                   .rows = static_cast<std::uint64_t>(plan.rows),
                   .documents = {}};
  for (const PlannedDocument& document : plan.documents) {
    DatasetDocument told{document.name, document.bundle.document, document.bundle.hash()};
    for (const auto& [path, content] : document.bundle.files) told.files.emplace_back(path, text_hash(content));
    info.documents.push_back(std::move(told));
  }
  info.tables.resize(info.table_count());
  return info;
}

std::optional<DatasetInfo> read_dataset_info(const std::string& folder) {
  const std::string path = dataset_info_path(folder);
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return std::nullopt;
  const auto wrong = [&path](std::string what) {
    return InputError(
        Diagnostic{.message = std::move(what), .expected = "the dataset.json of a data set", .file = path});
  };
  Value value;
  std::string text;
  try {
    text = read_text_file(path);
    value = parse_json(text);
  } catch (const InputError& error) {
    Diagnostic diagnostic = error.diagnostics().front();
    diagnostic.file = path;
    diagnostic.expected = "the dataset.json of a data set";
    throw InputError(std::move(diagnostic));
  }
  const std::uint64_t format = count_member(value, "meristem_dataset_folder");
  if (format < 1) throw wrong("this is not what a data set says of itself");
  if (format > kDatasetFormat) throw wrong(fmt::format("its format {} is newer than this program", format));
  DatasetInfo info{.format = static_cast<int>(format),
                   .version = text_member(value, "version"),
                   .name = text_member(value, "name"),
                   .plan = text_member(value, "plan"),
                   .plants = count_member(value, "plants"),
                   .rows = count_member(value, "rows"),
                   .documents = {}};
  if (info.plants < 1 || info.rows < 1 || info.plants > kMaxPlants) throw wrong("it says no number of plants and rows");
  if (const Value* documents = value.find("documents"); documents != nullptr && documents->list() != nullptr) {
    for (const Value& document : *documents->list()) {
      info.documents.push_back({text_member(document, "name"), text_member(document, "document"),
                                text_member(document, "hash"), texts_in(document.find("files"))});
    }
  }
  for (const DatasetDocument& document : info.documents) {
    if (!stays_below(document)) throw wrong("it names a document outside of its folder");
  }
  if (format == 1) {
    info.later_part = part_of_later_format(value, folder);
    info.is_as_written = info.later_part.empty();
    if (info.is_as_written) return info;
  }
  if (const Value* tables = value.find("tables"); tables != nullptr && tables->list() != nullptr) {
    for (const Value& hash : *tables->list()) info.tables.push_back(hash.text() != nullptr ? *hash.text() : "");
  }
  info.tables.resize(info.table_count());
  for (auto& [file, hash] : texts_in(value.find("files"))) {
    if (!stays_below(fs::path(file))) throw wrong("it names a file outside of its folder");
    info.files.emplace(file, std::move(hash));
  }
  info.is_as_written = format > 1 && text == dataset_info_text(info);
  return info;
}

InputError no_dataset(const std::string& folder) {
  return InputError(Diagnostic{.message = "the folder holds no data set",
                               .expected = fmt::format("a folder with {}", kDatasetInfoName),
                               .file = folder});
}

std::string dataset_info_text(const DatasetInfo& info) {
  Value::Object told = told_by(info);
  const std::string hash = text_hash(write_json(Value(told)));
  told.emplace_back("hash", hash);
  return write_json(Value(std::move(told)));
}

std::string begun_plan_text(const std::string& folder) {
  const std::optional<std::string> text = whole_file(folder_plan_path(folder));
  const std::optional<std::string> copy = whole_file((fs::path(folder) / kPlanCopyName).string());
  try {
    const std::optional<DatasetInfo> info = read_dataset_info(folder);
    const auto known = info ? info->files.find(kFolderPlanName) : std::map<std::string, std::string>::const_iterator();
    if (info && known != info->files.end() && copy && text_hash(*copy) == known->second) return *copy;
  } catch (const InputError&) {
    // If dataset.json cannot be read, nothing shows which one is right.
  }
  return text ? *text : copy.value_or("");
}

std::string folder_plan_text(const DatasetPlan& plan) {
  Value tree = plan.tree;
  Value* const documents = tree.find("documents");
  for (std::size_t k = 0; k < plan.documents.size(); ++k) {
    const PlannedDocument& document = plan.documents[k];
    const std::string file = fmt::format("{}/{}/{}", kDocumentsName, document.name, document.bundle.document);
    Value::Object& told = *(*documents->list())[k].object();
    told.insert(told.begin(), {"file", file});
  }
  return write_json(tree);
}

std::string manifest_path(const std::string& folder, std::uint64_t table) {
  return (fs::path(folder) / "manifest" / fmt::format("{:05}.csv", table)).string();
}

}  // namespace meristem
