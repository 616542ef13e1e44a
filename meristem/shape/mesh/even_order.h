// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meristem/base/random.h"

namespace meristem {

/// All of `count` things in an order whose beginnings of any length are spread evenly over them: of each two
/// neighbours one, drawn by lot, comes before the other; so it is among those that came first, and so on. Regular
/// patterns would do harm: every second of opposite leaves stands on the same side.
std::vector<std::uint32_t> even_order(std::size_t count, const RandomKey& key);

}  // namespace meristem
