// SPDX-License-Identifier: Apache-2.0
// Options and documents that the commands share. A document comes from standard input, from a file, or from the folder
// of shipped models. Registries of component types are never destroyed, because documents point into them.
#include "documents.h"

#include <deque>
#include <filesystem>
#include <iterator>
#include <system_error>

#include <fmt/format.h>

#include "meristem/base/seed.h"
#include "meristem/components/plugin.h"
#include "meristem/components/registry.h"
#include "meristem/document/models.h"
#include "meristem/graph/table/within_root.h"
#include "terminal.h"

namespace meristem::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* kSun = "--sun";

/// Returns all registries. The last one is in use. A document points into the registry that it was read with.
std::deque<Registry>& registries() {
  static std::deque<Registry> all;
  return all;
}

std::vector<ValueOverride> overrides_of(const DocumentOptions& options) {
  std::vector<ValueOverride> overrides;
  for (const std::string& set : options.sets) overrides.push_back(parse_override(set));
  return overrides;
}

/// Returns the folder that limits which files an opened document may name.
std::string root_of(const Document& document, const DocumentOptions& options) {
  const bool is_file = !options.root.empty() && options.path != "-" && options.path != document.source.file;
  return is_file ? models_folder() : options.root;  // a shipped model, named without its path
}

}  // namespace

void add_run_options(CLI::App& command, int& threads, bool& quiet) {
  command.add_option("--threads", threads, "Number of threads; by default, one per core")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command.add_flag("-q,--quiet", quiet, "Print errors only");
}

const Registry& components() { return registries().empty() ? builtin_components() : registries().back(); }

void add_plugin_option(CLI::App& command) {
  const auto load = [](const std::vector<std::string>& paths) {
    for (const std::string& path : paths) registries().push_back(with_plugin(components(), path));
  };
  command
      .add_option_function<std::vector<std::string>>(
          "--plugin", load, "Load the component types of a shared library (libthorn.so); may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
}

void add_root_option(CLI::App& command, std::string& root) {
  command
      .add_option("--root", root,
                  "Read files in this folder only, wherever links and .. lead; shipped models may be read as well")
      ->type_name("FOLDER")
      ->check(CLI::ExistingDirectory);
}

void require_within(const std::string& root, const std::string& file) {
  if (is_within_root(file, root)) return;
  throw InputError(Diagnostic{.message = "this lies outside the folder that may be read",
                              .expected = "a file in the folder of --root",
                              .file = file});
}

CLI::Validator is_seed() {
  const auto error = [](const std::string& text) {
    return seed_of_text(text) ? "" : fmt::format("'{}' is not a seed; expected {}", text, kSeedRange);
  };
  return CLI::Validator(error, "");
}

ThreadLimit limited_threads(int threads, bool quiet) {
  const int cores = thread_count();
  if (threads > cores && !quiet) {
    print_status(fmt::format("meristem: {} threads take turns on {} cores", threads, cores));
  }
  return ThreadLimit(threads);
}

void DocumentOptions::add_to(CLI::App& command) {
  command.add_option("document", path, "A plant document, the name of a shipped model, or - for standard input")
      ->required()
      ->type_name("DOC");
  command
      .add_option("--set", sets,
                  "Set a variable (age=20), parameter (leaf.length=0.1) or key (links[1].density=90); may be repeated")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  command.add_option("--seed", seed, "Use this seed instead of the document's")->type_name("N")->check(is_seed());
  add_root_option(command, root);
  add_plugin_option(command);
  add_run_options(command, threads, quiet);
}

Document open_document(const DocumentOptions& options, double time) {
  const bool from_input = options.path == "-";
  const DocumentFile found =
      from_input ? DocumentFile{"-", options.root} : find_document_within(options.path, models_folder(), options.root);
  std::string text = read_text_file(found.file);
  // From here on Ctrl-C stops the reading. While the program waits for standard input, Ctrl-C ends it.
  TerminalProgress terminal(options.quiet);
  Document document = read_document(std::move(text), from_input ? "<standard input>" : found.file, components(),
                                    {.overrides = overrides_of(options),
                                     .seed = options.seed,
                                     .time = time,
                                     .root = found.root,
                                     .models = models_folder(),
                                     .progress = &terminal.progress()});
  if (!options.quiet) print_diagnostics(document.warnings);
  return document;
}

Document read_again(const Document& document, const DocumentOptions& options, std::vector<ValueOverride> more) {
  std::vector<ValueOverride> overrides = overrides_of(options);
  overrides.insert(overrides.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  TerminalProgress terminal(options.quiet);
  return read_document(document.source.text, document.source.file, components(),
                       {.overrides = std::move(overrides),
                        .seed = options.seed,
                        .root = root_of(document, options),
                        .models = models_folder(),
                        .progress = &terminal.progress()});
}

Scene scene_under(const Document& document, const DocumentOptions& options, const std::string& sun) {
  std::vector<ValueOverride> overrides = overrides_of(options);
  std::erase_if(overrides, [](const ValueOverride& override) { return override.path.starts_with("scene.sun"); });
  overrides.push_back(parse_override("scene.sun=" + sun));
  overrides.back().name = kSun;
  Document other = read_document(document.source.text, document.source.file, components(),
                                 {.overrides = std::move(overrides),
                                  .seed = options.seed,
                                  .root = root_of(document, options),
                                  .models = models_folder()});
  std::erase_if(other.warnings, [](const Diagnostic& warning) { return warning.file != kSun; });
  if (!options.quiet) print_diagnostics(other.warnings);
  return std::move(other.scene);
}

std::filesystem::path place_of(const std::string& path) { return fs::weakly_canonical(fs::absolute(path)); }

std::string models_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return "";
  // The build folder has a link to the folder of the source tree. The link is resolved, so that messages name files
  // that the user can edit.
  return fs::weakly_canonical(program.parent_path().parent_path() / "share" / "meristem" / "models", error).string();
}

void add_output_option(CLI::App& command, std::vector<std::string>& outputs) {
  command
      .add_option("-o,--output", outputs,
                  "File to write, in the format of its ending (see below); - for standard output; may be repeated")
      ->required()
      ->type_name("FILE")
      ->allow_extra_args(false);
}

CLI::Option* add_time_option(CLI::App& command, double& time) {
  return command.add_option("--time", time, "Grow the document at this time in seconds, the t of its expressions")
      ->type_name("T");
}

void add_step_option(CLI::App& command, std::optional<int>& step) {
  command
      .add_option("--step", step,
                  "Show plants that grow by a model as after this step: a step or iteration of growth, a step "
                  "of an L-system's derivation or a unit of a timed one's time. By default, after the last one")
      ->type_name("K");
}

std::optional<int> checked_step(std::optional<int> step) {
  if (!step || *step >= 0) return step;
  throw InputError(Diagnostic{.message = fmt::format("--step cannot be {}", *step), .expected = "0 or more steps"});
}

}  // namespace meristem::cli
