// SPDX-License-Identifier: Apache-2.0
// What the commands share: the options that every growing command takes, documents from files, models and standard
// input.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "meristem/document/document.h"

namespace meristem::cli {

/// Options of commands that read a document.
struct DocumentOptions {
  std::string path;
  std::vector<std::string> sets;
  std::optional<std::uint64_t> seed;
  int threads = 0;
  bool quiet = false;

  void add_to(CLI::App& command);
};

/// Reads the document that the options name: a file, "-" for standard input, or a shipped model by its name. Prints
/// warnings unless quiet.
Document open_document(const DocumentOptions& options);

/// Throws MachineError if a file cannot be written at `path`, so that this is known before the work and not after it,
/// and InputError if it would take the place of one of the files that are read.
void check_output(const std::string& path, std::span<const std::string> inputs);

/// The document's file and those that it names.
std::vector<std::string> input_files(const Document& document);

/// The folder of shipped models: beside the program where it is installed, else the source tree's.
std::string models_folder();
/// The names of the shipped models (files without their ending), in alphabetical order.
std::vector<std::string> model_names();
std::string model_path(const std::string& name);

}  // namespace meristem::cli
