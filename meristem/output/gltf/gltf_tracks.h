// SPDX-License-Identifier: Apache-2.0
// How the nodes of a binary glTF move.
#pragma once

#include <vector>

#include "meristem/output/gltf/gltf_layout.h"

namespace meristem {

/// Adds the animation of a layout whose components are all in their order: a track for each property of each node that
/// changes. A node that moves rigidly has a turn and a shift at all keys, also where it has no size. Throws Cancelled.
void add_tracks(const std::vector<double>& times, GltfLayout& layout, const Progress& progress);

/// A frame that is made of a shift, a turn and a scale, as a node holds it.
struct NodePose {
  Vec3 translation{0};
  Vec4 rotation{0, 0, 0, 1};  ///< unit quaternion, w last
  Vec3 scale{1};
};

/// The pose of one of the instances at each key. Where it has no size, it is turned as at the nearest key at which it
/// has some: the next one, or else the last before.
std::vector<NodePose> poses_of(const GltfSharedMesh& shared, std::size_t row);

}  // namespace meristem
