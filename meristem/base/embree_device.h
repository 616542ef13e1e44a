// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace meristem {

/// With what Embree is started. Its own threads are TBB's, which the thread sanitizer misreads, so under that it builds
/// its trees on the thread that asks.
#ifdef __SANITIZE_THREAD__
inline constexpr const char* kEmbreeDevice = "threads=1,user_threads=1";
#else
inline constexpr const char* kEmbreeDevice = nullptr;
#endif

}  // namespace meristem
