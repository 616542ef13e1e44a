// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "meristem/base/progress.h"

namespace meristem {

/// Number of items that a loop may process between two checks of its Progress, at some 100 ns each.
inline constexpr std::size_t kItemsBetweenChecks = 1 << 16;

/// Returns `count` copies of `value`, made step by step, so that cancelling need not wait for the memory of millions.
/// Throws Cancelled.
template <class Value>
std::vector<Value> filled(std::size_t count, Value value, const Progress& progress) {
  std::vector<Value> values;
  values.reserve(count);
  while (values.size() < count) {
    progress.check();
    values.resize(std::min(count, values.size() + kItemsBetweenChecks), value);
  }
  return values;
}

}  // namespace meristem
