// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/mtg/mtg.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "meristem/plant/mtg/mtg_text.h"

namespace meristem {

int MtgTree::finest_scale() const {
  int finest = 0;
  for (MtgVertex vertex = 0; vertex < vertex_count(); ++vertex) finest = std::max(finest, scale(vertex));
  return finest;
}

std::string MtgTree::label(MtgVertex vertex) const {
  const std::string& name = classes[type[vertex]].name;
  return index[vertex] < 0 ? name : fmt::format("{}{}", name, index[vertex]);
}

std::optional<std::uint32_t> MtgTree::find_feature(std::string_view name) const {
  for (std::uint32_t k = 0; k < features.size(); ++k) {
    if (features[k].name == name) return k;
  }
  return {};
}

std::vector<std::string_view> MtgTree::texts(std::uint32_t feature) const {
  std::vector<std::string_view> texts(vertex_count());
  for (const MtgValues::Row& row : values.rows) {
    for (std::size_t k = row.begin; k < row.end; ++k) {
      const MtgValues::Cell& cell = values.cells[k];
      if (cell.feature != feature) continue;
      const std::string_view text = std::string_view(values.text).substr(cell.begin, cell.size);
      std::fill(texts.begin() + row.first, texts.begin() + row.last + 1, text);
    }
  }
  return texts;
}

std::vector<double> MtgTree::numbers(std::uint32_t feature) const {
  std::vector<double> numbers;
  numbers.reserve(vertex_count());
  for (const std::string_view text : texts(feature)) {
    numbers.push_back(to_number(text).value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return numbers;
}

}  // namespace meristem
