// SPDX-License-Identifier: Apache-2.0
// Reads files and texts. Errors in them are reported at the value of the document, with the position in the file. The
// position in a text of the document is converted to a position in the document.
#include "meristem/graph/table/file_reader.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

#include "meristem/base/read_file.h"

namespace meristem {

namespace {

/// Returns the byte at which a character of a line begins. Line and column count from 0. Returns the text's end if
/// there is no such character.
std::size_t byte_offset(std::string_view text, std::size_t line, std::size_t column) {
  std::size_t at = 0;
  for (; line > 0; --line) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string_view::npos) return text.size();
    at = end + 1;
  }
  const auto continues = [&](std::size_t byte) { return (static_cast<unsigned char>(text[byte]) & 0xc0U) == 0x80U; };
  for (; column > 0 && at < text.size() && text[at] != '\n'; --column) {
    ++at;
    while (at < text.size() && continues(at)) ++at;
  }
  return at;
}

/// Returns a position in a file as text, as "fir.txt:3:7". Omits line and column if they are unknown.
std::string place_in_file(const Diagnostic& found, const std::string& file) {
  std::string path = file;
  if (found.line > 0) path += fmt::format(":{}", found.line);
  if (found.column > 0) path += fmt::format(":{}", found.column);
  return path;
}

}  // namespace

void FileReader::read(const Parameter& parameter, const Value& value, const DocumentPath& path,
                      FunctionRef<void(const std::string& file_path)> load) {
  const std::string* given = value.text();
  if (given == nullptr) return errors_.wrong_kind(parameter, value, path);
  const std::filesystem::path folder(access_.folder);
  const std::string file_path = given->empty() ? "" : (folder / *given).string();
  try {
    if (!given->empty()) access_.require_within(file_path);
    name_file({.path = file_path, .is_beside = !std::filesystem::path(*given).is_absolute()});
    load(file_path);
  } catch (const InputError& error) {
    for (const Diagnostic& found : error.diagnostics()) report_in_file(found, *given, path);
  } catch (const MachineError& error) {
    errors_.add_error(path, error.what());
  }
}

std::shared_ptr<const PlantSource> FileReader::plant_source(const std::string& name, const DocumentPath& path) {
  if (access_.sources == nullptr) {
    errors_.add_error(path, "no other documents can be read here", "a document that is read from a file");
    return nullptr;
  }
  try {
    PlantSources::Opened opened = access_.sources->open(name, access_);
    for (NamedFile& file : opened.files) name_file(std::move(file));
    return std::move(opened.source);
  } catch (const InputError& error) {
    for (const Diagnostic& found : error.diagnostics()) {
      if (found.file.empty()) {
        errors_.add_found(path, found);
      } else {
        report_in_file(found, found.file, path);
      }
    }
  } catch (const MachineError& error) {
    errors_.add_error(path, error.what());
  }
  return nullptr;
}

/// Reports an error within a file. The message names two positions: this path, and the position in the file.
void FileReader::report_in_file(const Diagnostic& found, const std::string& file, const DocumentPath& path) {
  const std::filesystem::path folder(access_.folder);
  Diagnostic told = found;
  told.message = fmt::format("'{}': {}", place_in_file(found, file), found.message);
  // The nearest file name is written as the document would write it.
  if (!access_.folder.empty() && told.nearest.starts_with((folder / "").string())) {
    told.nearest.erase(0, (folder / "").string().size());
  }
  errors_.add_found(path, told);
}

void FileReader::report_in_text(const Diagnostic& found, const Value& value, const DocumentPath& path) {
  Diagnostic told = found;
  if (!found.file.empty()) {
    told.message = fmt::format("'{}': {}", place_in_file(found, found.file), found.message);
    return errors_.add_found(path, told);
  }
  if (found.line < 1) return errors_.add_found(path, told);
  auto line = static_cast<std::size_t>(found.line - 1);
  const auto column = static_cast<std::size_t>(std::max(found.column, 1) - 1);
  if (value.list() == nullptr)
    return errors_.add_found(path, told, static_cast<int>(byte_offset(*value.text(), line, column)));
  // An element may hold several lines.
  const Value::List& elements = *value.list();
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const std::string& text = *elements[k].text();
    const auto own = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
    if (line < own)
      return errors_.add_found(DocumentPath(path, k), told, static_cast<int>(byte_offset(text, line, column)));
    line -= own;
  }
  errors_.add_found(path, told);
}

void FileReader::read_lines(const Parameter& parameter, const Value& value, const DocumentPath& path, ReadText read) {
  std::string text;
  if (const Value::List* lines = value.list()) {
    for (std::size_t k = 0; k < lines->size(); ++k) {
      const std::string* line = (*lines)[k].text();
      if (line == nullptr) return errors_.wrong_kind(parameter, (*lines)[k], DocumentPath(path, k));
      text += *line + '\n';
    }
  } else if (value.text() != nullptr) {
    text = *value.text();
  } else {
    return errors_.wrong_kind(parameter, value, path);
  }
  std::vector<Diagnostic> warnings;
  try {
    read(text, (std::filesystem::path(access_.folder) / "").string(), warnings);
  } catch (const InputError& error) {
    for (const Diagnostic& found : error.diagnostics()) report_in_text(found, value, path);
  }
  for (const Diagnostic& found : warnings) report_in_text(found, value, path);
}

void FileReader::read_text_file(const Parameter& parameter, const Value& value, const DocumentPath& path,
                                ReadText read) {
  std::vector<Diagnostic> warnings;
  this->read(parameter, value, path, [&](const std::string& file_path) {
    read(read_file(file_path, errors_.limits().file_bytes), file_path, warnings);
  });
  for (const Diagnostic& found : warnings) report_in_file(found, *value.text(), path);
}

std::string FileReader::included_text(const std::string& file, const std::string& name, std::uint64_t max_bytes) {
  const std::string file_path = (std::filesystem::path(file).parent_path() / name).string();
  access_.require_within(file_path);
  const bool is_relative = !std::filesystem::path(name).is_absolute();
  name_file({.path = file_path, .is_beside = is_relative && is_below_folder(file)});
  return read_file(file_path, max_bytes);
}

/// Records a file that the document names. Errors of hashing are ignored here: reading the file reports them.
void FileReader::name_file(NamedFile file) {
  try {
    file.hash = file_hash(file.path);
  } catch (const InputError&) {
  } catch (const MachineError&) {
  }
  named_.push_back(std::move(file));
}

/// Returns true if the path begins with the document's folder.
bool FileReader::is_below_folder(const std::string& file_path) const { return file_path.starts_with(access_.folder); }

std::optional<std::uint64_t> FileReader::file_hash(const std::string& file_path) {
  return access_.store == nullptr ? std::nullopt : access_.store->file_hash(file_path, errors_.limits().file_bytes);
}

Fingerprint FileReader::key_of(void (*load)()) const {
  static_assert(std::has_unique_object_representations_v<SizeLimits>);
  const std::string_view limits(reinterpret_cast<const char*>(&errors_.limits()), sizeof(SizeLimits));
  return Fingerprint().add(reinterpret_cast<std::uintptr_t>(load)).add_text(limits);
}

bool FileReader::are_present(const std::vector<NamedFile>& files) {
  return std::all_of(files.begin(), files.end(),
                     [&](const NamedFile& file) { return file.hash && file_hash(file.path) == file.hash; });
}

}  // namespace meristem
