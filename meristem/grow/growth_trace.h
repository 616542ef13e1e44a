// SPDX-License-Identifier: Apache-2.0
// A growth as it can be looked at afterwards: how a plant stood after each step, and what it grew by. Growth models
// record it while they grow, and only what somebody has asked for: without a wish a growth takes no more time or memory
// than ever, and with one the plant has the same bytes.
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

/// A part of what can be recorded of a growth. Each costs memory of its own; models that have no such thing record
/// nothing.
enum class TracePart : std::uint8_t {
  steps,    ///< how the plant stood after each step
  points,   ///< attraction points: when each was used up, and where it was by then
  pulls,    ///< which node each attraction point pulls
  ways,     ///< the ways to more light, or to more room, that buds found
  losses,   ///< what was shed and cut, and why
  markers,  ///< the markers of room, free and taken; needs `steps`
  outcome,  ///< how the plant would stand after what it plans
};

/// What is recorded of a growth: a set of parts.
class TraceWish {
 public:
  constexpr TraceWish() = default;
  constexpr TraceWish(std::initializer_list<TracePart> parts) {
    for (const TracePart part : parts) bits_ |= bit(part);
  }
  /// All that tells of the growth itself: all parts but the outcome.
  static constexpr TraceWish all() {
    TraceWish wish;
    wish.bits_ = 2 * bit(TracePart::markers) - 1;
    return wish;
  }

  constexpr bool has(TracePart part) const { return (bits_ & bit(part)) != 0; }
  constexpr bool any() const { return bits_ != 0; }
  constexpr std::uint64_t bits() const { return bits_; }  ///< equal for equal wishes; 0 for none
  /// The wish without one part.
  constexpr TraceWish without(TracePart part) const {
    TraceWish rest = *this;
    rest.bits_ &= ~bit(part);
    return rest;
  }
  /// Both wishes together.
  constexpr TraceWish operator|(TraceWish other) const {
    other.bits_ |= bits_;
    return other;
  }
  constexpr bool operator==(const TraceWish&) const = default;

 private:
  static constexpr std::uint32_t bit(TracePart part) { return 1U << static_cast<std::uint32_t>(part); }

  std::uint32_t bits_ = 0;
};

/// What a place that plants compete for is at a step.
enum class PlaceState : std::uint8_t {
  free,     ///< pulls branches, or is room for buds
  used,     ///< a branch has come near: it pulls no more
  removed,  ///< an obstacle or the deepest shade left it out before growth began
};

/// An attraction point, or a marker of room.
struct TracedPlace {
  Vec3 position{0};  ///< where it is at the step, or was when it was used up; world space
  PlaceState state = PlaceState::free;
  int used_in = 0;  ///< step in which it was used up; 0 unless `state` is used, or where that is not known

  bool operator==(const TracedPlace&) const = default;
};

/// A way from one position to another, world space.
struct TracedWay {
  Vec3 from{0};
  Vec3 to{0};

  bool operator==(const TracedWay&) const = default;
};

/// What took a branch.
enum class LossCause : std::uint8_t {
  shed,  ///< the tree itself, for want of light
  cut,   ///< an operation
};

/// Why a branch fell.
struct LossReason {
  LossCause cause = LossCause::shed;
  std::string path;  ///< in the document: "components.oak.shedding", or the operation's that cut it

  bool operator==(const LossReason&) const = default;
};

/// A branch that fell off a tree with all that it bore.
struct TracedLoss {
  int step = 0;  ///< in which it fell
  LossReason why;
  Vec3 position{0};                 ///< where it was attached, world space
  double length = 0;                ///< metres of its segments
  std::vector<TracedWay> segments;  ///< where they were

  bool operator==(const TracedLoss&) const = default;
};

/// What a step was made of, besides the plant itself.
struct StepMarks {
  std::vector<TracedPlace> points;   ///< attraction points, tree by tree
  std::vector<TracedWay> pulls;      ///< from nodes to the points that pull them in the next step
  std::vector<TracedWay> ways;       ///< from buds that grew in the step: one metre toward more light
  std::vector<TracedWay> room_ways;  ///< from buds that grew in the step and look for room: one metre toward more of it
  std::vector<TracedPlace> markers;  ///< around the plant
  std::vector<TracedLoss> losses;    ///< of the step

  /// Appends another plant's.
  void append(StepMarks more);
  /// Puts all of it where `frame` takes it; ways stay one metre long.
  void move(const Frame& frame);
  std::size_t count() const;  ///< of places, ways and segments that were lost
};

/// What one member of a stand was, step by step. Many threads may ask it.
class GrowthTrace {
 public:
  Frame place;  ///< frame of the instance that grew

  virtual ~GrowthTrace() = default;
  /// The last step that growth took, from 1; after it nothing changed.
  virtual int last_step() const = 0;
  /// The finished skeleton after what the plant plans, as a growth gives it that does so, where nothing else of the
  /// stand grows on afterwards. Null where it plans nothing, or nobody asked for it.
  virtual const Skeleton* outcome() const { return nullptr; }
  /// The finished skeleton after `step` steps, or after the last one where that comes before: what a growth gives that
  /// has no more iterations, to the byte. `scene` is the one in which it grew. Only where steps were asked for. Throws
  /// what Grower::take_skeleton() throws.
  Skeleton standing(int step, const Scene& scene, Progress& progress) const;
  /// What is known of a step, or of the last one where that comes before: the marks that `wish` names, as far as they
  /// were recorded. Throws InputError where they are more than the limits allow, Cancelled.
  StepMarks marks(int step, TraceWish wish, const Progress& progress) const;
  virtual std::uint64_t bytes() const = 0;  ///< of memory

 private:
  // Both are asked for steps from 0 to last_step() alone.
  virtual Skeleton standing_after(int step, const Scene& scene, Progress& progress) const = 0;
  virtual StepMarks marks_of(int step, TraceWish wish, const Progress& progress) const = 0;
};

}  // namespace meristem
