// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace meristem {

/// Returns, for each of `count` keys, the nearest key for which `is_there(key)` is true: the key itself, otherwise the
/// next one, otherwise the last one before. Returns each key itself if `is_there` is always false.
template <class IsThere>
std::vector<std::size_t> nearest_keys(std::size_t count, IsThere is_there) {
  std::vector<std::size_t> nearest(count);
  std::size_t next = count;
  for (std::size_t key = count; key-- > 0;) {
    if (is_there(key)) {
      if (next == count) std::fill(nearest.begin() + static_cast<std::ptrdiff_t>(key), nearest.end(), key);
      next = key;
    }
    nearest[key] = next == count ? key : next;
  }
  return nearest;
}

}  // namespace meristem
