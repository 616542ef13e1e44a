// SPDX-License-Identifier: Apache-2.0
// Lists of numbers in one array. A vector of vectors takes an allocation for each list, and as long to free as to make:
// tens of milliseconds for a document of 300,000 components, in which nothing checks whether to stop.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/reading_stop.h"

namespace meristem {

/// List k is `item[first[k] .. first[k+1])`, by rising number.
struct FlatLists {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> item;

  std::span<const std::uint32_t> of(std::size_t list) const {
    return std::span(item).subspan(first[list], first[list + 1] - first[list]);
  }
};

/// Returns `lists` lists of the numbers below `items`. Number k is in the list `list_of(k)`. Throws Cancelled if the
/// readers of this thread were asked to stop.
template <class ListOf>
FlatLists make_flat_lists(std::size_t lists, std::size_t items, const ListOf& list_of) {
  StopCounter stop;
  FlatLists made{std::vector<std::uint32_t>(lists + 1), std::vector<std::uint32_t>(items)};
  for (std::size_t k = 0; k < items; ++k) {
    stop.step();
    ++made.first[list_of(k) + 1];
  }
  for (std::size_t list = 0; list < lists; ++list) made.first[list + 1] += made.first[list];
  std::vector<std::uint32_t> next(made.first.begin(), made.first.end() - 1);
  for (std::size_t k = 0; k < items; ++k) {
    stop.step();
    made.item[next[list_of(k)]++] = static_cast<std::uint32_t>(k);
  }
  return made;
}

}  // namespace meristem
