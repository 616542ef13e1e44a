// SPDX-License-Identifier: Apache-2.0
// The instances that a graph expands into: the tree that they make (the i-tree), and which of them made what is seen of
// a plant.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/progress.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/growth_traces.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// The i-tree of a graph. It has the camera's one instance as its root.
struct InstanceTree {
  /// One instance, and the instance that it stands on.
  struct Instance {
    ComponentIndex component = 0;     ///< index into Graph::components
    std::uint32_t parent = kNoIndex;  ///< index into instances; kNoIndex for the root
    LinkIndex link = kNoIndex;        ///< from its parent to it
    std::uint32_t i = 0;              ///< number among its siblings by that link
    std::uint32_t n = 1;              ///< siblings by that link, itself included
  };
  std::vector<Instance> instances;  ///< parents before children, those of one parent and link in their order
};

/// Expands the graph, one instance after another, and notes who stands on whom. Throws an InputError where there are
/// more than `most` instances, and as expand() does.
InstanceTree instance_tree(const Graph& graph, const Scene& scene, double time, std::uint64_t most, Progress& progress);

/// How many instances each component of the graph has, in their order; those that are left out do not count. With the
/// cache of an expansion of the same arguments, nothing is made anew. Throws as expand() does.
std::vector<std::uint64_t> instance_counts(const Graph& graph, const Scene& scene, double time, Progress& progress,
                                           Cache* cache = nullptr, const GrowthView& view = {});

/// A clock that an instance has begun for what hangs on it.
struct BegunClock {
  ComponentIndex component = 0;  ///< of the instance
  Clock clock;                   ///< the clock
};

/// The clocks that the components of a graph have begun up to a time, those of each component by their starts and each
/// once. Clocks of instances that have not appeared yet, and of those that bear nothing, are not among them. With the
/// cache of an expansion of the same arguments, nothing is made anew. Throws as expand() does.
std::vector<BegunClock> begun_clocks(const Graph& graph, const Scene& scene, double time, Progress& progress,
                                     Cache* cache = nullptr, const GrowthView& view = {});

/// A part of a plant whose instance is asked for, as expand() orders what it gives.
struct InstanceWish {
  /// The kind of thing that a number counts.
  enum class Of {
    organ,     ///< number `number` among the organs of the component
    stem,      ///< number `number` among its visible stems: StemPart::instance
    instance,  ///< number `number` among its instances, whatever they make
  };
  std::string component;     ///< id of the component
  Of of = Of::organ;         ///< organ, stem or instance
  std::uint64_t number = 0;  ///< from 0
};

/// An instance with what it is given.
struct FoundInstance {
  Site site;  ///< before the `frame` of the component
  /// The parameters that differ from instance to instance, by their path in the document, with their values here, in
  /// the units of the document.
  std::vector<std::pair<std::string, double>> values;
};

/// The instance that made a part of the plant that expand() gives for the same arguments; nothing where there is no
/// such part, or several instances made it together. With the cache of that expansion, nothing is grown anew. Throws as
/// expand() does.
std::optional<FoundInstance> find_instance(const Graph& graph, const Scene& scene, double time,
                                           const InstanceWish& wish, Progress& progress, Cache* cache = nullptr,
                                           const GrowthView& view = {});

}  // namespace meristem
