// SPDX-License-Identifier: Apache-2.0
#include "clock_values.h"

#include <algorithm>
#include <optional>

#include "meristem/graph/instances.h"

namespace meristem::studio {

namespace {

constexpr std::size_t kMaxBlocks = 400;  // maximum number of clocks per component; more would overlap when drawn

/// Returns evenly chosen clocks, including the first and the last.
Value::List blocks_of(std::span<const BegunClock> clocks) {
  Value::List blocks;
  const std::size_t told = std::min(clocks.size(), kMaxBlocks);
  for (std::size_t k = 0; k < told; ++k) {
    const InstanceClock& clock = clocks[told < 2 ? 0 : k * (clocks.size() - 1) / (told - 1)].clock;
    blocks.push_back(Value::List{clock.start, clock.speed});
  }
  return blocks;
}

}  // namespace

Value clocks_value(const GrownPlant& grown, double up_to, Progress& progress, GrowthCache& cache) {
  std::optional<Document> other;
  const Document& document = document_at(*grown.request.document, up_to, other, &progress);
  const std::vector<BegunClock> clocks =
      begun_clocks(document.graph, document.scene, up_to, progress, &cache, grown.view);
  Value::List list;
  for (auto begin = clocks.begin(); begin != clocks.end();) {
    const auto end =
        std::find_if(begin, clocks.end(), [&](const BegunClock& one) { return one.component != begin->component; });
    const std::span<const BegunClock> own(begin, end);
    list.push_back(Value::Object{{"component", document.graph.components[begin->component].id},
                                 {"count", static_cast<double>(own.size())},
                                 {"blocks", blocks_of(own)}});
    begin = end;
  }
  return list;
}

}  // namespace meristem::studio
