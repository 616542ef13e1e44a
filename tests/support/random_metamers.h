// SPDX-License-Identifier: Apache-2.0
// Random trees of metamers, grown without a model.
#pragma once

#include <cstddef>
#include <vector>

#include "meristem/base/random.h"
#include "meristem/grow/metamer/metamers.h"
#include "meristem/grow/metamer/resource.h"

namespace meristem {

/// Returns a bud of a metamer.
inline Bud& bud_of(Metamers& metamers, MetamerIndex metamer, bool is_lateral) {
  return (is_lateral ? metamers.lateral : metamers.terminal)[metamer];
}

/// Grows random open buds until the tree has `count` metamers besides its seed. Terminal buds are twice as likely.
inline Metamers random_metamers(RandomKey key, std::size_t count) {
  Metamers metamers(kUp, Vec3(1, 0, 0), key);
  for (std::uint64_t draw = 0; metamers.count() <= count; ++draw) {
    const auto from = static_cast<MetamerIndex>(key.uniform(draw, 0, static_cast<double>(metamers.count())));
    const bool is_lateral = key.child("side").uniform(draw) < 1.0 / 3;
    if (bud_of(metamers, from, is_lateral).is_open()) metamers.grow(from, is_lateral, static_cast<int>(draw % 1000));
  }
  return metamers;
}

/// Damages or kills random open buds: the share `share` of terminal buds is damaged, and the share `share` of lateral
/// buds each is damaged and killed.
inline void harm_buds(Metamers& metamers, RandomKey key, double share) {
  for (MetamerIndex metamer = 0; metamer < metamers.count(); ++metamer) {
    const double drawn = key.uniform(metamer);
    if (metamers.terminal[metamer].is_open() && drawn < share) metamers.terminal[metamer] = Bud::damaged();
    const double of_lateral = key.child("lateral").uniform(metamer);
    if (!metamers.lateral[metamer].is_open() || of_lateral >= 2 * share) continue;
    metamers.lateral[metamer] = of_lateral < share ? Bud::damaged() : Bud::dead();
  }
}

/// Returns light between 0.1 and 1 for all buds that gather light, and 0 for the share `dark` of them.
inline BudLight random_light(const Metamers& metamers, RandomKey key, double dark = 0) {
  BudLight light;
  light.resize(metamers.count());
  const auto of_bud = [&](std::uint64_t k) {
    return key.child("dark").uniform(k) < dark ? 0 : static_cast<float>(key.uniform(k, 0.1, 1));
  };
  for (MetamerIndex metamer = 0; metamer < metamers.count(); ++metamer) {
    const Bud terminal = metamers.terminal[metamer];
    if (terminal.is_open() || terminal.is_damaged()) light.terminal[metamer] = of_bud(2U * metamer);
    if (metamers.lateral[metamer].is_open()) light.lateral[metamer] = of_bud(2U * metamer + 1);
  }
  return light;
}

}  // namespace meristem
