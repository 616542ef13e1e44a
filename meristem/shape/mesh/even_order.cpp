// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/mesh/even_order.h"

#include <algorithm>
#include <numeric>

namespace meristem {

std::vector<std::uint32_t> even_order(std::size_t count, const RandomKey& key) {
  std::vector<std::uint8_t> rounds(count, 0);  // that each thing wins
  for (std::uint64_t thing = 0; thing < count; ++thing) {
    for (unsigned round = 0; (std::uint64_t{1} << round) < count; ++round) {
      const std::uint64_t pair = thing >> (round + 1);
      const bool is_alone = (2 * pair + 1) << round >= count;
      const bool later_wins = !is_alone && key.child(round).uniform(pair) < 0.5;
      if (((thing >> round & 1) != 0) != later_wins) break;
      ++rounds[thing];
    }
  }
  std::vector<double> lot(count);
  for (std::size_t thing = 0; thing < count; ++thing) lot[thing] = key.uniform(thing, 1);
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return rounds[a] != rounds[b] ? rounds[a] > rounds[b] : lot[a] < lot[b];
  });
  return order;
}

}  // namespace meristem
