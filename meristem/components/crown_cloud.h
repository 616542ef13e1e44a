// SPDX-License-Identifier: Apache-2.0
// The attraction points of a component around the root, in the coordinates in which the outlines of its crown are
// drawn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/growth_traces.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// Returns the initial attraction points of the first instance of a component, for all of its roots. Each point is
/// relative to the root under its crown, in metres, y up, without the component's frame. These are exactly the points
/// that the instance grows into or shows, before obstacles, shade or light remove or move them. Returns nothing if no
/// component with that id fills a crown with points, or if it has no instance. With the cache of an expansion with
/// equal arguments, nothing grows again; only the points are placed again. Throws what expand() throws.
std::optional<std::vector<Vec3>> crown_cloud(const Graph& graph, const Scene& scene, const std::string& id, double time,
                                             Progress& progress, Cache* cache = nullptr, const GrowthView& view = {});

}  // namespace meristem
