// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace meristem {

/// Returns the content of a file that an input names. Throws InputError if the file does not exist (with the nearest
/// name in its folder), is empty, is larger than `max_bytes` (limits.file_bytes) or is not a plain file. Throws
/// MachineError if the file cannot be read.
std::string read_file(const std::string& path, std::uint64_t max_bytes);

}  // namespace meristem
