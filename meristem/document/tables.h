// SPDX-License-Identifier: Apache-2.0
// The tables of a document's own keys. The registry has the tables of components.
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
  Vec3 colour = kGroundColour;  ///< sRGB
};

/// A line that shoots may be tied to.
struct SceneSupport {
  std::vector<Vec3> line;  ///< corners of the line, metres
};

/// The key `scene`.
struct SceneParameters {
  LightParameters light;                                       ///< sun, sky and lamps
  std::vector<ObstacleParameters> obstacles;                   ///< bodies in the scene
  GroundParameters ground;                                     ///< ground in pictures
  std::vector<std::pair<std::string, SceneSupport>> supports;  ///< lines by name
};

/// The plain keys of the top level.
struct DocumentHead {
  int format = kDocumentFormat;  ///< format of the document
  std::string name;              ///< name for people
  std::string description;       ///< one sentence for people
  std::string author;            ///< who made the document
  std::string licence;           ///< licence of the document
  std::uint64_t seed = 1;        ///< root of all random numbers
  SceneParameters scene;         ///< light, obstacles, ground and supports
  OutputParameters output;       ///< defaults for pictures and files
};

const ParameterTable& head_table();       ///< the rows of DocumentHead
const ParameterTable& variable_table();   ///< the rows of Variable
const ParameterTable& animation_table();  ///< the rows of Animation
const ParameterTable& limits_table();     ///< the rows of SizeLimits

}  // namespace meristem
