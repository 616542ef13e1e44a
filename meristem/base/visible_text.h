// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "meristem/base/diagnostic.h"

namespace meristem {

/// Returns `text` with an escape in the place of each character that a terminal or page would act on and not show:
/// control characters (C0, C1, DEL), marks that turn the direction of text (U+061C, U+200E, U+200F, U+202A to U+202E,
/// U+2066 to U+2069) and separators of lines and paragraphs (U+2028, U+2029). Escapes are "\u001b"; a byte that is not
/// UTF-8 becomes "\xff". Other text stays as it is. All messages of the program pass through here.
std::string visible_text(std::string_view text);

/// Like visible_text(), but keeps the ends of lines, for messages of several lines.
std::string visible_lines(std::string_view text);

/// Returns `diagnostic` with a message, expectation and nearest name that are visible text. File and path stay as they
/// are, as programs look them up.
Diagnostic visible(Diagnostic diagnostic);

}  // namespace meristem
