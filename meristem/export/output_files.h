// SPDX-License-Identifier: Apache-2.0
// Checks, before the work, the files that will be written after it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "meristem/document/document.h"

namespace meristem {

/// Returns the document's file and the files that it names.
std::vector<std::string> input_files(const Document& document);

/// Throws MachineError if a file cannot be written at `path`, and InputError if it would overwrite a file that is read.
/// "-", devices and pipes are always valid.
void check_output(const std::string& path, std::span<const std::string> inputs);

/// Checks, like `check_output`, every file that may be written for a grown document at `path`, including the companions
/// of the format. Throws InputError for endings that name no format.
void check_grown_output(const Document& document, const std::string& path);

}  // namespace meristem
