// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/further_columns.h"

#include <algorithm>

namespace meristem {

float inner_value(const Skeleton& skeleton, std::string_view column, NodeIndex begin, NodeIndex end, float share) {
  if (column == kEndColumn || column == kShedColumn) return 0;
  const std::vector<float>& values = skeleton.extra.find(column)->second;
  const auto metamer = skeleton.extra.find(kMetamerColumn);
  if (metamer != skeleton.extra.end() && metamer->second[end] >= 1) return values[end];
  const auto [min, max] = std::minmax(values[begin], values[end]);
  return std::clamp(values[begin] + share * (values[end] - values[begin]), min, max);
}

}  // namespace meristem
