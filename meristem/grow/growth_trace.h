// SPDX-License-Identifier: Apache-2.0
// Records of a growth for later inspection: the plant after each step, and what caused it. Growth models record only
// the requested parts. Without a request, a growth costs no extra time or memory. A request never changes the plant.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/plant/skeleton.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// A part of a growth that can be recorded. Each part costs memory of its own. Models that do not have a part record
/// nothing for it.
enum class TracePart : std::uint8_t {
  steps,    ///< the plant after each step
  points,   ///< attraction points: positions, and the step in which each was used up
  pulls,    ///< which node each attraction point pulls
  ways,     ///< directions to more light or more space that buds found
  losses,   ///< branches that were shed or cut, with the reason
  markers,  ///< the markers of space, free and occupied; needs `steps`
  outcome,  ///< the plant after its planned operations
};

/// The set of parts to record.
class TraceRequest {
 public:
  constexpr TraceRequest() = default;
  /// A request for these parts.
  constexpr TraceRequest(std::initializer_list<TracePart> parts) {
    for (const TracePart part : parts) bits_ |= bit(part);
  }
  /// Returns a request for all parts of the growth itself: all parts except the outcome.
  static constexpr TraceRequest all() {
    TraceRequest request;
    request.bits_ = 2 * bit(TracePart::markers) - 1;
    return request;
  }

  constexpr bool has(TracePart part) const { return (bits_ & bit(part)) != 0; }  ///< true if the part is requested
  constexpr bool any() const { return bits_ != 0; }                              ///< true if any part is requested
  constexpr std::uint64_t bits() const { return bits_; }  ///< equal for equal requests; 0 for the empty request
  /// Returns the request without one part.
  constexpr TraceRequest without(TracePart part) const {
    TraceRequest rest = *this;
    rest.bits_ &= ~bit(part);
    return rest;
  }
  /// Returns the union of both requests.
  constexpr TraceRequest operator|(TraceRequest other) const {
    other.bits_ |= bits_;
    return other;
  }
  constexpr bool operator==(const TraceRequest&) const = default;

 private:
  static constexpr std::uint32_t bit(TracePart part) { return 1U << static_cast<std::uint32_t>(part); }

  std::uint32_t bits_ = 0;
};

/// The state at a step of a place that plants compete for.
enum class PlaceState : std::uint8_t {
  free,     ///< an attraction point pulls branches, or a marker is available to buds
  used,     ///< a branch has come near, and the place has no effect any more
  removed,  ///< an obstacle or the deepest shade removed it before growth began
};

/// An attraction point, or a marker of space.
struct TracedPlace {
  Vec3 position{0};                     ///< position at the step, or when it was used up; world space
  PlaceState state = PlaceState::free;  ///< free, used or removed
  int used_in = 0;                      ///< step in which it was used up; 0 if it is not used or if the step is unknown

  bool operator==(const TracedPlace&) const = default;
};

/// A segment from one position to another, world space.
struct TracedWay {
  Vec3 from{0};  ///< metres
  Vec3 to{0};    ///< metres

  bool operator==(const TracedWay&) const = default;
};

/// The cause of a lost branch.
enum class LossCause : std::uint8_t {
  shed,  ///< the tree shed it for lack of light
  cut,   ///< an operation cut it
};

/// The reason for the loss of a branch.
struct LossReason {
  LossCause cause = LossCause::shed;  ///< shed or cut
  std::string path;  ///< path in the document: "components.oak.shedding", or the path of the operation that cut it

  bool operator==(const LossReason&) const = default;
};

/// A branch that was lost together with everything that it bore.
struct TracedLoss {
  int step = 0;                     ///< step in which it was lost
  LossReason why;                   ///< the cause, and its place in the document
  Vec3 position{0};                 ///< where it was attached, world space
  double length = 0;                ///< total length of its segments, metres
  std::vector<TracedWay> segments;  ///< positions of its segments

  bool operator==(const TracedLoss&) const = default;
};

/// The marks of a step, in addition to the plant itself.
struct StepMarks {
  std::vector<TracedPlace> points;  ///< attraction points, tree by tree
  std::vector<TracedWay> pulls;     ///< from nodes to the points that pull them in the next step
  std::vector<TracedWay> ways;      ///< from buds that grew in the step, one metre toward more light
  /// From buds that grew in the step and search for space, one metre toward more space.
  std::vector<TracedWay> room_ways;
  std::vector<TracedPlace> markers;  ///< markers around the plant
  std::vector<TracedLoss> losses;    ///< branches lost in the step

  /// Appends the marks of another plant.
  void append(StepMarks more);
  /// Transforms all marks by `frame`. Directions keep their length of one metre.
  void move(const Frame& frame);
  std::size_t count() const;  ///< number of places, segments, and segments of lost branches
};

/// The recorded growth of one member of a stand. Thread-safe.
class GrowthTrace {
 public:
  Frame place;  ///< frame of the instance that grew

  virtual ~GrowthTrace() = default;
  /// Returns the last step that the growth took, from 1. Later steps change nothing.
  virtual int last_step() const = 0;
  /// Returns the finished skeleton after the planned operations, as in a growth that performs them and in which nothing
  /// else grows afterwards. Null if nothing is planned or if the outcome was not requested.
  virtual const Skeleton* outcome() const { return nullptr; }
  /// Returns the finished skeleton after `step` steps, or after the last step if `step` is larger. The result equals,
  /// byte by byte, a growth limited to that number of iterations. `scene` must be the scene of the growth. Requires
  /// that steps were recorded. Throws what Grower::take_skeleton() throws.
  Skeleton standing(int step, const Scene& scene, Progress& progress) const;
  /// Returns the marks of a step, or of the last step if `step` is larger. Only recorded marks that `request` names are
  /// returned. Throws InputError if they exceed the limits. Throws Cancelled.
  StepMarks marks(int step, TraceRequest request, const Progress& progress) const;
  virtual std::uint64_t bytes() const = 0;  ///< memory in bytes

 private:
  // Both are only called with steps from 0 to last_step().
  virtual Skeleton standing_after(int step, const Scene& scene, Progress& progress) const = 0;
  virtual StepMarks marks_of(int step, TraceRequest request, const Progress& progress) const = 0;
};

}  // namespace meristem
