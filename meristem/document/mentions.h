// SPDX-License-Identifier: Apache-2.0
// Finds the names that the texts of a value mention, without compiling the texts.
#pragma once

#include <string_view>

#include "meristem/base/function_ref.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Returns true if names may contain this character.
bool is_of_name(char c);

/// Calls `take` for each word in the text that could be a name, in order. Parts of numbers are skipped.
void for_each_name(std::string_view text, FunctionRef<void(std::string_view name)> take);
/// Calls `take` for each word that could be a name in all texts of a value. Names of members are skipped.
void for_each_mention(const Value& value, FunctionRef<void(std::string_view name)> take);

/// Returns the value at a document path such as "links[1].density", or at the longest beginning of the path that
/// exists. Returns null if not even the first part exists.
const Value* find_value(const Value& root, std::string_view path);

}  // namespace meristem
