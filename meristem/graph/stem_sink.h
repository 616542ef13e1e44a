// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/random.h"
#include "meristem/graph/emitted.h"
#include "meristem/graph/placement.h"
#include "meristem/plant/plant.h"
#include "meristem/plant/skeleton.h"
#include "meristem/plant/trim.h"

namespace meristem {

struct PresentInstance;

/// Returns the key for the positions of children on a stem with this key.
inline RandomKey key_of_places(RandomKey stem) { return stem.child("branching"); }

/// Options of an emitted stem.
struct StemOptions {
  /// BranchPlacement of children by branch links, for keys that the links do not give. Null: the defaults of links.
  const BranchPlacement* branching = nullptr;
  TrimMode trim = TrimMode::cut;  ///< effect of a trim body of the surroundings
  /// Exponent of the pipe model, for the thickness of stems that grow over time. Larger: thinner branches.
  double pipe_exponent = 2;
};

/// Collects the stems of instances. Throws InputError if the stems of the plant exceed the limit of nodes.
class StemSink {
 public:
  /// `present` must outlive the sink.
  explicit StemSink(PresentInstance& present) : present_(&present) {}

  /// Emits a skeleton in world space. The instance's `place` moves the skeleton, but not its children. A trim body of
  /// the surroundings trims the skeleton; later calls use the nodes of the whole skeleton. If the document's plants
  /// grow over time and the type supports it, the stem is shown at its clock's time.
  void add(Skeleton skeleton, const SurfaceOptions& surface, const StemOptions& options = {});
  /// Emits an invisible skeleton for the children of branch links.
  void add_unseen(Skeleton skeleton, TrimMode trim = TrimMode::cut);

  /// Returns the grown skeleton of this instance. Only for components that grow, and once per instance.
  Skeleton take_grown();
  /// Returns the step, with a fraction, at which the instance shows a growth of `last` steps. This is the shown step of
  /// the document, or the step of the clock if stems grow over time, or else `last`. take_grown() returns the skeleton
  /// of that step.
  double grown_to(double last);
  /// Declares that the instance's stems have already grown up to its clock's time. The time then cuts nothing off them.
  void stands_as_grown();

  /// Returns the position of a frame, in world space, on the rest of the last emitted stem. The frame stands on `node`
  /// of the whole stem. Returns nothing if that part was trimmed away. Returns the frame unchanged for kNoNode.
  std::optional<Frame> on_rest(NodeIndex node, const Frame& frame) const;
  /// Returns the remaining share of the length of the last emitted stem, which must be a single axis. Returns 1 if it
  /// is whole.
  float length_left() const;
  /// Returns the key for the positions of children on the next emitted stem, if that has a `branching`.
  RandomKey places_on_next() const { return key_of_places(next_key()); }

 private:
  friend class Emitter;

  RandomKey next_key() const;
  void count_nodes(std::uint64_t more);
  std::shared_ptr<const GrowingStem> growing_stem(const Skeleton& whole, double pipe_exponent) const;
  std::shared_ptr<const TrimmedStem> trimmed_stem(Skeleton skeleton, const StemOptions& options,
                                                  const GrowingStem* growing) const;
  std::shared_ptr<const BranchPlacement> shared_branching(const BranchPlacement* branching);
  std::shared_ptr<const SurfaceOptions> shared_surface(SurfaceOptions surface);
  void found_roots(EmittedStem& stem);

  PresentInstance* present_;
  std::vector<Skeleton> grown_;                       // of the block's instances
  std::shared_ptr<const BranchPlacement> branching_;  // of the last emitted stem, since most stems have an equal one
  std::shared_ptr<const SurfaceOptions> surface_;     // of the last emitted stem, since most stems have an equal one
};

}  // namespace meristem
