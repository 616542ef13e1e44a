// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/bundle.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <system_error>

#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/hash.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

std::optional<std::string> content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  if (file.bad()) return std::nullopt;
  return std::move(text).str();
}

bool is_below(const fs::path& path, const fs::path& folder) {
  const fs::path relative = path.lexically_relative(folder);
  return !folder.empty() && !relative.empty() && *relative.begin() != "..";
}

/// Where a path leads, without links and dots as far as it exists.
fs::path whole_path(const fs::path& path) {
  std::error_code error;
  const fs::path found = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? fs::absolute(path).lexically_normal() : found;
}

/// How many folders up from its own folder a document's relative paths lead, at most.
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

std::uint64_t DocumentBundle::bytes() const {
  std::uint64_t sum = 0;
  for (const auto& [path, content] : files) sum += content.size();
  return sum;
}

DocumentBundle bundle_of(const Document& document, const std::string& models) {
  // Relative to the document's folder, as the document itself names them: links are not followed, or the names would
  // lead elsewhere where the bundle is unpacked.
  const fs::path file(document.source.file);
  const fs::path folder = fs::absolute(file.parent_path() / ".").lexically_normal();
  const bool is_shipped = !models.empty() && is_below(whole_path(file), whole_path(models));
  const fs::path shipped = models.empty() || is_shipped ? fs::path() : whole_path(models);
  std::map<fs::path, fs::path> found;  // by the path from the document's folder
  std::size_t up = 0;
  for (const std::string& named : document.source.named_files) {
    if (is_below(whole_path(named), shipped)) continue;
    if (fs::path(named).is_absolute() && !file.is_absolute()) continue;
    const fs::path relative = fs::absolute(named).lexically_normal().lexically_relative(folder);
    if (relative.empty()) continue;
    up = std::max(up, steps_up(relative));
    found.emplace(relative, named);
  }

  // The document lies as deep as its paths lead up.
  fs::path own;
  for (std::size_t k = 0; k < up; ++k) own /= fmt::format("folder{}", k + 1);
  const bool is_file = !file.filename().empty() && file.filename().string().front() != '<';
  DocumentBundle bundle;
  bundle.document = (own / (is_file ? file.filename() : fs::path("document.json"))).generic_string();
  std::map<std::string, std::string> files{{bundle.document, document.source.text}};
  for (const auto& [relative, path] : found) {
    std::optional<std::string> content = content_of(path);
    if (!content) throw MachineError(fmt::format("cannot read '{}', which the document names", path.string()));
    files.emplace((own / relative).lexically_normal().generic_string(), std::move(*content));
  }
  for (auto& [path, content] : files) bundle.files.emplace_back(path, std::move(content));
  return bundle;
}

void unpack(const DocumentBundle& bundle, const std::string& folder) {
  for (const auto& [path, content] : bundle.files) {
    const fs::path target = fs::path(folder) / path;
    if (content_of(target) == content) continue;
    std::error_code error;
    fs::create_directories(target.parent_path(), error);
    if (error) throw MachineError(fmt::format("cannot make '{}': {}", target.parent_path().string(), error.message()));
    AtomicFile file(target.string());
    file.write(content);
    file.commit();
  }
}

}  // namespace meristem
