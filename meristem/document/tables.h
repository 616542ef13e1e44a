// SPDX-License-Identifier: Apache-2.0
// The tables of a document's own keys; those of components come from the registry.
#pragma once

#include <optional>
#include <string>

#include "meristem/document/document.h"
#include "meristem/graph/parameter.h"

namespace meristem {

/// How a document says where the light comes from.
struct SunSettings {
  std::optional<double> azimuth;   // radians
  std::optional<double> altitude;  // radians
  std::optional<double> day;
  double hour = 12;
};

struct GroundSettings {
  Vec3 colour = Scene{}.ground_colour;
};

struct SceneSettings {
  std::optional<double> latitude;  // radians
  std::optional<SunSettings> sun;
  GroundSettings ground;
};

/// The plain keys of the top level.
struct DocumentHead {
  int format = kDocumentFormat;
  std::string name;
  std::string description;
  std::string author;
  std::string licence;
  std::uint64_t seed = 1;
  SceneSettings scene;
  OutputSettings output;
};

const ParameterTable& head_table();      ///< of DocumentHead
const ParameterTable& variable_table();  ///< of Variable
const ParameterTable& limits_table();    ///< of Limits

}  // namespace meristem
