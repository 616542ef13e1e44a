// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/models.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/table/file_access.h"
#include "meristem/graph/table/within_root.h"

namespace meristem {

namespace fs = std::filesystem;

namespace {

constexpr const char* kFilms = "films";  // subfolder

}  // namespace

std::vector<std::string> model_names(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> film_names(const std::string& folder) {
  return folder.empty() ? std::vector<std::string>() : model_names((fs::path(folder) / kFilms).string());
}

std::string model_path(const std::string& folder, const std::string& name) {
  std::error_code ignored;
  const fs::path film = fs::path(folder) / kFilms / (name + ".json");
  const fs::path model = fs::path(folder) / (name + ".json");
  return (!fs::exists(model, ignored) && fs::exists(film, ignored) ? film : model).string();
}

namespace {

/// Returns the names of models and films.
std::vector<std::string> all_names(const std::string& folder) {
  std::vector<std::string> names = model_names(folder);
  for (std::string& film : film_names(folder)) names.push_back(std::move(film));
  return names;
}

}  // namespace

std::string find_document(const std::string& path, const std::string& folder) {
  std::error_code ignored;
  const bool is_plain_name = path.find_first_of("./") == std::string::npos;
  if (!is_plain_name || (fs::exists(path, ignored) && !fs::is_directory(path, ignored))) return path;
  const std::vector<std::string> names = all_names(folder);
  if (std::find(names.begin(), names.end(), path) != names.end()) return model_path(folder, path);
  throw InputError(Diagnostic{.message = fmt::format("there is no file and no shipped model '{}'", path),
                              .expected = "a document, or the name of a shipped model",
                              .nearest = nearest_name(path, names)});
}

DocumentFile find_document_within(const std::string& path, const std::string& folder, const std::string& root) {
  if (root.empty()) return {find_document(path, folder), root};
  const bool is_plain_name = path.find_first_of("./") == std::string::npos;
  if (is_plain_name && !is_within_root(path, root)) {
    // A file outside the root is not checked, so that the answer does not depend on its existence.
    const std::vector<std::string> names = all_names(folder);
    if (std::find(names.begin(), names.end(), path) != names.end()) return {model_path(folder, path), folder};
  }
  try {
    FileAccess{.root = root}.require_within(path);
  } catch (const InputError& error) {
    std::vector<Diagnostic> errors = error.diagnostics();
    for (Diagnostic& diagnostic : errors) diagnostic.file = path;
    throw InputError(std::move(errors));
  }
  const std::string file = find_document(path, folder);
  return {file, file == path ? root : folder};
}

}  // namespace meristem
