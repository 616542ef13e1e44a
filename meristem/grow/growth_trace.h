// SPDX-License-Identifier: Apache-2.0
// A growth as it can be looked at afterwards: how a plant stood after each step, and what it grew by. Growth models
// record it while they grow, and only what somebody has asked for: without a wish a growth takes no more time or memory
// than ever, and with one the plant has the same bytes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/plant/skeleton.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// What is recorded of a growth. Each part costs memory of its own; models that have no such thing record nothing.
struct TraceWish {
  bool steps = false;    ///< how the plant stood after each step
  bool points = false;   ///< attraction points: when each was used up, and where it was by then
  bool pulls = false;    ///< which node each attraction point pulls
  bool ways = false;     ///< the ways to more light, or to more room, that buds found
  bool losses = false;   ///< what was shed and cut, and why
  bool markers = false;  ///< the markers of room, free and taken; needs `steps`
  bool outcome = false;  ///< how the plant would stand after what it plans

  bool any() const { return steps || points || pulls || ways || losses || markers || outcome; }
  std::uint64_t bits() const;  ///< equal for equal wishes; 0 for none
  bool operator==(const TraceWish&) const = default;
};

/// Both wishes together.
TraceWish operator|(const TraceWish& a, const TraceWish& b);

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

/// A branch that fell off a tree with all that it bore.
struct TracedLoss {
  int step = 0;                     ///< in which it fell
  std::string why;                  ///< path in the document: "components.oak.shedding", or the operation's that cut it
  Vec3 position{0};                 ///< where it was attached, world space
  std::uint32_t pieces = 0;         ///< segments that fell
  double length = 0;                ///< metres of them
  std::vector<TracedWay> segments;  ///< where they were

  bool operator==(const TracedLoss&) const = default;
};

/// What a step was made of, besides the plant itself.
struct StepMarks {
  std::vector<TracedPlace> points;   ///< attraction points, tree by tree
  std::vector<TracedWay> pulls;      ///< from nodes to the points that pull them in the next step
  std::vector<TracedWay> ways;       ///< from buds that grew in the step: one metre toward more light or room
  std::vector<TracedPlace> markers;  ///< around the plant
  std::vector<TracedLoss> losses;    ///< of the step

  /// Appends another plant's.
  void append(StepMarks more);
};

/// What one member of a stand was, step by step. Many threads may ask it.
class GrowthTrace {
 public:
  Frame place;  ///< frame of the instance that grew

  virtual ~GrowthTrace() = default;
  /// The last step that growth took, from 1; after it nothing changed.
  virtual int last_step() const = 0;
  /// The finished skeleton after `step` steps, 0 to last_step(): what a growth gives that has no more iterations, to
  /// the byte. `scene` is the one in which it grew. Only where steps were asked for. Throws what
  /// Grower::take_skeleton() throws.
  virtual Skeleton standing(int step, const Scene& scene, Progress& progress) const = 0;
  /// The finished skeleton after what the plant plans, as a growth gives it that does so, where nothing else of the
  /// stand grows on afterwards. Null where it plans nothing, or nobody asked for it.
  virtual const Skeleton* outcome() const { return nullptr; }
  /// What is known of a step: the marks that `wish` names, as far as they were recorded.
  virtual StepMarks marks(int step, const TraceWish& wish) const = 0;
  virtual std::uint64_t bytes() const = 0;  ///< of memory
};

}  // namespace meristem
