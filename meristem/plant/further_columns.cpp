// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/further_columns.h"

#include <algorithm>

namespace meristem {

float inner_value(const Skeleton& skeleton, std::string_view column, float begin, float end, float share) {
  if (column == "end" || column == "shed") return 0;
  if (skeleton.extra.contains(kMetamerColumn)) return end;
  const auto [least, most] = std::minmax(begin, end);
  return std::clamp(begin + share * (end - begin), least, most);
}

}  // namespace meristem
