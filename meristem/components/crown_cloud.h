// SPDX-License-Identifier: Apache-2.0
// The attraction points of a component, as the outlines of its crown are drawn: about the root.
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

/// The attraction points that the first instance of a component begins with: those of all its roots, each relative to
/// the root over which its crown stands, metres, y up, before the component's frame, before obstacles and shade remove
/// some, and before light moves them. They are the very points that the instance grows into, or shows. Nothing where no
/// component of that id fills a crown with points, or it has no instance. With the cache of an expansion of the same
/// arguments, nothing is grown anew; the points are placed again. Throws what expand() throws.
std::optional<std::vector<Vec3>> crown_cloud(const Graph& graph, const Scene& scene, const std::string& id, double time,
                                             Progress& progress, Cache* cache = nullptr, const GrowthView& view = {});

}  // namespace meristem
