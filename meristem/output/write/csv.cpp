// SPDX-License-Identifier: Apache-2.0
// Quotes the fields of CSV tables (RFC 4180).
#include "meristem/output/write/csv.h"

namespace meristem {

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field.append(c == '"' ? 2 : 1, c);
  return field + '"';
}

}  // namespace meristem
