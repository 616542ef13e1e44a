// SPDX-License-Identifier: Apache-2.0
// What the texts of a value mention, as far as that can be told without reading them as what they are.
#pragma once

#include <string_view>

#include "meristem/base/function_ref.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Whether names may have this character.
bool is_of_name(char c);

/// Calls `take` for each word in the text that could be a name, in order; what is part of a number is none.
void for_each_name(std::string_view text, FunctionRef<void(std::string_view name)> take);
/// Calls `take` for each word that could be a name in all texts of a value; names of members are no texts.
void for_each_mention(const Value& value, FunctionRef<void(std::string_view name)> take);

/// The value at a document path such as "links[1].density", or of the longest part of the path that there is; null
/// where not even its first part is there.
const Value* find_value(const Value& root, std::string_view path);

}  // namespace meristem
