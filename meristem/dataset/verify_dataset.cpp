// SPDX-License-Identifier: Apache-2.0
// Checks a data set in the order of its parts: plan, documents, tables with their rows, files of plants, data card and
// arrays. Hashes in dataset.json and checks/ show changes, and drawn values are drawn again. Last, files that belong to
// no part are reported.
#include "meristem/dataset/verify_dataset.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/in_quotes.h"
#include "meristem/base/parallel.h"
#include "meristem/base/whole_file.h"
#include "meristem/dataset/dataset_info.h"
#include "meristem/dataset/dataset_links.h"
#include "meristem/dataset/dataset_plan.h"
#include "meristem/dataset/plant_range.h"
#include "meristem/dataset/table_hashes.h"
#include "meristem/document/json.h"
#include "meristem/graph/table/file_access.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

/// Returns the hash of a document in the folder.
std::string hash_of_unpacked(const DatasetDocument& document, const std::string& folder) {
  DocumentBundle bundle{.document = document.document, .files = {}};
  each_file_below(folder, [&](const std::string& path, bool is_left_over) {
    if (is_left_over) return;
    bundle.files.emplace_back(path, whole_file((fs::path(folder) / path).string()).value_or(""));
  });
  std::sort(bundle.files.begin(), bundle.files.end());
  return bundle.hash();
}

/// Returns the first member in which two plans differ, for messages. Returns an empty text if they are equal.
std::string difference_of(const std::string& now, const std::string& before) {
  try {
    const Value changed = parse_json(now);
    const Value original = parse_json(before);
    if (changed.object() == nullptr || original.object() == nullptr) return "";
    for (const auto& [name, value] : *original.object()) {
      const Value* const found = changed.find(name);
      if (found == nullptr) return fmt::format("'{}' is missing", name);
      if (*found == value) continue;
      return fmt::format("'{}' is {}, and was {}", name, in_quotes(write_json_line(*found)),
                         in_quotes(write_json_line(value)));
    }
    for (const auto& [name, value] : *changed.object()) {
      if (original.find(name) == nullptr) return fmt::format("'{}' has been added", name);
    }
    return "it says the same in other words";
  } catch (const InputError& error) {
    return error.diagnostics().front().text();
  }
}

/// Checks a whole folder.
class DatasetVerifier {
 public:
  DatasetVerifier(std::string folder, const Registry& registry, std::string models, Progress& progress,
                  DatasetCheckOptions options)
      : folder_(std::move(folder)),
        registry_(registry),
        models_(std::move(models)),
        options_(std::move(options)),
        progress_(progress) {}

  DatasetCheck run() {
    FileAccess{.root = options_.root}.require_within(folder_);
    require_links_within(folder_, options_.root);
    std::error_code error;
    if (!fs::exists(dataset_info_path(folder_), error)) throw no_dataset(folder_);
    const bool is_readable = read_info();
    if (is_readable) documents_ = document_errors(info_, folder_);
    read_plan();
    if (!is_readable && plan_) recover_info();
    if (!is_readable && !plan_) return std::move(check_);
    check_info(is_readable);
    check_.plants = info_.plants;
    check_plan();
    take(documents_);
    check_tables();
    check_files();
    check_strangers();
    return std::move(check_);
  }

 private:
  template <class... Arguments>
  void tell(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    check_.errors.push_back(fmt::format(format, std::forward<Arguments>(arguments)...));
  }
  void take(const std::vector<std::string>& errors) {
    check_.errors.insert(check_.errors.end(), errors.begin(), errors.end());
  }
  std::string path(const std::string& below) const { return (fs::path(folder_) / below).string(); }

  bool read_info() {
    try {
      info_ = *read_dataset_info(folder_);
      return true;
    } catch (const InputError& error) {
      tell("{}", error.diagnostics().front().text());
      return false;
    }
  }

  /// Reads the plan with which the data set was begun. Without it, random values cannot be checked.
  void read_plan() {
    const std::string file = folder_plan_path(folder_);
    try {
      plan_ = read_dataset_plan(begun_plan_text(folder_), file, registry_, {.models = models_, .root = options_.root});
    } catch (const std::exception& error) {
      // check_plan reports the fault, unless a document has changed.
      const auto* const input = dynamic_cast<const InputError*>(&error);
      plan_error_ = input != nullptr ? input->diagnostics().front().text() : error.what();
      return;
    }
    if (info_.plants > 0 && plan_->hash != info_.plan) {
      plan_error_ = "it is the plan of another data set";
      plan_.reset();
    }
  }

  void recover_info() {
    info_ = info_of(*plan_);
    info_.is_as_written = false;
    documents_ = document_errors(info_, folder_);
  }

  void check_info(bool is_readable) {
    const std::string file = dataset_info_path(folder_);
    if (info_.format < kDatasetFormat && info_.is_as_written) {
      check_.is_old = true;
      std::vector<std::string>& lines = options_.allow_old ? check_.warnings : check_.errors;
      lines.push_back(
          fmt::format("{}: the tables could not be checked: an earlier version of the program made this data set, "
                      "without hashes of its tables. Measures, errors and the data card may have changed",
                      file));
      return;
    }
    if (!is_readable || info_.is_as_written) return;
    const std::size_t before = check_.errors.size();
    if (!info_.later_part.empty()) {
      tell("{}: its format is {}, and {} is of a later one", file, info_.format, info_.later_part);
      info_.format = kDatasetFormat;
    }
    if (plan_) {
      const DatasetInfo expected = info_of(*plan_);
      const auto compare = [&](const char* name, const auto& found, const auto& right) {
        if (found != right) tell("{}: '{}' is {}; the plan says {}", file, name, found, right);
      };
      compare("name", info_.name, expected.name);
      compare("plants", info_.plants, expected.plants);
      compare("rows", info_.rows, expected.rows);
      info_.plants = expected.plants;
      info_.rows = expected.rows;
      info_.tables.resize(info_.table_count());
      for (std::size_t k = 0; k < std::min(info_.documents.size(), expected.documents.size()); ++k) {
        compare("documents", info_.documents[k].name + " " + info_.documents[k].hash,
                expected.documents[k].name + " " + expected.documents[k].hash);
      }
    }
    for (std::uint64_t table = 0; table < info_.table_count(); ++table) {
      const auto hashes = read_table_hashes(folder_, table);
      const bool is_of_format_1 = !info_.later_part.empty() && info_.tables[table].empty();
      if (!hashes || info_.tables[table] == hashes->table || is_of_format_1) continue;
      tell("{}: the hash of the table {} is not that of {}", file, table, table_hashes_path(folder_, table));
    }
    if (check_.errors.size() == before) tell("{}: the file has changed since it was written", file);
  }

  void check_plan() {
    const std::string file = folder_plan_path(folder_);
    const auto text = whole_file(file);
    const auto copy = whole_file(path(kPlanCopyName));
    const auto known = info_.files.find(kFolderPlanName);
    if (known != info_.files.end() && info_.is_as_written) {
      if (!text) {
        tell("{} is missing", file);
      } else if (text_hash(*text) != known->second) {
        const std::string what = copy ? difference_of(*text, *copy) : "";
        tell("{}: the plan has changed since the data set was begun{}{}", file, what.empty() ? "" : ": ", what);
      }
      if (!copy || text_hash(*copy) != known->second) {
        tell("{} {}", path(kPlanCopyName), copy ? "has other bytes than were written" : "is missing");
      }
    } else if (!text) {
      tell("{} is missing", file);
    }
    if (!plan_ && documents_.empty()) tell("{}: the drawn values cannot be checked: {}", file, plan_error_);
    if (!plan_ && !documents_.empty()) {
      check_.warnings.push_back(
          fmt::format("{}: the drawn values are not checked, because a document has changed", file));
    }
  }

  // Tables.

  struct TableCheck {
    DatasetCheck sums;
    std::set<std::string> paths;
  };

  TableCheck check_table(std::uint64_t table) {
    TableCheck check;
    const std::uint64_t begin = table * info_.rows;
    const std::uint64_t end = std::min(info_.plants, begin + info_.rows);
    const std::string file = manifest_path(folder_, table);
    const TableKnowledge knowledge{.info = info_, .plan = plan_ ? &*plan_ : nullptr, .folder = folder_};
    std::error_code error;
    if (!fs::exists(file, error)) {
      const std::uint64_t rows = check_parts(knowledge, table, check);
      check.sums.errors.insert(check.sums.errors.begin(),
                               rows == 0 ? fmt::format("{} is missing: {} plants", file, end - begin)
                                         : fmt::format("{} is missing: {} plants, {} of them have rows in partial/",
                                                       file, end - begin, rows));
      progress_.advance(end - begin);
      return check;
    }
    const TableRows rows = check_table_rows(knowledge, table);
    check.sums.errors = rows.errors;
    const std::vector<std::optional<std::string>> errors = errors_of_rows(rows.rows, folder_, true, progress_);
    for (std::size_t row = 0; row < rows.rows.size(); ++row) {
      add_row(rows.rows[row].entry, check);
      if (errors[row]) check.sums.errors.push_back(*errors[row]);
    }
    const auto hashes = read_table_hashes(folder_, table);
    const bool is_known = !info_.tables.empty() && !info_.tables[table].empty();
    if (is_known && info_.is_as_written && (!hashes || hashes->table != info_.tables[table])) {
      const std::string checks = table_hashes_path(folder_, table);
      check.sums.errors.push_back(
          fmt::format("{} {}", checks, fs::exists(checks, error) ? "has other bytes than were written" : "is missing"));
    }
    if (!is_known && !hashes && info_.format == kDatasetFormat) {
      check.sums.errors.push_back(fmt::format("{}: the table has no hash", file));
    }
    return check;
  }

  static void add_row(const ManifestEntry& entry, TableCheck& check) {
    ++check.sums.rows;
    check.sums.failed += entry.error.empty() ? 0 : 1;
    for (const PlantFile& file : entry.files) {
      ++check.sums.files;
      check.sums.bytes += file.bytes;
      check.paths.insert(file.path);
    }
  }

  /// Checks the rows of a table that is not complete. Returns the number of plants with a row.
  std::uint64_t check_parts(const TableKnowledge& knowledge, std::uint64_t table, TableCheck& check) {
    std::map<std::uint64_t, std::optional<std::string>> plants;  // each with the fault of its files
    const auto parts = parts_.find(table);
    if (parts == parts_.end()) return 0;
    for (const std::string& part : parts->second) {
      const TableRows rows = check_part_rows(knowledge, part, table);
      check.sums.errors.insert(check.sums.errors.end(), rows.errors.begin(), rows.errors.end());
      for (const TableRow& row : rows.rows) {
        for (const PlantFile& file : row.entry.files) check.paths.insert(file.path);
        // A plant that was made again has an older row as well; one of its rows must fit its files.
        const auto [plant, is_new] = plants.try_emplace(row.entry.number);
        if (is_new || plant->second) plant->second = error_of_files(row.entry, folder_, true, progress_);
      }
    }
    for (auto& [number, error] : plants) {
      if (error) check.sums.errors.push_back(std::move(*error));
    }
    return plants.size();
  }

  void check_tables() {
    parts_ = row_parts(info_, folder_);
    std::vector<TableCheck> checks(info_.table_count());
    progress_.begin("reading all files", info_.plants);
    parallel_for(checks.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t table = begin; table < end; ++table) {
        progress_.check();
        checks[table] = check_table(table);
      }
    });
    for (TableCheck& check : checks) {
      check_.rows += check.sums.rows;
      check_.failed += check.sums.failed;
      check_.files += check.sums.files;
      check_.bytes += check.sums.bytes;
      take(check.sums.errors);
      paths_.merge(check.paths);
    }
  }

  /// Checks the data card, and arrays that Python has written.
  void check_files() {
    if (info_.format < kDatasetFormat || !info_.is_as_written) return;
    for (const auto& [name, hash] : info_.files) {
      if (name == kFolderPlanName) continue;
      const auto content = whole_file(path(name));
      if (content && text_hash(*content) == hash) continue;
      tell("{} {}", path(name), content ? "has other bytes than were written" : "is missing");
    }
    if (!info_.files.contains(kDataCardName) && check_.rows == info_.plants) {
      tell("{} is not written yet: the data set was stopped at its end", path(kDataCardName));
    }
  }

  void check_strangers() {
    for (const std::string& stranger : strange_tables(info_, folder_)) tell("{} belongs to no table", stranger);
    std::vector<std::string> strangers;
    each_file_below(path("plants"), [&](const std::string& below, bool is_left_over) {
      if (is_left_over || paths_.contains("plants/" + below)) return;
      strangers.push_back(fmt::format("{} belongs to no row", path("plants/" + below)));
    });
    std::sort(strangers.begin(), strangers.end());
    take(strangers);
  }

  std::string folder_;
  const Registry& registry_;
  std::string models_;
  DatasetCheckOptions options_;
  Progress& progress_;
  DatasetInfo info_;
  std::optional<DatasetPlan> plan_;
  std::string plan_error_;
  std::vector<std::string> documents_;  // faults
  std::map<std::uint64_t, std::vector<std::string>> parts_;
  std::set<std::string> paths_;
  DatasetCheck check_;
};

}  // namespace

std::optional<std::string> error_of_files(const ManifestEntry& entry, const std::string& folder, bool reads_all,
                                          const Progress& progress) {
  for (const PlantFile& file : entry.files) {
    progress.check();
    const fs::path path = fs::path(folder) / file.path;
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) return fmt::format("{} is missing", path.string());
    if (size != file.bytes) return fmt::format("{} has {} bytes instead of {}", path.string(), size, file.bytes);
    if (!reads_all) continue;
    const auto content = whole_file(path.string());
    if (!content) return fmt::format("{} cannot be read", path.string());
    if (text_hash(*content) != file.hash) return fmt::format("{} has other bytes than were written", path.string());
  }
  return std::nullopt;
}

std::vector<std::optional<std::string>> errors_of_rows(const std::vector<TableRow>& rows, const std::string& folder,
                                                       bool reads_all, Progress& progress) {
  constexpr std::size_t kRowsAtOnce = 8;
  std::vector<std::optional<std::string>> errors(rows.size());
  parallel_for(rows.size(), kRowsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      errors[row] = error_of_files(rows[row].entry, folder, reads_all, progress);
      progress.advance();
    }
  });
  return errors;
}

void each_file_below(const std::string& folder, FunctionRef<void(const std::string& path, bool is_left_over)> take) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error)) {
    if (!entry.is_regular_file(error)) continue;
    const std::string name = entry.path().filename().string();
    take(entry.path().lexically_relative(folder).generic_string(), name.starts_with('.') && name.ends_with(".part"));
  }
}

std::vector<std::string> document_errors(const DatasetInfo& info, const std::string& folder) {
  std::vector<std::string> errors;
  for (const DatasetDocument& document : info.documents) {
    const fs::path root = fs::path(documents_path(folder)) / document.name;
    if (document.files.empty()) {
      if (hash_of_unpacked(document, root.string()) != document.hash) {
        errors.push_back(fmt::format("{} has changed", root.string()));
      }
      continue;
    }
    std::set<std::string> known;
    for (const auto& [path, hash] : document.files) {
      known.insert(path);
      const auto content = whole_file((root / path).string());
      if (content && text_hash(*content) == hash) continue;
      errors.push_back(fmt::format("{} {}", (root / path).string(),
                                   content ? "has changed since the data set was begun" : "is missing"));
    }
    std::vector<std::string> strangers;
    each_file_below(root.string(), [&](const std::string& path, bool is_left_over) {
      if (!is_left_over && !known.contains(path)) strangers.push_back(path);
    });
    std::sort(strangers.begin(), strangers.end());
    for (const std::string& path : strangers) {
      errors.push_back(fmt::format("{} belongs to no document", (root / path).string()));
    }
  }
  return errors;
}

std::vector<std::string> strange_tables(const DatasetInfo& info, const std::string& folder) {
  std::set<std::string> known{(fs::path(folder) / kPlanCopyName).string()};
  for (std::uint64_t table = 0; table < info.table_count(); ++table) {
    known.insert(manifest_path(folder, table));
    known.insert(table_hashes_path(folder, table));
  }
  std::vector<std::string> strangers;
  for (const char* const name : {"manifest", kChecksName}) {
    const fs::path root = fs::path(folder) / name;
    each_file_below(root.string(), [&](const std::string& path, bool is_left_over) {
      const std::string file = (root / path).string();
      if (!is_left_over && !known.contains(file)) strangers.push_back(file);
    });
  }
  std::sort(strangers.begin(), strangers.end());
  return strangers;
}

DatasetCheck verify_dataset(const std::string& folder, const Registry& registry, const std::string& models,
                            Progress& progress, const DatasetCheckOptions& options) {
  return DatasetVerifier(folder, registry, models, progress, options).run();
}

}  // namespace meristem
