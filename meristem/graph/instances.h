// SPDX-License-Identifier: Apache-2.0
// The tree of instances into which a graph expands (the i-tree), and queries for the instance that made a part of a
// plant.
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

/// The i-tree of a graph. Its root is the single instance of the camera.
struct InstanceTree {
  /// One instance, and the instance that it stands on.
  struct Instance {
    ComponentIndex component = 0;     ///< index into Graph::components
    std::uint32_t parent = kNoIndex;  ///< index of the instance that it stands on; kNoIndex for the root
    LinkIndex link = kNoIndex;        ///< link from its parent
    std::uint32_t i = 0;              ///< number among its siblings by that link
    std::uint32_t n = 1;              ///< number of siblings by that link, including itself
  };
  std::vector<Instance> instances;  ///< parents before children; children of one parent and link in their order
};

/// Expands the graph and returns the tree of its instances. Throws an InputError if there are more than `max`
/// instances, and as expand() does.
InstanceTree instance_tree(const Graph& graph, const Scene& scene, double time, std::uint64_t max, Progress& progress);

/// Returns the number of instances of each component of the graph, in the order of the components. Omitted instances do
/// not count. With the cache of an expansion of equal arguments, nothing is made again. Throws as expand() does.
std::vector<std::uint64_t> instance_counts(const Graph& graph, const Scene& scene, double time, Progress& progress,
                                           Cache* cache = nullptr, const GrowthView& view = {});

/// A clock that an instance has begun for its descendants.
struct BegunClock {
  ComponentIndex component = 0;  ///< component of the instance
  InstanceClock clock;           ///< the clock
};

/// Returns the clocks that the components of a graph have begun up to a time. The clocks of a component are sorted by
/// their starts, without duplicates. Clocks of instances that have not appeared yet or have no children are left out.
/// With the cache of an expansion of equal arguments, nothing is made again. Throws as expand() does.
std::vector<BegunClock> begun_clocks(const Graph& graph, const Scene& scene, double time, Progress& progress,
                                     Cache* cache = nullptr, const GrowthView& view = {});

/// A request for the instance of a part of a plant. Parts are numbered in the order of the plant that expand() returns.
struct InstanceQuery {
  /// The kind of part that `number` counts.
  enum class Of {
    organ,     ///< number `number` among the organs of the component
    stem,      ///< number `number` among its visible stems: StemPart::instance
    instance,  ///< number `number` among its instances, even without geometry
  };
  std::string component;     ///< id of the component
  Of of = Of::organ;         ///< organ, stem or instance
  std::uint64_t number = 0;  ///< from 0
};

/// An instance with its site and its varying parameters.
struct FoundInstance {
  Site site;  ///< site before the `frame` of the component is applied
  /// The parameters that differ from instance to instance, with the path in the document and the value of this instance
  /// in the units of the document.
  std::vector<std::pair<std::string, double>> values;
};

/// Returns the instance that made a part of the plant that expand() returns for equal arguments. Returns nothing if
/// there is no such part, or if several instances made it together. With the cache of that expansion, nothing is grown
/// again. Throws as expand() does.
std::optional<FoundInstance> find_instance(const Graph& graph, const Scene& scene, double time,
                                           const InstanceQuery& request, Progress& progress, Cache* cache = nullptr,
                                           const GrowthView& view = {});

}  // namespace meristem
