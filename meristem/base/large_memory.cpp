// SPDX-License-Identifier: Apache-2.0
// Requests large pages with madvise, and returns freed memory with malloc_trim. Both are hints that other systems
// ignore.
#include "meristem/base/large_memory.h"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace meristem {

void prefer_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::size_t kMin = std::size_t{8} << 20U;  // minimum number of bytes that is worth a system call
  constexpr std::uintptr_t kPage = 4096;
  if (bytes < kMin) return;
  // The system call needs whole pages. Pages at the ends may hold other data, so leave them out.
  const auto first = (reinterpret_cast<std::uintptr_t>(begin) + kPage - 1) / kPage * kPage;
  const auto last = (reinterpret_cast<std::uintptr_t>(begin) + bytes) / kPage * kPage;
  static_cast<void>(madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE));
#endif
}

void give_back_memory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

}  // namespace meristem
