// SPDX-License-Identifier: Apache-2.0
// Obstacles as documents write them.
#pragma once

#include <optional>
#include <vector>

#include "meristem/graph/import_table.h"
#include "meristem/graph/table/asset.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/scene/obstacle/obstacles.h"

namespace meristem {

/// A mesh from a file, with what keeps it from being closed (closedness_faults) or else a body (body_fault), which
/// takes long to find out.
struct ObstacleMesh {
  TriangleMesh mesh;
  std::vector<std::string> faults;
  std::string body_fault;

  bool is_sound() const { return faults.empty() && body_fault.empty(); }
};

/// Exactly one of box and mesh is given.
struct ObstacleParameters {
  std::optional<Box> box;  ///< corners as written, in any order
  Asset<ObstacleMesh> mesh;
  ImportPose pose;
  bool broken = false;
  bool hidden = false;
  Vec3 colour = Obstacle{}.colour;
  std::string name;
};

const ParameterTable& obstacle_table();  ///< the rows of ObstacleParameters

/// Reports more triangles than the limits allow; `path` is the list's.
void check_obstacles(const std::vector<ObstacleParameters>& forms, const DocumentPath& path, ParameterReader& reader);

/// The obstacles that checked forms mean.
Obstacles build_obstacles(const std::vector<ObstacleParameters>& forms);

}  // namespace meristem
