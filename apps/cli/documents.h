// SPDX-License-Identifier: Apache-2.0
// What the commands share: the options that every growing command takes, documents from files, models and standard
// input.
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

/// The options of every command that works: how many threads, and whether it is to be quiet.
void add_run_options(CLI::App& command, int& threads, bool& quiet);

/// Adds the option --root: a folder outside of which no file is read.
void add_root_option(CLI::App& command, std::string& root);
/// Throws an InputError if a file that the command line names lies outside `root`; the message does not say whether it
/// exists.
void require_within(const std::string& root, const std::string& file);

/// Refuses what is no seed.
CLI::Validator is_seed();

/// Bounds the threads of a command, 0 for all cores; says where there are more than cores unless quiet.
ThreadLimit limited_threads(int threads, bool quiet);

/// The component types that documents may name: those of the library and of the plug-ins that were loaded.
const Registry& components();
/// The option --plugin, which loads one while the command line is read.
void add_plugin_option(CLI::App& command);

/// Options of commands that read a document.
struct DocumentOptions {
  std::string path;
  std::vector<std::string> sets;
  std::optional<std::uint64_t> seed;
  std::string root;  ///< nothing outside this folder is read; empty: any file may be read
  int threads = 0;
  bool quiet = false;

  void add_to(CLI::App& command);
};

/// Reads the document that the options name: a file, "-" for standard input, or a shipped model by its name. Prints
/// warnings unless quiet. It stands as its animation says at `time`, in seconds.
Document open_document(const DocumentOptions& options, double time = 0);

/// A document that was opened with these options, with other values besides, which replace those of the same paths.
/// Prints nothing.
Document read_again(const Document& document, const DocumentOptions& options, std::vector<Override> more);

/// The scene of a document that was opened with these options, with another sun: `sun` is the JSON of a "scene.sun".
/// Prints what is odd about it unless quiet.
Scene scene_under(const Document& document, const DocumentOptions& options, const std::string& sun);

/// Adds `-o FILE`, the files of a command that writes formats by their endings: one at least.
void add_output_option(CLI::App& command, std::vector<std::string>& outputs);

/// What the help says of formats, each with its ending and its words.
template <class Formats>
std::string endings_of(const Formats& formats) {
  std::string text = "Files end in:\n";
  for (const auto& format : formats) text += fmt::format("  {:<14} {}\n", format.ending, format.doc);
  return text;
}

/// Adds `--time T`, the time at which the document grows.
CLI::Option* add_time_option(CLI::App& command, double& time);

/// Adds `--step K`, the step of growth that is shown.
void add_step_option(CLI::App& command, std::optional<int>& step);
/// The step, as it was given. Throws InputError below 0.
std::optional<int> checked_step(std::optional<int> step);

/// Where a path leads, whether or not there is a file: equal for two paths of one file.
std::filesystem::path place_of(const std::string& path);

/// Returns the folder of shipped models, `../share/meristem/models` from the program's folder. The build folder has a
/// link there. Empty if the system does not tell where the program is.
std::string models_folder();

}  // namespace meristem::cli
