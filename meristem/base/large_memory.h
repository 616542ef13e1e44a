// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace meristem {

/// Asks for large pages for memory that nothing has been written to yet: the system hands out small ones one by one,
/// each at the cost of writing it several times, a quarter of the time of making a mesh of 10 million triangles. A
/// request, which systems without large pages leave alone; nothing happens for a few megabytes.
void prefer_large_pages(void* begin, std::size_t bytes);

/// Gives the system the memory that the program has freed and keeps for itself, where it keeps some. Takes
/// milliseconds, and memory that is asked for afterwards is slower at its first writing: for the end of large work, not
/// of each.
void give_back_memory();

/// Makes an empty vector that long, in large pages where it is large.
template <class Item>
void resize_large(std::vector<Item>& items, std::size_t count) {
  items.reserve(count);
  prefer_large_pages(items.data(), count * sizeof(Item));
  items.resize(count);
}

}  // namespace meristem
