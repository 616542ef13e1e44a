// SPDX-License-Identifier: Apache-2.0
// A table of the manifest is written once all of its rows exist, in the order of the plants. Until then its rows lie in
// separate files. All of these files and the files of plants appear by renaming, and each plant's row appears after its
// files. After any interruption the rows therefore show which plants exist, and tables do not depend on who made a
// plant or when.
//
// A table is written in this order: hashes of its rows, the table, its hash in dataset.json. The parts with its rows
// are removed last. After any interruption, either the parts or the hashes show whether the table is right.
#include "meristem/dataset/dataset_folder.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <system_error>
#include <unordered_set>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "meristem/base/left_over.h"
#include "meristem/base/parallel.h"
#include "meristem/base/whole_file.h"
#include "meristem/dataset/data_card.h"
#include "meristem/dataset/dataset_info.h"
#include "meristem/dataset/manifest.h"
#include "meristem/dataset/table_check.h"
#include "meristem/dataset/table_hashes.h"
#include "meristem/dataset/verify_dataset.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kErrorsTold = 100;
constexpr std::size_t kFailuresTold = 10;
constexpr std::uint64_t kMaxInRange = 1000;   // plants
constexpr double kNewShare = 0.3;             // weight of the last range in the mean of the times
constexpr std::uint64_t kTablesPerSave = 64;  // dataset.json is written after one new table for each 64 in it

/// The names of parts in a folder in which a data set was begun, and in a complete folder.
constexpr std::array<const char*, 3> kBegun{kDocumentsName, kFolderPlanName, "partial"};
constexpr std::array<const char*, 9> kOwnNames{kDocumentsName, kFolderPlanName, "partial",
                                               kChecksName,    kDataCardName,   "plants",
                                               "manifest",     "manifest.npz",  "manifest.parquet"};

InputError refused(std::string message, std::string expected, const std::string& folder) {
  return InputError(Diagnostic{.message = std::move(message), .expected = std::move(expected), .file = folder});
}

MachineError not_repaired(const std::string& folder, const std::string& why) {
  return MachineError(fmt::format(
      "'{0}' cannot be repaired from the folder alone: {1}; the plan that it was begun with makes it again: "
      "meristem dataset PLAN -o {0} --repair",
      folder, why));
}

/// Locks a folder against other programs for the lifetime of this object. The lock also ends with the process.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder) {
    const std::string path = (folder / "partial" / "lock").string();
    make_folders((folder / "partial").string());
    descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw MachineError(fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    // Some file systems have no locks. There the user must not start two programs at once.
    if (::fcntl(descriptor_, F_SETLK, &lock) != 0 && (errno == EACCES || errno == EAGAIN)) {
      ::close(descriptor_);
      throw MachineError(fmt::format("another program is making the data set in '{}'", folder.string()));
    }
  }
  ~FolderLock() { ::close(descriptor_); }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_ = -1;
};

/// Facts found in the files with rows of a table.
struct FoundInTable {
  std::vector<std::string> errors;
  std::vector<std::uint64_t> plants;  // existing plants
  std::vector<std::string> failures;  // key and error of each plant that failed
  std::vector<std::string> paths;     // paths of the files of all rows
  bool is_whole = false;              // whether the table is unchanged
};

std::string failure_of(const TableRow& row) {
  return fmt::format("{}: {}", row.line.substr(0, row.line.find(',')), row.entry.error);
}

}  // namespace

struct DatasetFolder::State {
  State(const DatasetPlan& the_plan, std::string path) : plan(the_plan), folder(std::move(path)), info(info_of(plan)) {}

  const DatasetPlan& plan;
  const std::string folder;
  DatasetInfo info;   // the next content of dataset.json
  DatasetInfo known;  // the previous content of dataset.json, with which tables are compared
  std::unique_ptr<FolderLock> lock;
  std::vector<bool> is_there;                               // by plant: whether it exists
  std::vector<std::uint32_t> missing;                       // by table: number of missing plants
  std::map<std::uint64_t, std::vector<std::string>> parts;  // by table that is not complete: files with its rows
  std::vector<std::uint64_t> pending;                       // tables whose hashes are not yet in dataset.json
  std::uint64_t there = 0;
  std::uint64_t found = 0;
  std::uint64_t given = 0;    // all plants before this number exist or were given
  double seconds = 0;         // recent mean time per plant
  std::uint64_t largest = 0;  // largest range made so far
  std::vector<std::string> errors;
  std::uint64_t error_count = 0;
  std::uint64_t failed = 0;
  std::vector<std::string> failures;

  TableKnowledge knowledge() const { return {.info = known, .plan = &plan, .folder = folder}; }
  std::string path(const std::string& below) const { return (fs::path(folder) / below).string(); }

  void check_same(const DatasetInfo& before, bool repairs) const;
  void check_hashes_are_of_this(bool is_known_otherwise) const;
  /// Returns true if a document was read from the folder itself.
  bool is_own(const PlannedDocument& document) const {
    const fs::path relative = fs::weakly_canonical(document.file).lexically_relative(fs::weakly_canonical(folder));
    return !relative.empty() && *relative.begin() != "..";
  }
  void begin();
  void go_on(const std::optional<DatasetInfo>& before, bool repairs);
  void write_plan(bool tells);
  void write_own(const std::string& name, const std::string& text, bool tells);
  void save();
  void save_some();
  void restore_documents();
  void check_files();
  void drop_arrays();
  void remove_strangers(const std::unordered_set<std::string>& known);
  void look(bool reads_all, Progress& progress);
  void look_at(std::uint64_t table, bool reads_all, FoundInTable& found_there, Progress& progress) const;
  void take_rows(const TableRows& rows, bool reads_all, FoundInTable& found_there, Progress& progress) const;
  void tell_error(std::string error) {
    ++error_count;
    if (errors.size() < kErrorsTold) errors.push_back(std::move(error));
  }
  void tell_failure(std::string failure) {
    ++failed;
    if (failures.size() < kFailuresTold) failures.push_back(std::move(failure));
  }
  std::uint64_t end_of(std::uint64_t table) const { return std::min(info.plants, (table + 1) * info.rows); }
  void merge(std::uint64_t table);
  void adopt(std::uint64_t table, bool tells);
};

void DatasetFolder::State::check_same(const DatasetInfo& before, bool repairs) const {
  if (before.plan != info.plan || before.plants != info.plants || before.rows != info.rows) {
    const bool is_edited = !plan.documents.empty() && is_own(plan.documents.front());
    if (is_edited && repairs) throw not_repaired(folder, "plan.json and its copy in checks/ have changed");
    throw refused(fmt::format("the folder holds a data set of another plan: {}{} plants",
                              before.name.empty() ? "" : "'" + before.name + "', ", before.plants),
                  is_edited ? fmt::format("plan.json as it was, which meristem dataset {} --repair puts back", folder)
                            : "that plan, which is plan.json in the folder, or another folder",
                  folder);
  }
  for (std::size_t k = 0; k < info.documents.size() && k < before.documents.size(); ++k) {
    if (before.documents[k].is_same(info.documents[k])) continue;
    const std::string what = fmt::format(
        "the document '{}' or a file that it names has changed since the data set was begun", info.documents[k].name);
    if (is_own(plan.documents[k])) {
      if (repairs) throw not_repaired(folder, what);
      throw refused(what, fmt::format("the plan that it was begun with: meristem dataset PLAN -o {} --repair", folder),
                    folder);
    }
    throw refused(what,
                  fmt::format("the document as it was, which lies in {}, or another folder",
                              (fs::path(documents_path(folder)) / before.documents[k].name).string()),
                  folder);
  }
  if (before.documents.size() != info.documents.size()) {
    throw refused("the folder holds a data set of other documents", "another folder", folder);
  }
}

/// Compares plan and documents with the hashes in checks/. Needed if dataset.json has changed.
void DatasetFolder::State::check_hashes_are_of_this(bool is_known_otherwise) const {
  bool is_known = is_known_otherwise;
  for (std::uint64_t table = 0; table < info.table_count(); ++table) {
    const auto hashes = read_table_hashes(folder, table);
    if (!hashes) continue;
    bool are_same = hashes->plan == info.plan && hashes->documents.size() == info.documents.size();
    for (std::size_t k = 0; are_same && k < info.documents.size(); ++k) {
      are_same = hashes->documents[k] == std::pair(info.documents[k].name, info.documents[k].hash);
    }
    if (!are_same) {
      throw not_repaired(folder, fmt::format("dataset.json has changed, and {} is of another plan or other documents",
                                             table_hashes_path(folder, table)));
    }
    is_known = true;
  }
  const bool are_own = !plan.documents.empty() && is_own(plan.documents.front());
  if (!is_known && are_own) {
    throw not_repaired(folder, "dataset.json has changed, and no table tells what the plan and the documents were");
  }
}

void DatasetFolder::State::begin() {
  // dataset.json is written last: a folder without it is not yet a data set.
  unpack_documents(plan, documents_path(folder));
  known = info;
  write_plan(false);
  write_whole_file(dataset_info_path(folder), dataset_info_text(info));
}

/// Loads the state of a data set that was begun.
void DatasetFolder::State::go_on(const std::optional<DatasetInfo>& before, bool repairs) {
  known = info;
  known.is_as_written = false;  // then only the hashes of tables count
  if (before) {
    info.version = before->version;
    if (before->is_as_written && before->format == kDatasetFormat) {
      known = *before;
      info.files = before->files;
    }
  }
  if (before && before->is_as_written && before->format < kDatasetFormat) {
    // The format is written first, so that a folder with checks/ always has the later format.
    info.files[kFolderPlanName] = text_hash(folder_plan_text(plan));
    save();
  }
  if (repairs && (!before || !before->is_as_written)) {
    tell_error(fmt::format("{} had changed", dataset_info_path(folder)));
  }
  if (repairs) restore_documents();
  write_plan(repairs && known.is_as_written);
  if (repairs) check_files();
}

/// Writes a file whose content the program knows, unless the file already has it. A repair reports that the file had
/// changed.
void DatasetFolder::State::write_own(const std::string& name, const std::string& text, bool tells) {
  const auto content = whole_file(path(name));
  if (content == text) return;
  if (tells) tell_error(fmt::format("{} {}", path(name), content ? "had changed" : "was missing"));
  make_folders(fs::path(path(name)).parent_path().string());
  write_whole_file(path(name), text);
}

void DatasetFolder::State::write_plan(bool tells) {
  const std::string text = folder_plan_text(plan);
  write_own(kPlanCopyName, text, tells);
  write_own(kFolderPlanName, text, tells);
  info.files[kFolderPlanName] = text_hash(text);
}

void DatasetFolder::State::save() {
  const std::string text = dataset_info_text(info);
  if (whole_file(dataset_info_path(folder)) != text) write_whole_file(dataset_info_path(folder), text);
  std::error_code ignored;
  for (const std::uint64_t table : pending) {
    for (const std::string& file : parts[table]) fs::remove(file, ignored);
    parts.erase(table);
  }
  pending.clear();
}

/// Saves dataset.json once enough tables are new, so that a set of many tables does not write it for each table.
void DatasetFolder::State::save_some() {
  const auto hashes = static_cast<std::uint64_t>(
      std::count_if(info.tables.begin(), info.tables.end(), [](const std::string& hash) { return !hash.empty(); }));
  if (pending.size() * kTablesPerSave >= hashes) save();
}

/// Restores the original documents and removes everything else in their folder.
void DatasetFolder::State::restore_documents() {
  const fs::path documents(documents_path(folder));
  std::set<std::string> own_files;
  for (const PlannedDocument& document : plan.documents) {
    for (const auto& [path, content] : document.bundle.files) {
      const fs::path own = (fs::path(document.name) / path).lexically_normal();
      own_files.insert(own.generic_string());
      if (whole_file((documents / own).string()) == content) continue;
      tell_error(fmt::format("{} was missing or had changed", (documents / own).string()));
    }
  }
  std::vector<std::string> strangers;
  each_file_below(documents.string(), [&](const std::string& path, bool is_left_over) {
    if (own_files.contains(path)) return;
    strangers.push_back((documents / path).string());
    if (!is_left_over) tell_error(fmt::format("{} belonged to no document and was removed", strangers.back()));
  });
  for (const std::string& stranger : strangers) fs::remove(stranger);
  unpack_documents(plan, documents.string());
}

/// Reports files of dataset.json other than the plan that have changed. The data card is rewritten at the end.
void DatasetFolder::State::check_files() {
  for (auto file = info.files.begin(); file != info.files.end();) {
    const auto content = whole_file(path(file->first));
    if (file->first == kFolderPlanName || (content && text_hash(*content) == file->second)) {
      ++file;
      continue;
    }
    const bool is_card = file->first == kDataCardName;
    tell_error(fmt::format("{} {}{}", path(file->first), content ? "had changed" : "was missing",
                           is_card ? "" : "; meristem.dataset in Python writes it again from the tables"));
    std::error_code ignored;
    fs::remove(path(file->first), ignored);
    file = info.files.erase(file);
  }
  for (const std::string& stranger : strange_tables(info, folder)) {
    tell_error(fmt::format("{} belonged to no table and was removed", stranger));
    fs::remove(stranger);
  }
}

/// Removes the arrays that Python has made from the tables, because a table has changed.
void DatasetFolder::State::drop_arrays() {
  for (auto file = info.files.begin(); file != info.files.end();) {
    if (file->first == kFolderPlanName || file->first == kDataCardName) {
      ++file;
      continue;
    }
    std::error_code ignored;
    fs::remove(path(file->first), ignored);
    file = info.files.erase(file);
  }
}

/// Removes the files below plants/ that are in no row.
void DatasetFolder::State::remove_strangers(const std::unordered_set<std::string>& known_paths) {
  const fs::path root(folder);
  std::vector<std::string> strangers;
  each_file_below((root / "plants").string(), [&](const std::string& path, bool is_left_over) {
    if (known_paths.contains("plants/" + path)) return;
    strangers.push_back((root / "plants" / path).string());
    if (!is_left_over) tell_error(fmt::format("{} belonged to no row and was removed", strangers.back()));
  });
  for (const std::string& stranger : strangers) fs::remove(stranger);
}

/// Adds the facts of the rows of a file to the facts of its table.
void DatasetFolder::State::take_rows(const TableRows& rows, bool reads_all, FoundInTable& found_there,
                                     Progress& progress) const {
  found_there.errors.insert(found_there.errors.end(), rows.errors.begin(), rows.errors.end());
  std::vector<std::optional<std::string>> row_errors = errors_of_rows(rows.rows, folder, reads_all, progress);
  for (std::size_t row = 0; row < rows.rows.size(); ++row) {
    const ManifestEntry& entry = rows.rows[row].entry;
    if (reads_all) {
      for (const PlantFile& file : entry.files) found_there.paths.push_back(file.path);
    }
    if (row_errors[row]) {
      found_there.errors.push_back(std::move(*row_errors[row]));
    } else if (rows.rows[row].is_right) {
      found_there.plants.push_back(entry.number);
      if (!entry.error.empty()) found_there.failures.push_back(failure_of(rows.rows[row]));
    }
  }
}

/// Examines the file of a table and the parts with its rows.
void DatasetFolder::State::look_at(std::uint64_t table, bool reads_all, FoundInTable& found_there,
                                   Progress& progress) const {
  std::error_code error;
  const bool is_table = fs::exists(manifest_path(folder, table), error);
  if (is_table) {
    take_rows(check_table_rows(knowledge(), table), reads_all, found_there, progress);
    found_there.is_whole = found_there.errors.empty();
  } else if (known.is_as_written && table < known.tables.size() && !known.tables[table].empty()) {
    found_there.errors.push_back(fmt::format("{} was missing", manifest_path(folder, table)));
  }
  const auto own = parts.find(table);
  if (own == parts.end()) return;
  for (const std::string& part : own->second) {
    take_rows(check_part_rows(knowledge(), part, table), reads_all, found_there, progress);
  }
}

void DatasetFolder::State::look(bool reads_all, Progress& progress) {
  const fs::path root(folder);
  // Removes files of unfinished plants. Another program may still be making plants that this one had requested.
  std::error_code ignored;
  for (const fs::directory_entry& left : fs::directory_iterator(root / "partial" / "plants", ignored)) {
    remove_left_over(left.path().string(), WithoutLocks::remove);
  }

  parts = row_parts(info, folder);
  const std::uint64_t tables = info.table_count();
  std::vector<FoundInTable> in_tables(tables);
  progress.begin(reads_all ? "reading what is there" : "looking at what is there", info.plants);
  parallel_for(tables, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t table = begin; table < end; ++table) {
      progress.check();
      look_at(table, reads_all, in_tables[table], progress);
    }
  });

  if (reads_all) {
    std::unordered_set<std::string> known_paths;
    for (FoundInTable& in_table : in_tables) {
      known_paths.insert(std::make_move_iterator(in_table.paths.begin()),
                         std::make_move_iterator(in_table.paths.end()));
    }
    remove_strangers(known_paths);
  }
  is_there.assign(info.plants, false);
  std::vector<std::uint64_t> unmerged;
  std::vector<std::uint64_t> whole;
  for (std::uint64_t table = 0; table < tables; ++table) {
    for (std::string& error : in_tables[table].errors) tell_error(std::move(error));
    std::uint32_t left = static_cast<std::uint32_t>(end_of(table) - table * info.rows);
    for (const std::uint64_t plant : in_tables[table].plants) {
      if (is_there[plant]) continue;
      is_there[plant] = true;
      ++there;
      --left;
    }
    missing.push_back(left);
    // Either all rows of a table exist but the table was not written yet, or the table has lines that are no rows.
    if (left == 0 && in_tables[table].is_whole) {
      for (std::string& failure : in_tables[table].failures) tell_failure(std::move(failure));
      whole.push_back(table);
    } else if (left == 0) {
      unmerged.push_back(table);
    }
  }
  for (const std::uint64_t table : whole) adopt(table, reads_all);
  // From here on a table without its hash is known to be incomplete, whatever is interrupted later.
  if (whole.size() < tables) info.files.erase(kDataCardName);
  save();
  for (const std::uint64_t table : unmerged) merge(table);
  save();
  found = there;
}

/// Accepts the hash of a complete table, and writes its hashes if they are missing.
void DatasetFolder::State::adopt(std::uint64_t table, bool tells) {
  const std::string known_hash = known_table_hash(known, folder, table);
  const auto hashes = read_table_hashes(folder, table);
  info.tables[table] = known_hash;
  if (hashes && hashes->table == known_hash) return;
  const std::string text = whole_file(manifest_path(folder, table)).value_or("");
  const TableHashes made = hashes_of_table(info, text);
  const std::string path = table_hashes_path(folder, table);
  if (tells && !known_hash.empty()) tell_error(fmt::format("{} was missing or had changed", path));
  make_folders(fs::path(path).parent_path().string());
  write_whole_file(path, table_hashes_text(made));
  info.tables[table] = made.table;
}

void DatasetFolder::State::merge(std::uint64_t table) {
  std::map<std::uint64_t, TableRow> rows;
  const Progress progress;
  const auto take = [&](TableRows read) {
    for (TableRow& row : read.rows) {
      if (!row.is_right) continue;
      const auto [known_row, is_new] = rows.try_emplace(row.entry.number, row);
      if (is_new || known_row->second.line == row.line) continue;
      // A plant that was made again also has an older row, which does not describe its present files.
      if (error_of_files(known_row->second.entry, folder, true, progress)) known_row->second = std::move(row);
    }
  };
  for (const std::string& part : parts[table]) take(check_part_rows(knowledge(), part, table));
  const std::string path = manifest_path(folder, table);
  std::error_code error;
  if (fs::exists(path, error)) take(check_table_rows(knowledge(), table));
  std::string text = manifest_header(plan);
  std::uint64_t number = table * info.rows;
  for (const auto& [key, row] : rows) {
    if (key != number) break;
    text += row.line + "\n";
    ++number;
  }
  if (number != end_of(table)) {
    throw MachineError(
        fmt::format("'{}' cannot be written: the row of the plant {} has gone from the folder", path, number));
  }
  for (const auto& [key, row] : rows) {
    if (!row.entry.error.empty()) tell_failure(failure_of(row));
  }
  const TableHashes hashes = hashes_of_table(info, text);
  if (known.is_as_written && table < known.tables.size() && known.tables[table] != hashes.table) drop_arrays();
  make_folders(fs::path(path).parent_path().string());
  make_folders(fs::path(table_hashes_path(folder, table)).parent_path().string());
  write_whole_file(table_hashes_path(folder, table), table_hashes_text(hashes));
  write_whole_file(path, text);
  info.tables[table] = hashes.table;
  pending.push_back(table);
  save_some();
}

DatasetFolder::DatasetFolder(const DatasetPlan& plan, std::string folder, DatasetOpening opening, Progress& progress)
    : state_(std::make_unique<State>(plan, std::move(folder))) {
  State& state = *state_;
  const fs::path root(state.folder);
  const bool repairs = opening == DatasetOpening::repair;
  std::error_code error;
  std::optional<DatasetInfo> before;
  bool is_damaged = false;
  try {
    before = read_dataset_info(state.folder);
  } catch (const InputError&) {
    if (!repairs) throw;
    is_damaged = true;
  }
  if (before && opening == DatasetOpening::fresh) {
    throw refused(fmt::format("the folder holds a data set already: {} plants", before->plants),
                  "an empty folder, or to go on with that data set", state.folder);
  }
  if (before && !before->is_as_written && !repairs) {
    throw refused("dataset.json has changed since it was written",
                  fmt::format("dataset.json as it was, which meristem dataset {} --repair puts back", state.folder),
                  state.folder);
  }
  if (before && before->is_as_written) {
    state.check_same(*before, repairs);
  } else if (before || is_damaged) {
    bool is_same = before && before->plan == state.info.plan && before->documents.size() == state.info.documents.size();
    for (std::size_t k = 0; is_same && k < state.info.documents.size(); ++k) {
      is_same = before->documents[k].is_same(state.info.documents[k]);
    }
    state.check_hashes_are_of_this(is_same);
  } else if (fs::exists(root, error)) {
    if (!fs::is_directory(root, error)) throw refused("this is a file", "a folder", state.folder);
    // An interrupted start has left only these files. A repair also restores a missing dataset.json.
    bool has_tables = false;
    for (const fs::directory_entry& entry : fs::directory_iterator(root, error)) {
      const std::string name = entry.path().filename().string();
      const bool is_begun = std::find(kBegun.begin(), kBegun.end(), name) != kBegun.end() || name == kChecksName;
      const bool is_own = std::find(kOwnNames.begin(), kOwnNames.end(), name) != kOwnNames.end();
      has_tables = has_tables || !is_begun;
      if (is_begun || is_temporary_name(name) || (repairs && is_own)) continue;
      throw refused(fmt::format("the folder holds '{}' and no data set", name), "an empty folder", state.folder);
    }
    if (has_tables) state.check_hashes_are_of_this(false);
    is_damaged = has_tables;
  }
  make_folders(state.folder);
  state.lock = std::make_unique<FolderLock>(root);
  if (!before && !is_damaged) {
    state.begin();
  } else {
    state.go_on(before, repairs);
  }
  state.look(repairs, progress);
}

DatasetFolder::~DatasetFolder() = default;

const std::string& DatasetFolder::path() const { return state_->folder; }
std::uint64_t DatasetFolder::total() const { return state_->info.plants; }
std::uint64_t DatasetFolder::done() const { return state_->there; }
std::uint64_t DatasetFolder::found() const { return state_->found; }
const std::vector<std::string>& DatasetFolder::errors() const { return state_->errors; }
std::uint64_t DatasetFolder::error_count() const { return state_->error_count; }
std::uint64_t DatasetFolder::failed() const { return state_->failed; }
const std::vector<std::string>& DatasetFolder::failures() const { return state_->failures; }

std::string DatasetFolder::failed_text() const {
  const State& state = *state_;
  if (state.failed == 0) return "";
  std::string text = fmt::format("{} of {} plants written, {} failed: {}", state.info.plants - state.failed,
                                 state.info.plants, state.failed, state.failures.front());
  if (state.failed > 1) text += fmt::format("; {} more in the column 'error' of the manifest", state.failed - 1);
  return text;
}

std::optional<PlantRange> DatasetFolder::next(double seconds) {
  State& state = *state_;
  while (state.given < state.info.plants && state.is_there[state.given]) ++state.given;
  if (state.given >= state.info.plants) return std::nullopt;
  // Until the first range is done, the time per plant is unknown.
  const double wanted = state.seconds > 0 ? seconds / state.seconds : 1;
  // At most twice the largest range so far, because the first plants may have been fast by chance.
  const std::uint64_t limit = std::clamp<std::uint64_t>(2 * state.largest, 1, kMaxInRange);
  const auto max = static_cast<std::uint64_t>(std::clamp(wanted, 1.0, static_cast<double>(limit)));
  const std::uint64_t last = std::min(state.end_of(state.given / state.info.rows), state.given + max);
  PlantRange range{state.given, state.given + 1};
  while (range.end < last && !state.is_there[range.end]) ++range.end;
  state.given = range.end;
  return range;
}

void DatasetFolder::add(PlantRange range, double seconds) {
  State& state = *state_;
  const double each = seconds / static_cast<double>(std::max<std::uint64_t>(1, range.count()));
  state.seconds = state.seconds > 0 ? (1 - kNewShare) * state.seconds + kNewShare * each : each;
  state.largest = std::max(state.largest, range.count());
  const std::uint64_t table = range.begin / state.info.rows;
  state.parts[table].push_back(rows_path(state.folder, range));
  for (std::uint64_t plant = range.begin; plant < range.end; ++plant) {
    if (state.is_there[plant]) continue;
    state.is_there[plant] = true;
    ++state.there;
    --state.missing[table];
  }
  if (state.missing[table] == 0) state.merge(table);
}

void DatasetFolder::finish(Progress& progress) {
  State& state = *state_;
  const fs::path root(state.folder);
  const std::string card = data_card(state.plan, state.folder, progress);
  state.write_own(kDataCardName, card, false);
  state.info.files[kDataCardName] = text_hash(card);
  state.save();
  std::error_code ignored;
  fs::remove_all(root / "partial" / "rows", ignored);
  for (const fs::directory_entry& left : fs::directory_iterator(root / "partial" / "plants", ignored)) {
    remove_left_over(left.path().string(), WithoutLocks::remove);
  }
  fs::remove(root / "partial" / "plants", ignored);
}

void DatasetFolder::add_file(const std::string& name) {
  State& state = *state_;
  const std::optional<std::string> content = whole_file(state.path(name));
  if (!content) throw MachineError(fmt::format("cannot read '{}'", state.path(name)));
  state.info.files[name] = text_hash(*content);
  state.save();
}

}  // namespace meristem
