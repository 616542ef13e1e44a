// SPDX-License-Identifier: Apache-2.0
#include "documents.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/components/registry.h"
#include "terminal.h"

namespace meristem::cli {

namespace fs = std::filesystem;

void DocumentOptions::add_to(CLI::App& command) {
  command.add_option("document", path, "A plant document, the name of a shipped model, or - for standard input")
      ->required()
      ->type_name("DOC");
  command
      .add_option("--set", sets,
                  "Set a variable (age=20), parameter (leaf.length=0.1) or key (links[1].density=90); may be repeated")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  command.add_option("--seed", seed, "Use this seed instead of the document's")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--threads", threads, "Use so many threads; all cores if not given")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command.add_flag("-q,--quiet", quiet, "Print errors only");
}

namespace {

bool is_plain_name(const std::string& path) { return path.find_first_of("./") == std::string::npos; }

/// A file of that name goes before a model; a name that is neither suggests the nearest model.
std::string resolve(const std::string& path) {
  std::error_code ignored;
  if (!is_plain_name(path) || (fs::exists(path, ignored) && !fs::is_directory(path, ignored))) return path;
  const std::vector<std::string> names = model_names();
  if (std::find(names.begin(), names.end(), path) != names.end()) return model_path(path);
  throw InputError(Diagnostic{.message = fmt::format("there is no file and no shipped model '{}'", path),
                              .expected = "a document, or a name that 'meristem models' lists",
                              .nearest = nearest_name(path, names)});
}

}  // namespace

Document open_document(const DocumentOptions& options) {
  std::vector<Override> overrides;
  for (const std::string& set : options.sets) overrides.push_back(parse_override(set));
  const bool from_input = options.path == "-";
  const std::string path = from_input ? "-" : resolve(options.path);
  Document document = read_document(read_text_file(path), from_input ? "<standard input>" : path, builtin_components(),
                                    overrides, options.seed);
  if (!options.quiet) print_diagnostics(document.warnings);
  return document;
}

void check_output(const std::string& path, std::span<const std::string> inputs) {
  std::error_code ignored;
  for (const std::string& input : inputs) {
    if (!fs::equivalent(path, input, ignored)) continue;
    throw InputError(Diagnostic{.message = fmt::format("'{}' would be written over, and it is read", input),
                                .expected = "another name or folder for what is written"});
  }
  const fs::file_status status = fs::status(path, ignored);
  const bool is_stream =
      path == "-" || (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
  if (!is_stream) AtomicFile file(path);
}

std::vector<std::string> input_files(const Document& document) {
  std::vector<std::string> files = document.source.named_files;
  files.push_back(document.source.file);
  return files;
}

std::string models_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path installed = program.parent_path().parent_path() / "share" / "meristem" / "models";
    if (fs::is_directory(installed, error)) return installed.string();
  }
  return MERISTEM_SOURCE_MODELS;
}

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(models_folder(), error)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string model_path(const std::string& name) { return (fs::path(models_folder()) / (name + ".json")).string(); }

}  // namespace meristem::cli
