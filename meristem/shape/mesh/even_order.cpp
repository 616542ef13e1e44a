// SPDX-License-Identifier: Apache-2.0
// Orders items by a knockout tournament: in each round, one of each two neighbouring winners is chosen at random. Items
// with more wins come first.
#include "meristem/shape/mesh/even_order.h"

#include <algorithm>
#include <numeric>

namespace meristem {

namespace {

/// Returns how often each item wins: one of each two neighbours at random, then one of each two winners, until one is
/// left. An item without a neighbour wins.
std::vector<std::uint8_t> rounds_won(std::size_t count, const RandomKey& key) {
  std::vector<std::uint8_t> rounds(count, 0);
  std::vector<std::uint32_t> winners(count);
  std::iota(winners.begin(), winners.end(), 0);
  for (std::uint64_t round = 0; winners.size() > 1; ++round) {
    const RandomKey lots = key.child(round);
    const std::size_t pairs = (winners.size() + 1) / 2;
    for (std::size_t pair = 0; pair < pairs; ++pair) {
      const bool is_alone = 2 * pair + 1 == winners.size();
      const bool later_wins = !is_alone && lots.uniform(pair) < 0.5;
      winners[pair] = winners[2 * pair + (later_wins ? 1 : 0)];
      ++rounds[winners[pair]];
    }
    winners.resize(pairs);
  }
  return rounds;
}

}  // namespace

std::vector<std::uint32_t> even_order(std::size_t count, const RandomKey& key) {
  struct Place {
    double lot;
    std::uint32_t thing;
    std::uint8_t rounds;
  };
  const std::vector<std::uint8_t> rounds = rounds_won(count, key);
  std::vector<Place> places(count);
  for (std::uint32_t thing = 0; thing < count; ++thing) places[thing] = {key.uniform(thing, 1), thing, rounds[thing]};
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    if (a.rounds != b.rounds) return a.rounds > b.rounds;
    return a.lot != b.lot ? a.lot < b.lot : a.thing < b.thing;
  });
  std::vector<std::uint32_t> order(count);
  std::transform(places.begin(), places.end(), order.begin(), [](const Place& place) { return place.thing; });
  return order;
}

}  // namespace meristem
