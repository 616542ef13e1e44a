// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meristem/base/fingerprint.h"
#include "meristem/base/function_ref.h"
#include "meristem/graph/table/file_access.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/plant_source.h"
#include "meristem/graph/table/read_errors.h"
#include "meristem/graph/table/read_store.h"

namespace meristem {

/// Reads the files, the texts and the other documents that a document names. Keeps what was made of them for the next
/// read.
class FileReader {
 public:
  /// Takes a text and the path of its file, and adds warnings by line and column.
  using ReadText =
      FunctionRef<void(const std::string& text, const std::string& file_path, std::vector<Diagnostic>& warnings)>;

  /// `errors` must outlive the reader.
  FileReader(FileAccess access, ReadErrors& errors) : access_(std::move(access)), errors_(errors) {}

  /// Calls `load` with the full path of the file that `value` names. Exceptions of `load` become errors at `path`.
  void read(const Parameter& parameter, const Value& value, const DocumentPath& path,
            FunctionRef<void(const std::string& file_path)> load);
  /// Calls `read` with a text, which may be given as a list of its lines, and with a path in the document's folder.
  /// Errors and warnings with a line and column are moved to their position in the document.
  void read_lines(const Parameter& parameter, const Value& value, const DocumentPath& path, ReadText read);
  /// Calls `read` with the text of the file that `value` names, as `read_lines` does with a text.
  void read_text_file(const Parameter& parameter, const Value& value, const DocumentPath& path, ReadText read);
  /// Returns the document that a component names, ready to grow. Returns null after errors at `path`.
  std::shared_ptr<const PlantSource> plant_source(const std::string& name, const DocumentPath& path);
  /// Returns the text of a file that another file includes. The path starts at the folder of the including file. Throws
  /// an InputError.
  std::string included_text(const std::string& file, const std::string& name, std::uint64_t max_bytes);
  /// Returns all files that were named so far.
  const std::vector<NamedFile>& named() const { return named_; }

  /// Returns true if results are kept for the next read.
  bool keeps() const { return access_.store != nullptr; }
  /// Returns the result of `make`, or its result in an earlier read with this key. The key must cover everything that
  /// the result depends on.
  template <class T, class Make>
  std::shared_ptr<const T> kept(const Fingerprint& key, Make make) {
    if (access_.store == nullptr) return std::make_shared<const T>(make());
    std::shared_ptr<const T> made = access_.store->find<T>(key.hash());
    if (made == nullptr) {
      made = std::make_shared<const T>(make());
      access_.store->keep<T>(key.hash(), made);
    }
    return made;
  }
  /// Returns what `load` makes of the file at `path`, or its result in an earlier read. `read` must have named the
  /// file.
  template <class T>
  std::shared_ptr<const T> kept_file(const std::string& file_path, T (*load)(const std::string&, const SizeLimits&)) {
    const std::optional<std::uint64_t> hash = file_hash(file_path);
    if (!hash) return std::make_shared<const T>(load(file_path, errors_.limits()));
    Fingerprint key = key_of(reinterpret_cast<void (*)()>(load));
    return kept<T>(key.add_text(file_path).add(*hash), [&] { return load(file_path, errors_.limits()); });
  }
  /// Returns what `make` makes of a text, or its result in an earlier read with this key. `make` may include files and
  /// add to `warnings`, which are reported in both cases.
  template <class T, class Make>
  std::shared_ptr<const T> kept_text(const Fingerprint& key, std::vector<Diagnostic>& warnings, Make make) {
    struct Read {
      std::shared_ptr<const T> made;
      std::vector<Diagnostic> warnings;
      std::vector<NamedFile> files;
    };
    std::shared_ptr<const Read> found = access_.store->find<Read>(key.hash());
    if (found == nullptr || !are_present(found->files)) {
      const std::size_t files_before = named_.size();
      Read read{std::make_shared<const T>(make()), warnings, {}};
      read.files.assign(named_.begin() + static_cast<std::ptrdiff_t>(files_before), named_.end());
      found = std::make_shared<const Read>(std::move(read));
      access_.store->keep<Read>(key.hash(), found);
      return found->made;
    }
    warnings = found->warnings;
    named_.insert(named_.end(), found->files.begin(), found->files.end());
    return found->made;
  }
  /// Returns the fingerprint of a function that reads, and of the limits.
  Fingerprint key_of(void (*load)()) const;

 private:
  void report_in_file(const Diagnostic& found, const std::string& file, const DocumentPath& path);
  void report_in_text(const Diagnostic& found, const Value& value, const DocumentPath& path);
  std::optional<std::uint64_t> file_hash(const std::string& file_path);
  void name_file(NamedFile file);
  bool is_below_folder(const std::string& file_path) const;
  bool are_present(const std::vector<NamedFile>& files);

  FileAccess access_;
  ReadErrors& errors_;
  std::vector<NamedFile> named_;
};

}  // namespace meristem
