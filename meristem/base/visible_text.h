// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "meristem/base/diagnostic.h"

namespace meristem {

/// Returns `text` with an escape for each character that a terminal or page would interpret instead of show: control
/// characters (C0, C1, DEL), marks that change the direction of text (U+061C, U+200E, U+200F, U+202A to U+202E, U+2066
/// to U+2069), and separators of lines and paragraphs (U+2028, U+2029). Escapes have the form "\u001b". A byte that is
/// not valid UTF-8 becomes "\xff". Other text stays unchanged. All messages of the program pass through this function.
std::string visible_text(std::string_view text);

/// Like visible_text(), but keeps line ends, for messages of several lines.
std::string visible_lines(std::string_view text);

/// Returns `diagnostic` with message, expectation and nearest name as visible text. File and path stay unchanged,
/// because programs look them up.
Diagnostic visible(Diagnostic diagnostic);

}  // namespace meristem
