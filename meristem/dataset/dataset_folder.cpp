// SPDX-License-Identifier: Apache-2.0
// A table of the manifest is written once all of its rows are there, in the order of the plants; until then they lie in
// files of their own. All of these files, and those of plants, appear by renaming, and each plant's row after its
// files. So whatever is cut off, rows tell what is there; and tables do not depend on who made which plant, or when.
#include "meristem/dataset/dataset_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/parallel.h"
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

void put_file(const fs::path& path, const std::string& text) {
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) {
    throw MachineError(fmt::format("cannot make the folder '{}': {}", path.parent_path().string(), error.message()));
  }
  AtomicFile file(path.string());
  file.write(text);
  file.commit();
}

/// Keeps other programs out of a folder while it lives, and goes with its process whatever ends it.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder) {
    const std::string path = (folder / "partial" / "lock").string();
    std::error_code error;
    fs::create_directories(folder / "partial", error);
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
  void begin();
  void look(bool reads_all, Progress& progress);
  void look_at(const std::string& path, std::uint64_t table, bool reads_all, std::vector<std::string>& found_faults,
               std::vector<std::uint64_t>& found_plants) const;
  void tell_fault(std::string fault) {
    ++fault_count;
    if (faults.size() < kFaultsTold) faults.push_back(std::move(fault));
  }
  std::uint64_t end_of(std::uint64_t table) const { return std::min(info.plants, (table + 1) * info.rows); }
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
                  fmt::format("the document as it was, which lies in {}, or another folder",
                              (fs::path(folder) / "documents" / before.documents[k].name).string()),
                  folder);
  }
  if (before.documents.size() != info.documents.size()) {
    throw refused("the folder holds a data set of other documents", "another folder", folder);
  }
}

void DatasetFolder::State::begin() {
  // What it is comes last: a folder without it is not yet a data set.
  const fs::path root(folder);
  unpack_documents(plan, (root / "documents").string());
  put_file(root / "plan.json", folder_plan_text(plan));
  put_file(root / "dataset.json", dataset_info_text(info));
}

/// What the rows of a file tell of plants of a table.
void DatasetFolder::State::look_at(const std::string& path, std::uint64_t table, bool reads_all,
                                   std::vector<std::string>& found_faults,
                                   std::vector<std::uint64_t>& found_plants) const {
  const RowsOfFile rows = read_manifest_rows(path, manifest_header(plan));
  for (const std::string& fault : rows.faults) found_faults.push_back(fault);
  for (const auto& [entry, line] : rows.rows) {
    if (entry.number < table * info.rows || entry.number >= end_of(table)) {
      found_faults.push_back(fmt::format("{}: the plant {} belongs to another table", path, entry.number));
      continue;
    }
    const std::optional<std::string> fault = fault_of_files(entry, folder, reads_all);
    if (fault) {
      found_faults.push_back(*fault);
    } else {
      found_plants.push_back(entry.number);
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
  std::vector<std::vector<std::string>> table_faults(tables);
  std::vector<std::vector<std::uint64_t>> table_plants(tables);
  progress.begin(reads_all ? "reading what is there" : "looking at what is there", tables);
  parallel_for(tables, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t table = begin; table < end; ++table) {
      progress.advance();
      std::vector<std::string> files;
      std::error_code error;
      if (const std::string whole = manifest_path(folder, table); fs::exists(whole, error)) files.push_back(whole);
      if (const auto own = parts.find(table); own != parts.end()) {
        files.insert(files.end(), own->second.begin(), own->second.end());
      }
      for (const std::string& file : files) look_at(file, table, reads_all, table_faults[table], table_plants[table]);
    }
  });

  is_there.assign(info.plants, false);
  for (std::uint64_t table = 0; table < tables; ++table) {
    for (std::string& fault : table_faults[table]) tell_fault(std::move(fault));
    std::uint32_t left = static_cast<std::uint32_t>(end_of(table) - table * info.rows);
    for (const std::uint64_t plant : table_plants[table]) {
      if (is_there[plant]) continue;
      is_there[plant] = true;
      ++there;
      --left;
    }
    missing.push_back(left);
    // All rows of a table were there, but the table was not written yet; or it has rows that are no rows.
    std::error_code error;
    const bool is_whole = fs::exists(manifest_path(folder, table), error) && table_faults[table].empty();
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
  std::map<std::uint64_t, std::string> lines;
  for (const std::string& file : files) {
    RowsOfFile rows = read_manifest_rows(file, header);
    for (auto& [entry, line] : rows.rows) lines.try_emplace(entry.number, std::move(line));
  }
  std::string text = header;
  std::uint64_t number = table * info.rows;
  for (const auto& [key, line] : lines) {
    if (key != number) break;
    text += line + "\n";
    ++number;
  }
  if (number != end_of(table)) {
    throw MachineError(
        fmt::format("'{}' cannot be written: the row of the plant {} has gone from the folder", path, number));
  }
  put_file(path, text);
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
      if (name == "documents" || name == "plan.json" || name == "partial") continue;
      throw refused(fmt::format("the folder holds '{}' and no data set", name), "an empty folder", state.folder);
    }
  }
  fs::create_directories(root, error);
  if (error) throw MachineError(fmt::format("cannot make the folder '{}': {}", state.folder, error.message()));
  state.lock = std::make_unique<FolderLock>(root);
  if (!before) state.begin();
  state.look(opening == DatasetOpening::repair, progress);
}

DatasetFolder::~DatasetFolder() = default;

const std::string& DatasetFolder::path() const { return state_->folder; }
std::uint64_t DatasetFolder::total() const { return state_->info.plants; }
std::uint64_t DatasetFolder::done() const { return state_->there; }
std::uint64_t DatasetFolder::found() const { return state_->found; }
const std::vector<std::string>& DatasetFolder::faults() const { return state_->faults; }
std::uint64_t DatasetFolder::fault_count() const { return state_->fault_count; }
double DatasetFolder::seconds_per_plant() const { return state_->seconds; }

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
  put_file(root / "README.md", data_card(state.plan, state.folder, progress));
  std::error_code ignored;
  fs::remove_all(root / "partial" / "rows", ignored);
  fs::remove_all(root / "partial" / "plants", ignored);
}

}  // namespace meristem
