// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/markdown.h"

namespace meristem {

std::string markdown_cell(std::string_view text) {
  std::string cell;
  for (const char letter : text) {
    if (letter == '|') cell += '\\';
    cell += letter;
  }
  return cell;
}

}  // namespace meristem
