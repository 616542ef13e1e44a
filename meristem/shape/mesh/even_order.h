// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meristem/base/random.h"

namespace meristem {

/// Returns a random permutation of `count` items whose prefixes are evenly spread: in each pair of neighbours one item,
/// chosen at random, comes first. The chosen items are ordered by the same rule. A regular pattern would be harmful,
/// because every second of opposite leaves stands on the same side.
std::vector<std::uint32_t> even_order(std::size_t count, const RandomKey& key);

}  // namespace meristem
