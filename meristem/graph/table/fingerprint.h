// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "meristem/base/expression/expression_scope.h"
#include "meristem/graph/table/file_access.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Returns true if a text within the value contains the name as a whole word.
bool mentions(const Value& value, std::string_view name);

/// Returns a hash of what a document says at one path. The hash covers the value, the constants whose names occur in
/// its texts, and the content of the `files` that were read with it. If there are files, the hash covers all constants.
/// Returns nothing if a file cannot be read twice, such as a pipe. Takes time in proportion to the value's size,
/// whatever the number of constants.
std::optional<std::uint64_t> fingerprint_of(const Value& value, const ConstantTable& constants,
                                            std::span<const NamedFile> files, std::uint64_t file_bytes);

}  // namespace meristem
