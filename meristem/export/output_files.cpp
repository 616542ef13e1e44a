// SPDX-License-Identifier: Apache-2.0
// Checks paths of output files before the work. Each file is opened as a temporary file and discarded, so that refused
// paths are found early.
#include "meristem/export/output_files.h"

#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"
#include "meristem/export/formats.h"

namespace meristem {

namespace fs = std::filesystem;

std::vector<std::string> input_files(const Document& document) {
  std::vector<std::string> files = document.source.named_files;
  files.push_back(document.source.file);
  return files;
}

void check_output(const std::string& path, std::span<const std::string> inputs) {
  std::error_code ignored;
  for (const std::string& input : inputs) {
    if (!fs::equivalent(path, input, ignored)) continue;
    throw InputError(Diagnostic{.message = fmt::format("'{}' would be overwritten, and it is read", input),
                                .expected = "another name or folder for what is written"});
  }
  const fs::file_status status = fs::status(path, ignored);
  const bool is_stream =
      path == "-" || (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
  if (!is_stream) AtomicFile file(path);
}

void check_grown_output(const Document& document, const std::string& path) {
  const FileFormat& format = format_of(path);
  const std::vector<std::string> inputs = input_files(document);
  check_output(path, inputs);
  if (format.companions == nullptr) return;
  for (const std::string& companion : format.companions(document, path)) check_output(companion, inputs);
}

}  // namespace meristem
