// SPDX-License-Identifier: Apache-2.0
// Shortens floats: the shortest text that reads back as the given float is parsed as a double.
#include "meristem/output/packet/short_values.h"

#include <string>

#include <fmt/format.h>

namespace meristem {

double short_number(float number) { return std::stod(fmt::format("{}", number)); }

Value vector_value(Vec3 vector) {
  return Value::List{short_number(vector.x), short_number(vector.y), short_number(vector.z)};
}

}  // namespace meristem
