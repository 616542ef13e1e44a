// SPDX-License-Identifier: Apache-2.0
// Each open file has a mark: a locked file in a private folder, whose name begins with a hash of the path. Another page
// counts the marks that are locked and removes the others, which a killed program has left.
#include "open_files.h"

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "meristem/document/json.h"
#include "text_units.h"

namespace meristem::studio {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kMarkInterval{2};

/// Returns the private folder of this user's marks, or an empty text if it is impossible.
std::string folder_of_marks() {
  std::error_code error;
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  const fs::path above = runtime != nullptr && *runtime == '/' ? fs::path(runtime) : fs::temp_directory_path(error);
  if (error) return {};
  const std::string folder = (above / fmt::format("meristem-open-{}", ::getuid())).string();
  ::mkdir(folder.c_str(), 0700);
  // A folder that another user has made is not used.
  struct stat status {};
  const bool is_own = ::lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == ::getuid() &&
                      (status.st_mode & 077) == 0;
  return is_own ? folder : std::string();
}

}  // namespace

OpenFile::OpenFile(const std::string& path) : folder_(folder_of_marks()), prefix_(text_hash(path) + "-") {
  static std::atomic<unsigned> count{0};
  if (folder_.empty()) return;
  mark_ = fmt::format("{}{}-{}", prefix_, ::getpid(), count++);
  // The mark gets its name after it is locked, so that no other page takes it for an old mark.
  const std::string draft = (fs::path(folder_) / ("." + mark_)).string();
  descriptor_ = ::open(draft.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  const bool is_marked = descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 &&
                         std::rename(draft.c_str(), (fs::path(folder_) / mark_).c_str()) == 0;
  if (!is_marked) mark_.clear();
}

OpenFile::~OpenFile() {
  std::error_code ignored;
  if (!mark_.empty()) fs::remove(fs::path(folder_) / mark_, ignored);
  if (descriptor_ >= 0) ::close(descriptor_);
}

int OpenFile::others() const {
  if (mark_.empty()) return 0;
  int count = 0;
  std::error_code error;
  for (fs::directory_iterator entry(folder_, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(prefix_) || name == mark_) continue;
    const int other = ::open(entry->path().c_str(), O_RDONLY | O_CLOEXEC);
    if (other < 0) continue;
    std::error_code ignored;
    if (::flock(other, LOCK_SH | LOCK_NB) != 0) {
      ++count;
    } else {
      fs::remove(entry->path(), ignored);
    }
    ::close(other);
  }
  return count;
}

OpenFileWatch::OpenFileWatch(Host& host, std::shared_ptr<Outbox> outbox, const std::string& path)
    : host_(host), outbox_(std::move(outbox)), path_(path), file_(host.root.absolute(path)) {}

OpenFileWatch::~OpenFileWatch() {
  if (count_ > 0) send(0);
}

void OpenFileWatch::look() {
  if (const int count = file_.others(); count != std::exchange(count_, count)) send(count);
  host_.stills.post_at(Worker::Clock::now() + kMarkInterval, [watch = weak_from_this()] {
    if (const auto still = watch.lock()) still->look();
  });
}

void OpenFileWatch::send(int count) {
  outbox_->send_text(write_json_line(Value::Object{{"is", "elsewhere"}, {"path", path_}, {"count", count}}));
}

}  // namespace meristem::studio
