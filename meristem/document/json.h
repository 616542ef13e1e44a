// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "meristem/base/limits.h"
#include "meristem/graph/value.h"

namespace meristem {

/// Reads JSON text, comments allowed. Throws an InputError with line and column (no file) for the first fault of form:
/// bad syntax, text that is not UTF-8, numbers out of range, keys given twice, nesting or size past the limits.
Value parse_json(std::string_view text, const Limits& limits = {});

/// Writes JSON in the canonical form: two spaces, members in their order, whole numbers without a point.
std::string write_json(const Value& value);

}  // namespace meristem
