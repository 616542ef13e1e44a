// SPDX-License-Identifier: Apache-2.0
// Shared by the commands: options of all growing commands, and documents from files, models and standard input.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "meristem/base/parallel.h"
#include "meristem/document/document.h"
#include "meristem/graph/component.h"

namespace meristem::cli {

/// Adds the options of every working command: the number of threads, and quiet output.
void add_run_options(CLI::App& command, int& threads, bool& quiet);

/// Adds the option --root. No file outside this folder is read.
void add_root_option(CLI::App& command, std::string& root);
/// Throws an InputError if a file that the command line names lies outside `root`. The message does not disclose
/// whether it exists.
void require_within(const std::string& root, const std::string& file);

/// Returns a validator that refuses texts that are no seeds.
CLI::Validator is_seed();

/// Limits the threads of a command; 0 uses all cores. Prints a note if there are more threads than cores, unless quiet.
ThreadLimit limited_threads(int threads, bool quiet);

/// Returns the component types that documents may name: the types of the library and of loaded plug-ins.
const Registry& components();
/// Adds the option --plugin, which loads a plug-in while the command line is read.
void add_plugin_option(CLI::App& command);

/// Options of commands that read a document.
struct DocumentOptions {
  std::string path;
  std::vector<std::string> sets;
  std::optional<std::uint64_t> seed;
  std::string root;  ///< no file outside this folder is read; empty: any file may be read
  int threads = 0;
  bool quiet = false;

  void add_to(CLI::App& command);
};

/// Reads the document that the options name: a file, "-" for standard input, or a shipped model by its name. Keys of
/// the document are evaluated at `time`, seconds. Prints warnings unless quiet.
Document open_document(const DocumentOptions& options, double time = 0);

/// Reads a document again that was opened with these options. Values in `more` replace the values of equal paths.
/// Prints nothing.
Document read_again(const Document& document, const DocumentOptions& options, std::vector<ValueOverride> more);

/// Returns the scene of a document that was opened with these options, with another sun. `sun` is the JSON of a
/// "scene.sun". Prints warnings about the scene unless quiet.
Scene scene_under(const Document& document, const DocumentOptions& options, const std::string& sun);

/// Adds `-o FILE` for the output files of a command, at least one. Each ending selects a format.
void add_output_option(CLI::App& command, std::vector<std::string>& outputs);

/// Returns the help on formats: the ending and the description of each.
template <class Formats>
std::string endings_of(const Formats& formats) {
  std::string text = "Files end in:\n";
  for (const auto& format : formats) text += fmt::format("  {:<14} {}\n", format.ending, format.doc);
  return text;
}

/// Adds `--time T`, the time at which the document grows.
CLI::Option* add_time_option(CLI::App& command, double& time);

/// Adds `--step K`, the growth step at which plants are shown.
void add_step_option(CLI::App& command, std::optional<int>& step);
/// Returns the step. Throws InputError if it is below 0.
std::optional<int> checked_step(std::optional<int> step);

/// Returns the absolute path without links and dots, whether or not the file exists. Equal for two paths of one file.
std::filesystem::path place_of(const std::string& path);

/// Returns the folder of shipped models, `../share/meristem/models` from the program's folder. The build folder has a
/// link there. Returns an empty path if the system does not report where the program is.
std::string models_folder();

}  // namespace meristem::cli
