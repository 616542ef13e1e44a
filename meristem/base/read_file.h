// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace meristem {

/// A whole file that an input names. Throws InputError where there is none (with the nearest name in its folder), where
/// it is empty, larger than `most_bytes` (limits.file_bytes) or no plain file; MachineError where it cannot be read.
std::string read_file(const std::string& path, std::uint64_t most_bytes);

}  // namespace meristem
