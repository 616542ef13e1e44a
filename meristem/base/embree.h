// SPDX-License-Identifier: Apache-2.0
// The only source that knows Embree's version: 3 or 4. All other sources include this header, use Embree's names that
// both versions share, and follow rays with the functions below.
#pragma once

#include <cstddef>

#if MERISTEM_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace meristem {

/// The configuration of Embree's device. Embree's threads belong to TBB, which the thread sanitizer misreads. Under
/// that sanitizer Embree builds its trees on the calling thread.
#ifdef __SANITIZE_THREAD__
inline constexpr const char* kEmbreeDevice = "threads=1,user_threads=1";
#else
inline constexpr const char* kEmbreeDevice = nullptr;
#endif

/// Bytes that Embree's memory monitor counts per instance, in addition to the instance's part of the tree. Only Embree
/// 4 reports the object of each instance to the monitor.
inline constexpr std::size_t kCountedInstanceBytes = MERISTEM_EMBREE >= 4 ? 240 : 0;

#if MERISTEM_EMBREE >= 4

/// The state of one ray, which Embree passes to the functions of geometries as `context`. A derived type can add state.
struct EmbreeRayContext : RTCRayQueryContext {
  EmbreeRayContext() { rtcInitRayQueryContext(this); }
};

/// Finds the first hit of a ray.
inline void find_first_hit(RTCScene scene, EmbreeRayContext& context, RTCRayHit& query) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect1(scene, &query, &arguments);
}

/// Sets `query.tfar` to minus infinity if anything blocks the ray.
inline void find_any_hit(RTCScene scene, EmbreeRayContext& context, RTCRay& query) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded1(scene, &query, &arguments);
}

#else

struct EmbreeRayContext : RTCIntersectContext {
  EmbreeRayContext() { rtcInitIntersectContext(this); }
};

inline void find_first_hit(RTCScene scene, EmbreeRayContext& context, RTCRayHit& query) {
  rtcIntersect1(scene, &context, &query);
}

inline void find_any_hit(RTCScene scene, EmbreeRayContext& context, RTCRay& query) {
  rtcOccluded1(scene, &context, &query);
}

#endif

}  // namespace meristem
