// SPDX-License-Identifier: Apache-2.0
// Shortens floats: the shortest text that reads back as the given float is parsed as a double.
#include "meristem/export/packet/short_values.h"

#include <charconv>
#include <string>

#include <fmt/format.h>

namespace meristem {

double short_number(float number) {
  // std::stod is not used: it reads a comma if the host program's locale does.
  const std::string digits = fmt::format("{}", number);
  double shortened = number;  // stays for infinities and NaN
  std::from_chars(digits.data(), digits.data() + digits.size(), shortened);
  return shortened;
}

Value vector_value(Vec3 vector) {
  return Value::List{short_number(vector.x), short_number(vector.y), short_number(vector.z)};
}

}  // namespace meristem
