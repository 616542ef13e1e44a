// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Reads JSON text, in which comments are allowed. Throws an InputError with line and column (no file) for the first
/// fault of form. Such faults are bad syntax, text that is not UTF-8, numbers too large, keys given twice or over 1000
/// bytes long, and nesting or size past the limits. Uses only `document_bytes` and `nesting` of `limits`; a document
/// cannot change these two. Throws Cancelled soon after `progress` was asked to stop. Null: it cannot be stopped.
Value parse_json(std::string_view text, const SizeLimits& limits = {}, const Progress* progress = nullptr);

/// Writes JSON in the canonical form. Each member has a line, with two spaces per level, and members keep their order.
/// A list without objects stands on one line. Whole numbers have no point; other numbers have the fewest digits that
/// give an equal number when read. Numbers that are not finite become null. Text must be UTF-8.
std::string write_json(const Value& value);

/// Writes JSON as write_json does, on one line without a line end: [1, {"a": 2}].
std::string write_json_line(const Value& value);

}  // namespace meristem
