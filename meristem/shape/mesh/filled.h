// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "meristem/base/progress.h"

namespace meristem {

/// Items that a loop may go through between two looks at its Progress, at some 100 ns each.
inline constexpr std::size_t kItemsBetweenChecks = 1 << 16;

/// `count` copies of `value`, made step by step: stopping need not wait for the memory of millions. Throws Cancelled.
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
