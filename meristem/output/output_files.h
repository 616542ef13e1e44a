// SPDX-License-Identifier: Apache-2.0
// What is known before the work about the files that will be written after it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "meristem/document/document.h"

namespace meristem {

/// The document's file and those that it names.
std::vector<std::string> input_files(const Document& document);

/// Throws MachineError if a file cannot be written at `path`, and InputError if it would take the place of one of the
/// files that are read. "-", devices and pipes are always right.
void check_output(const std::string& path, std::span<const std::string> inputs);

/// Checks, as `check_output` does, every file that writing a grown document to `path` may write, and the files that the
/// format puts beside it. Throws InputError for endings that name no format.
void check_grown_output(const Document& document, const std::string& path);

}  // namespace meristem
