// SPDX-License-Identifier: Apache-2.0
// A table of the manifest is written once all of its rows are there, in the order of the plants; until then they lie in
// files of their own. All of these files, and those of plants, appear by renaming, and each plant's row after its
// files. So whatever is cut off, rows tell what is there; and tables do not depend on who made which plant, or when.
#include "meristem/dataset/dataset_folder.h"

#include <algorithm>
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

#include "meristem/base/parallel.h"
#include "meristem/base/whole_file.h"
#include "meristem/dataset/data_card.h"
#include "meristem/dataset/dataset_info.h"
#include "meristem/dataset/manifest.h"
#include "meristem/dataset/verify_dataset.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFaultsTold = 100;
constexpr std::uint64_t kMostInRange = 1000;  // plants
constexpr double kNewShare = 0.3;             // of the last range in the mean of the times

InputError refused(std::string message, std::string expected, const std::string& folder) {
  return InputError(Diagnostic{.message = std::move(message), .expected = std::move(expected), .file = folder});
}

/// Keeps other programs out of a folder while it lives, and goes with its process whatever ends it.
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
    // Some file systems have no locks; there two programs at once are the user's care.
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

/// What the files with rows of a table tell.
struct FoundInTable {
  std::vector<std::string> faults;
  std::vector<std::uint64_t> plants;  // that are there
  std::vector<std::string> paths;     // of the files of all rows
};

}  // namespace

struct DatasetFolder::State {
  State(const DatasetPlan& the_plan, std::string path) : plan(the_plan), folder(std::move(path)), info(info_of(plan)) {}

  const DatasetPlan& plan;
  const std::string folder;
  const DatasetInfo info;
  std::unique_ptr<FolderLock> lock;
  std::vector<bool> is_there;                               // of each plant
  std::vector<std::uint32_t> missing;                       // plants of each table
  std::map<std::uint64_t, std::vector<std::string>> parts;  // files with rows of each table that is not whole
  std::uint64_t there = 0;
  std::uint64_t found = 0;
  std::uint64_t given = 0;    // all before it were given or are there
  double seconds = 0;         // that a plant takes, of late
  std::uint64_t largest = 0;  // range that was made
  std::vector<std::string> faults;
  std::uint64_t fault_count = 0;

  void check_same(const DatasetInfo& before) const;
  /// Whether a document was read from the folder itself.
  bool is_own(const PlannedDocument& document) const {
    const fs::path relative = fs::weakly_canonical(document.file).lexically_relative(fs::weakly_canonical(folder));
    return !relative.empty() && *relative.begin() != "..";
  }
  void begin();
  void restore_documents();
  void remove_strangers(const std::unordered_set<std::string>& known);
  void look(bool reads_all, Progress& progress);
  void look_at(const std::string& path, std::uint64_t table, bool reads_all, FoundInTable& found_there,
               Progress& progress) const;
  void tell_fault(std::string fault) {
    ++fault_count;
    if (faults.size() < kFaultsTold) faults.push_back(std::move(fault));
  }
  std::uint64_t end_of(std::uint64_t table) const { return std::min(info.plants, (table + 1) * info.rows); }
  bool is_in(std::uint64_t plant, std::uint64_t table) const {
    return plant >= table * info.rows && plant < end_of(table);
  }
  void merge(std::uint64_t table);
};

void DatasetFolder::State::check_same(const DatasetInfo& before) const {
  if (before.plan != info.plan || before.plants != info.plants || before.rows != info.rows) {
    throw refused(fmt::format("the folder holds a data set of another plan: {}{} plants",
                              before.name.empty() ? "" : "'" + before.name + "', ", before.plants),
                  "that plan, which is plan.json in the folder, or another folder", folder);
  }
  for (std::size_t k = 0; k < info.documents.size() && k < before.documents.size(); ++k) {
    if (before.documents[k] == info.documents[k]) continue;
    throw refused(fmt::format("the document '{}' or a file that it names has changed since the data set was begun",
                              info.documents[k].name),
                  is_own(plan.documents[k])
                      ? fmt::format("the plan that it was begun with: meristem dataset PLAN -o {} --repair", folder)
                      : fmt::format("the document as it was, which lies in {}, or another folder",
                                    (fs::path(documents_path(folder)) / before.documents[k].name).string()),
                  folder);
  }
  if (before.documents.size() != info.documents.size()) {
    throw refused("the folder holds a data set of other documents", "another folder", folder);
  }
}

void DatasetFolder::State::begin() {
  // What it is comes last: a folder without it is not yet a data set.
  unpack_documents(plan, documents_path(folder));
  write_whole_file(folder_plan_path(folder), folder_plan_text(plan));
  write_whole_file(dataset_info_path(folder), dataset_info_text(info));
}

/// The documents and the plan as they were, and nothing besides.
void DatasetFolder::State::restore_documents() {
  const fs::path documents(documents_path(folder));
  std::set<std::string> known;
  for (const PlannedDocument& document : plan.documents) {
    for (const auto& [path, content] : document.bundle.files) {
      const fs::path own = (fs::path(document.name) / path).lexically_normal();
      known.insert(own.generic_string());
      if (whole_file((documents / own).string()) == content) continue;
      tell_fault(fmt::format("{} was missing or had changed", (documents / own).string()));
    }
  }
  std::vector<std::string> strangers;
  each_file_below(documents.string(), [&](const std::string& path, bool is_left_over) {
    if (known.contains(path)) return;
    strangers.push_back((documents / path).string());
    if (!is_left_over) tell_fault(fmt::format("{} belonged to no document and was removed", strangers.back()));
  });
  for (const std::string& stranger : strangers) fs::remove(stranger);
  unpack_documents(plan, documents.string());
  if (whole_file(folder_plan_path(folder)) != folder_plan_text(plan)) {
    write_whole_file(folder_plan_path(folder), folder_plan_text(plan));
  }
}

/// Removes the files below plants/ that no row knows.
void DatasetFolder::State::remove_strangers(const std::unordered_set<std::string>& known) {
  const fs::path root(folder);
  std::vector<std::string> strangers;
  each_file_below((root / "plants").string(), [&](const std::string& path, bool is_left_over) {
    if (known.contains("plants/" + path)) return;
    strangers.push_back((root / "plants" / path).string());
    if (!is_left_over) tell_fault(fmt::format("{} belonged to no row and was removed", strangers.back()));
  });
  for (const std::string& stranger : strangers) fs::remove(stranger);
}

/// What the rows of a file tell of plants of a table.
void DatasetFolder::State::look_at(const std::string& path, std::uint64_t table, bool reads_all,
                                   FoundInTable& found_there, Progress& progress) const {
  const RowsOfFile rows = read_manifest_rows(path, manifest_header(plan));
  found_there.faults.insert(found_there.faults.end(), rows.faults.begin(), rows.faults.end());
  std::vector<std::optional<std::string>> row_faults = faults_of_rows(rows, folder, reads_all, progress);
  for (std::size_t row = 0; row < rows.rows.size(); ++row) {
    const ManifestEntry& entry = rows.rows[row].first;
    if (!is_in(entry.number, table)) {
      found_there.faults.push_back(fmt::format("{}: the plant {} belongs to another table", path, entry.number));
      continue;
    }
    if (reads_all) {
      for (const PlantFile& file : entry.files) found_there.paths.push_back(file.path);
    }
    if (row_faults[row]) {
      found_there.faults.push_back(std::move(*row_faults[row]));
    } else {
      found_there.plants.push_back(entry.number);
    }
  }
}

void DatasetFolder::State::look(bool reads_all, Progress& progress) {
  const fs::path root(folder);
  // Files of plants that were not finished.
  std::error_code ignored;
  fs::remove_all(root / "partial" / "plants", ignored);

  // The rows of each table: the table itself, and parts of it.
  for (const fs::directory_entry& part : fs::directory_iterator(root / "partial" / "rows", ignored)) {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    const std::string name = part.path().filename().string();
    if (std::sscanf(name.c_str(), "%10lu-%10lu.csv", &begin, &end) != 2 || begin >= info.plants) continue;
    parts[begin / info.rows].push_back(part.path().string());
  }
  for (auto& [table, files] : parts) std::sort(files.begin(), files.end());
  const std::uint64_t tables = info.table_count();
  std::vector<FoundInTable> in_tables(tables);
  progress.begin(reads_all ? "reading what is there" : "looking at what is there", info.plants);
  parallel_for(tables, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t table = begin; table < end; ++table) {
      progress.check();
      std::vector<std::string> files;
      std::error_code error;
      if (const std::string whole = manifest_path(folder, table); fs::exists(whole, error)) files.push_back(whole);
      if (const auto own = parts.find(table); own != parts.end()) {
        files.insert(files.end(), own->second.begin(), own->second.end());
      }
      for (const std::string& file : files) look_at(file, table, reads_all, in_tables[table], progress);
    }
  });

  if (reads_all) {
    std::unordered_set<std::string> known;
    for (FoundInTable& in_table : in_tables) {
      known.insert(std::make_move_iterator(in_table.paths.begin()), std::make_move_iterator(in_table.paths.end()));
    }
    remove_strangers(known);
  }
  is_there.assign(info.plants, false);
  for (std::uint64_t table = 0; table < tables; ++table) {
    const bool has_fault = !in_tables[table].faults.empty();
    for (std::string& fault : in_tables[table].faults) tell_fault(std::move(fault));
    std::uint32_t left = static_cast<std::uint32_t>(end_of(table) - table * info.rows);
    for (const std::uint64_t plant : in_tables[table].plants) {
      if (is_there[plant]) continue;
      is_there[plant] = true;
      ++there;
      --left;
    }
    missing.push_back(left);
    // All rows of a table were there, but the table was not written yet; or it has rows that are no rows.
    std::error_code error;
    const bool is_whole = fs::exists(manifest_path(folder, table), error) && !has_fault;
    if (left == 0 && !is_whole) merge(table);
  }
  found = there;
}

void DatasetFolder::State::merge(std::uint64_t table) {
  const std::string header = manifest_header(plan);
  std::vector<std::string> files = parts[table];
  const std::string path = manifest_path(folder, table);
  std::error_code error;
  if (fs::exists(path, error)) files.push_back(path);
  std::map<std::uint64_t, std::pair<ManifestEntry, std::string>> lines;
  const Progress progress;
  for (const std::string& file : files) {
    RowsOfFile rows = read_manifest_rows(file, header);
    for (auto& row : rows.rows) {
      const std::uint64_t plant = row.first.number;
      if (!is_in(plant, table)) continue;
      const auto [known, is_new] = lines.try_emplace(plant, row);
      if (is_new || known->second.second == row.second) continue;
      // A plant that was made again has a row of before as well, which does not tell what its files hold now.
      if (fault_of_files(known->second.first, folder, true, progress)) known->second = std::move(row);
    }
  }
  std::string text = header;
  std::uint64_t number = table * info.rows;
  for (const auto& [key, row] : lines) {
    if (key != number) break;
    text += row.second + "\n";
    ++number;
  }
  if (number != end_of(table)) {
    throw MachineError(
        fmt::format("'{}' cannot be written: the row of the plant {} has gone from the folder", path, number));
  }
  make_folders(fs::path(path).parent_path().string());
  write_whole_file(path, text);
  for (const std::string& file : parts[table]) fs::remove(file, error);
  parts.erase(table);
}

DatasetFolder::DatasetFolder(const DatasetPlan& plan, std::string folder, DatasetOpening opening, Progress& progress)
    : state_(std::make_unique<State>(plan, std::move(folder))) {
  State& state = *state_;
  const fs::path root(state.folder);
  std::error_code error;
  const std::optional<DatasetInfo> before = read_dataset_info(state.folder);
  if (before && opening == DatasetOpening::fresh) {
    throw refused(fmt::format("the folder holds a data set already: {} plants", before->plants),
                  "an empty folder, or to go on with that data set", state.folder);
  }
  if (before) {
    state.check_same(*before);
  } else if (fs::exists(root, error)) {
    if (!fs::is_directory(root, error)) throw refused("this is a file", "a folder", state.folder);
    // A start that was cut off has left nothing but these.
    for (const fs::directory_entry& entry : fs::directory_iterator(root, error)) {
      const std::string name = entry.path().filename().string();
      if (name == kDocumentsName || name == kFolderPlanName || name == "partial") continue;
      throw refused(fmt::format("the folder holds '{}' and no data set", name), "an empty folder", state.folder);
    }
  }
  make_folders(state.folder);
  state.lock = std::make_unique<FolderLock>(root);
  if (!before) {
    state.begin();
  } else if (opening == DatasetOpening::repair) {
    state.restore_documents();
  }
  state.look(opening == DatasetOpening::repair, progress);
}

DatasetFolder::~DatasetFolder() = default;

const std::string& DatasetFolder::path() const { return state_->folder; }
std::uint64_t DatasetFolder::total() const { return state_->info.plants; }
std::uint64_t DatasetFolder::done() const { return state_->there; }
std::uint64_t DatasetFolder::found() const { return state_->found; }
const std::vector<std::string>& DatasetFolder::faults() const { return state_->faults; }
std::uint64_t DatasetFolder::fault_count() const { return state_->fault_count; }

std::optional<PlantRange> DatasetFolder::next(double seconds) {
  State& state = *state_;
  while (state.given < state.info.plants && state.is_there[state.given]) ++state.given;
  if (state.given >= state.info.plants) return std::nullopt;
  // Until the first one is done, nobody knows how long a plant takes.
  const double wanted = state.seconds > 0 ? seconds / state.seconds : 1;
  // Twice the largest one at most, as the first plants may have been quick by chance.
  const std::uint64_t limit = std::clamp<std::uint64_t>(2 * state.largest, 1, kMostInRange);
  const auto most = static_cast<std::uint64_t>(std::clamp(wanted, 1.0, static_cast<double>(limit)));
  const std::uint64_t last = std::min(state.end_of(state.given / state.info.rows), state.given + most);
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
  write_whole_file((root / "README.md").string(), data_card(state.plan, state.folder, progress));
  std::error_code ignored;
  fs::remove_all(root / "partial" / "rows", ignored);
  fs::remove_all(root / "partial" / "plants", ignored);
}

}  // namespace meristem
