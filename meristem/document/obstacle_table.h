// SPDX-License-Identifier: Apache-2.0
// The parameters of obstacles in documents.
#pragma once

#include <optional>
#include <vector>

#include "meristem/graph/import_table.h"
#include "meristem/graph/table/asset.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/scene/obstacle/obstacles.h"

namespace meristem {

/// A mesh from a file, with the faults that prevent a closed mesh (closedness_errors) or a body (body_error). Both
/// checks take long.
struct ObstacleMesh {
  TriangleMesh mesh;                ///< the triangles of the file
  std::vector<std::string> errors;  ///< reasons why the mesh is not closed; empty if it is closed
  std::string body_error;           ///< reason why a closed mesh is not a body, or empty

  bool is_sound() const { return errors.empty() && body_error.empty(); }  ///< true for a closed body
};

/// Parameters of an obstacle. Exactly one of box and mesh is given.
struct ObstacleParameters {
  std::optional<Box> box;           ///< corners as written, in any order
  Asset<ObstacleMesh> mesh;         ///< mesh from a file
  ImportPose pose;                  ///< pose of the file's mesh in the world
  bool broken = false;              ///< true: a mesh that is not closed is accepted
  bool hidden = false;              ///< true: not drawn in pictures
  Vec3 colour = Obstacle{}.colour;  ///< sRGB
  std::string name;                 ///< name for measures; may be empty
};

const ParameterTable& obstacle_table();  ///< the rows of ObstacleParameters

/// Reports an error if the meshes have more triangles than the limits allow. `path` is the list's path.
void check_obstacles(const std::vector<ObstacleParameters>& forms, const DocumentPath& path, ParameterReader& reader);

/// Returns the obstacles that checked parameters describe.
Obstacles build_obstacles(const std::vector<ObstacleParameters>& forms);

}  // namespace meristem
