// SPDX-License-Identifier: Apache-2.0
// The tables of a document's own keys. The tables of components come from the registry.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "meristem/document/document.h"
#include "meristem/document/light_table.h"
#include "meristem/document/obstacle_table.h"
#include "meristem/graph/table/parameter.h"

namespace meristem {

/// The ground in pictures.
struct GroundParameters {
  Vec3 colour = kGroundColour;
};

/// A line that shoots may be tied to.
struct SceneSupport {
  std::vector<Vec3> line;
};

/// The key `scene`.
struct SceneParameters {
  LightParameters light;
  std::vector<ObstacleParameters> obstacles;
  GroundParameters ground;
  std::vector<std::pair<std::string, SceneSupport>> supports;
};

/// The plain keys of the top level.
struct DocumentHead {
  int format = kDocumentFormat;
  std::string name;
  std::string description;
  std::string author;
  std::string licence;
  std::uint64_t seed = 1;
  SceneParameters scene;
  OutputParameters output;
};

const ParameterTable& head_table();       ///< the rows of DocumentHead
const ParameterTable& variable_table();   ///< the rows of Variable
const ParameterTable& animation_table();  ///< the rows of Animation
const ParameterTable& limits_table();     ///< the rows of Limits

}  // namespace meristem
