// SPDX-License-Identifier: Apache-2.0
// Resolves paths below the root and refuses all others. A file is written to a draft in the same folder, read back, and
// renamed, so that it is complete or unchanged after any failure.
#include "root_folder.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/limits.h"
#include "meristem/base/read_file.h"
#include "meristem/base/utf8.h"
#include "meristem/base/whole_file.h"
#include "meristem/document/locate.h"
#include "meristem/graph/table/file_access.h"
#include "refusal.h"
#include "text_units.h"

namespace meristem::studio {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestPath = 1000;
constexpr std::size_t kMaxEntries = 5000;  // maximum number of entries of a folder in a list

[[noreturn]] void refuse_outside() { throw Refusal("this lies outside the folder that may be read"); }

/// Returns the mutex that is locked while a page compares a file and replaces it. No other page can then write in
/// between.
std::mutex& writing_files() {
  static std::mutex mutex;
  return mutex;
}

bool is_name(std::string_view name) { return !name.empty() && name[0] != '.' && name.find('\0') == std::string::npos; }

}  // namespace

RootFolder::RootFolder(const std::string& path) {
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  if (error || !fs::is_directory(real, error)) throw MachineError(fmt::format("'{}' is not a folder", path));
  path_ = real.string();
}

std::string RootFolder::name() const {
  const std::string name = fs::path(path_).filename().string();
  return name.empty() ? path_ : name;
}

std::string RootFolder::absolute(const std::string& relative) const {
  if (relative.empty()) return path_;
  if (relative.size() > kLongestPath) refuse_outside();
  for (std::size_t begin = 0; begin <= relative.size();) {
    const std::size_t end = std::min(relative.find('/', begin), relative.size());
    if (!is_name(std::string_view(relative).substr(begin, end - begin))) refuse_outside();
    begin = end + 1;
  }
  const std::string path = (fs::path(path_) / relative).string();
  try {
    FileAccess{.root = path_}.require_within(path);
  } catch (const InputError&) {
    refuse_outside();
  }
  return path;
}

std::optional<std::string> RootFolder::relative(const std::string& absolute) const {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(fs::absolute(absolute, error), error);
  if (error) return std::nullopt;
  const std::string path = real.lexically_relative(path_).string();
  if (path.empty() || path == "." || path.starts_with("..")) return std::nullopt;
  return path;
}

std::vector<FolderEntry> RootFolder::list(const std::string& folder) const {
  const std::string path = absolute(folder);
  std::vector<FolderEntry> entries;
  std::error_code error;
  for (fs::directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!is_name(name) || entries.size() == kMaxEntries) continue;
    try {
      FileAccess{.root = path_}.require_within(entry->path().string());  // links that lead out are not listed
    } catch (const InputError&) {
      continue;
    }
    std::error_code ignored;
    if (entry->is_directory(ignored)) {
      entries.push_back({.name = name, .is_folder = true});
    } else if (entry->is_regular_file(ignored)) {
      entries.push_back({.name = name, .bytes = entry->file_size(ignored)});
    }
  }
  if (error) throw Refusal("there is no such folder");
  std::sort(entries.begin(), entries.end(), [](const FolderEntry& a, const FolderEntry& b) { return a.name < b.name; });
  return entries;
}

std::string RootFolder::read(const std::string& file) const {
  std::string text = read_file(absolute(file), SizeLimits().document_bytes);
  const std::size_t invalid = find_invalid_utf8(text);
  if (invalid == text.size()) return text;
  const TextPosition at = text_position(text, invalid);
  throw InputError(Diagnostic{.message = fmt::format("byte 0x{:02x} in line {} (byte {} of the file) is not UTF-8 text",
                                                     static_cast<unsigned char>(text[invalid]), at.line, invalid + 1),
                              .expected = "a file that an editor has saved as UTF-8",
                              .file = file,
                              .line = at.line,
                              .column = at.column});
}

std::optional<std::string> RootFolder::hash_on_disk(const std::string& file) const {
  const std::string path = absolute(file);
  std::error_code error;
  if (!fs::exists(path, error)) return std::nullopt;
  try {
    return text_hash(read_file(path, SizeLimits().document_bytes));
  } catch (const InputError&) {
    return "";
  }
}

void RootFolder::write(const std::string& file, const std::string& text, const std::optional<std::string>& known,
                       bool over) const {
  const std::lock_guard lock(writing_files());
  if (file.empty() || !file.ends_with(".json")) throw Refusal("a document's file ends in .json");
  const std::string path = absolute(file);
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) throw Refusal("this is not a file");
  if (!over) {
    const std::optional<std::string> there = hash_on_disk(file);
    if (there != known) {
      throw Refusal(there ? "the file has been changed by somebody else" : "the file no longer exists",
                    {{"changed", true}});
    }
  }
  if (const std::size_t invalid = find_invalid_utf8(text); invalid < text.size()) {
    throw Refusal(fmt::format("the text is not UTF-8 at its byte {}; nothing was written", invalid + 1));
  }
  AtomicFile target(path);
  target.write(text);
  if (!target.holds(text)) throw Refusal("the disk gives back another text than was written; the file is as it was");
  target.commit();
}

bool RootFolder::add_file(const std::string& file, const std::string& content) const {
  const std::lock_guard lock(writing_files());
  const std::string path = absolute(file);
  std::error_code error;
  if (fs::exists(fs::symlink_status(path, error))) {
    if (fs::is_regular_file(path, error) && whole_file(path) == content) return false;
    throw Refusal("another file with this name is there");
  }
  make_folders(fs::path(path).parent_path().string());
  AtomicFile target(path);
  target.write(content);
  target.commit();
  return true;
}

}  // namespace meristem::studio
