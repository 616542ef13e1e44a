// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Reads JSON text, comments allowed. Throws an InputError with line and column (no file) for the first fault of form:
/// bad syntax, text that is not UTF-8, numbers too large, keys given twice or over 1000 bytes long, nesting or size
/// past the limits. Uses only `document_bytes` and `nesting` of `limits`; a document cannot change these two. Throws
/// Cancelled soon after `progress` was asked to stop; null: parsing cannot be stopped.
Value parse_json(std::string_view text, const Limits& limits = {}, const Progress* progress = nullptr);

/// Writes JSON in the canonical form: a member per line, two spaces, members in their order; lists that hold no objects
/// on one line; whole numbers without a point, others with the fewest digits that read back as the same number. Numbers
/// that are not finite become null. Text must be UTF-8.
std::string write_json(const Value& value);

/// Writes JSON as write_json does, on one line without a line end: [1, {"a": 2}].
std::string write_json_line(const Value& value);

}  // namespace meristem
