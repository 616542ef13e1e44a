// SPDX-License-Identifier: Apache-2.0
// Collects the files of a document and finds names for them in one folder. All paths are taken relative to the
// document's folder. If they lead up from there, the document is placed as many folders deep, so that its relative
// paths stay valid.
#include "meristem/document/bundle.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <system_error>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/hash.h"
#include "meristem/base/whole_file.h"
#include "meristem/document/json.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

bool is_below(const fs::path& path, const fs::path& folder) {
  const fs::path relative = path.lexically_relative(folder);
  return !folder.empty() && !relative.empty() && *relative.begin() != "..";
}

/// Returns an absolute path without links and dots, up to its last existing part.
fs::path whole_path(const fs::path& path) {
  std::error_code error;
  const fs::path found = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? fs::absolute(path).lexically_normal() : found;
}

/// Adds the absolute paths among the texts of a value.
void add_absolute_paths(const Value& value, std::set<fs::path>& paths) {
  if (const Value::Object* const object = value.object()) {
    for (const auto& [name, member] : *object) add_absolute_paths(member, paths);
  } else if (const Value::List* const list = value.list()) {
    for (const Value& element : *list) add_absolute_paths(element, paths);
  } else if (value.text() != nullptr && value.text()->starts_with('/')) {
    paths.insert(fs::path(*value.text()).lexically_normal());
  }
}

/// Returns the absolute paths in a document and in the documents that it names.
std::set<fs::path> said_absolute_paths(const Document& document) {
  std::set<fs::path> paths;
  add_absolute_paths(document.source.tree, paths);
  for (const std::string& named : document.source.named_files) {
    if (!named.ends_with(".json")) continue;
    try {
      add_absolute_paths(parse_json(whole_file(named).value_or("")), paths);
    } catch (const InputError&) {
      // A table with the ending .json names no files.
    }
  }
  return paths;
}

/// Returns the number of ".." in a relative path: how many folders it leads up.
std::size_t steps_up(const fs::path& relative) {
  return static_cast<std::size_t>(std::count(relative.begin(), relative.end(), fs::path("..")));
}

}  // namespace

std::string DocumentBundle::hash() const {
  std::string all;
  for (const auto& [path, content] : files) {
    all += fmt::format("{}\n{}\n", path, content.size());
    all += content;
  }
  all += document;
  return hash128_hex(std::as_bytes(std::span(all.data(), all.size())));
}

DocumentBundle bundle_of(const Document& document, const std::string& models) {
  // Paths are relative to the document's folder, as in the document. Links are not followed: the names would otherwise
  // be wrong where the bundle is unpacked.
  const fs::path file(document.source.file);
  const fs::path folder = fs::absolute(file.parent_path() / ".").lexically_normal();
  const bool is_shipped = !models.empty() && is_below(whole_path(file), whole_path(models));
  const fs::path shipped = models.empty() || is_shipped ? fs::path() : whole_path(models);
  std::map<fs::path, fs::path> found;  // by the path relative to the document's folder
  const std::set<fs::path> is_said_absolutely = said_absolute_paths(document);
  std::size_t up = 0;
  for (const std::string& named : document.source.named_files) {
    if (is_below(whole_path(named), shipped)) continue;
    if (is_said_absolutely.contains(fs::path(named).lexically_normal())) continue;
    const fs::path relative = fs::absolute(named).lexically_normal().lexically_relative(folder);
    if (relative.empty()) continue;
    up = std::max(up, steps_up(relative));
    found.emplace(relative, named);
  }

  // The document lies as many folders deep as its paths lead up.
  fs::path own;
  for (std::size_t k = 0; k < up; ++k) own /= fmt::format("folder{}", k + 1);
  const bool is_file = !file.filename().empty() && file.filename().string().front() != '<';
  DocumentBundle bundle;
  bundle.document = (own / (is_file ? file.filename() : fs::path("document.json"))).generic_string();
  std::map<std::string, std::string> files{{bundle.document, document.source.text}};
  for (const auto& [relative, path] : found) {
    std::optional<std::string> content = whole_file(path.string());
    if (!content) throw MachineError(fmt::format("cannot read '{}', which the document names", path.string()));
    files.emplace((own / relative).lexically_normal().generic_string(), std::move(*content));
  }
  for (auto& [path, content] : files) bundle.files.emplace_back(path, std::move(content));
  return bundle;
}

void unpack(const DocumentBundle& bundle, const std::string& folder) {
  for (const auto& [path, content] : bundle.files) {
    const fs::path target = fs::path(folder) / path;
    if (whole_file(target.string()) == content) continue;
    make_folders(target.parent_path().string());
    write_whole_file(target.string(), content);
  }
}

}  // namespace meristem
