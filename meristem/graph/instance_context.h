// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/graph/animation.h"
#include "meristem/graph/minimum_counts.h"
#include "meristem/graph/table/site.h"
#include "meristem/graph/table/varying.h"
#include "meristem/grow/growth_trace.h"
#include "meristem/scene/scene.h"

namespace meristem {

struct PresentInstance;

/// Answers questions of a component about the instance that it expands.
class InstanceContext {
 public:
  /// `present` must outlive the context.
  explicit InstanceContext(const PresentInstance& present) : present_(&present) {}

  /// Returns the scene in which the plant grows.
  const Scene& scene() const;
  /// Returns the surroundings that the components above have set.
  const Surroundings& surroundings() const;
  /// Returns the directions toward the light and down, for any position in the instance's surroundings. Components use
  /// them to bend.
  const Directions& directions() const;
  /// Returns the limits of the document.
  const SizeLimits& limits() const;
  /// Returns the id of the component, for errors.
  const std::string& component() const;
  /// Returns the component's key, for random numbers that its instances share. Meshes that depend on it must include it
  /// in their key.
  RandomKey component_key() const;
  /// Returns true if a member of the component's parameters, or a part of it, differs from instance to instance.
  template <class M>
  bool varies(const ComponentMember<M>& member) const {
    return KnownMembers(varyings()).varies(member);
  }
  /// Returns the progress of the expansion, for a cancel.
  Progress& progress() const;
  /// Returns the time of the instance's clock, seconds.
  double time() const;
  /// Returns true if the instance's stems grow over time.
  bool grows_in_time() const;
  /// Returns the growth steps per second and the seconds that shed branches stay. Used if stems grow over time.
  const Animation& animation() const;
  /// Returns the growth of the instance that this one shows (ShownComponent) on the same parent. Returns null if the
  /// component does not use that growth (ComponentDefinition::watches_growth).
  const GrowthTrace* watched_growth() const;

 private:
  std::span<const Varying> varyings() const;

  const PresentInstance* present_;
};

}  // namespace meristem
