// SPDX-License-Identifier: Apache-2.0
// The motion of the nodes of a binary glTF.
#pragma once

#include <vector>

#include "meristem/output/gltf/gltf_layout.h"

namespace meristem {

/// Adds the animation of a layout whose components are complete: a track for each property of each node that changes. A
/// rigidly moving node has a rotation and a translation at all keys, also while it has no size. Throws Cancelled.
void add_tracks(const std::vector<double>& times, GltfLayout& layout, const Progress& progress);

/// A frame as translation, rotation and scale, as a node stores it.
struct NodePose {
  Vec3 translation{0};
  Vec4 rotation{0, 0, 0, 1};  ///< unit quaternion, w last
  Vec3 scale{1};
};

/// Returns the pose of one of the instances at each key. While the instance has no size, it has the rotation at the
/// next key with a size, or at the last one before.
std::vector<NodePose> poses_of(const GltfSharedMesh& shared, std::size_t row);

}  // namespace meristem
