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

/// Whether a text of the value has the name as a word of its own.
bool mentions(const Value& value, std::string_view name);

/// Hash of what a document says at one path: the value, the constants whose names occur in its texts, and what stands
/// in the `files` that were read with it; where there are such, all constants. Nothing where a file is none to be read
/// twice, such as a pipe. Takes time by the size of the value, however many constants there are.
std::optional<std::uint64_t> fingerprint_of(const Value& value, const ConstantTable& constants,
                                            std::span<const NamedFile> files, std::uint64_t file_bytes);

}  // namespace meristem
