// SPDX-License-Identifier: Apache-2.0
// What a document's scene says of its light, and the light that comes of it.
#pragma once

#include <optional>
#include <vector>

#include "meristem/graph/table/parameter.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// Where the sun stands: at a position on the sky, at an hour of a day or of a clock, over a day, or over a season.
struct SunParameters {
  std::optional<double> azimuth;      ///< radians
  std::optional<double> altitude;     ///< radians
  std::optional<double> day;          ///< day of the year
  std::vector<int> days;              ///< the first and the last of a season, or empty
  double every_days = 30;             ///< in a season
  std::optional<double> every_hours;  ///< over a day; always over a season
  double hour = 12;                   ///< hour of a day without every_hours, and of pictures
  std::string date;                   ///< in place of a day; may be empty
  std::optional<double> time;         ///< clock time, hours; instead of `hour`
  std::optional<double> longitude;    ///< radians
  std::optional<double> utc_offset;   ///< hours
};

/// The light of a scene, as a document gives it.
struct LightParameters {
  std::optional<double> latitude;    ///< radians
  std::optional<SunParameters> sun;  ///< unset: light from the zenith
  double sky = 0;                    ///< share of the directional light
  std::vector<Lamp> lamps;           ///< lamps of the scene
};

/// The rows of LightParameters; check_light has the rules between them.
const ParameterTable& light_table();
/// Reports settings that exclude each other, at `path`.
void check_light(const LightParameters& settings, const DocumentPath& path, ParameterReader& reader);

/// Sets the scene's light and its sun in pictures; `path` is the scene's. Warns where the sun gives no light. The
/// settings are those that check_light finds no fault with.
void light_scene(const LightParameters& settings, const DocumentPath& path, ParameterReader& reader, Scene& scene);

}  // namespace meristem
