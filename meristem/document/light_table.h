// SPDX-License-Identifier: Apache-2.0
// The light of a document's scene: its parameters, and the light that they describe.
#pragma once

#include <optional>
#include <vector>

#include "meristem/graph/table/parameter.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// The position of the sun: a position in the sky, an hour of a day or of a clock, all hours of a day, or a season.
struct SunParameters {
  std::optional<double> azimuth;      ///< radians
  std::optional<double> altitude;     ///< radians
  std::optional<double> day;          ///< day of the year
  std::vector<int> days;              ///< first and last day of a season, or empty
  double every_days = 30;             ///< days between the positions of a season
  std::optional<double> every_hours;  ///< hours between positions over a day or a season; unset: a single hour, or the
                                      ///< default of seasons
  double sample_hour = 12;            ///< one of the sampled hours
  double hour = 12;                   ///< hour of a day without every_hours; also the hour of pictures
  std::string date;                   ///< date instead of a day; may be empty
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

/// Returns the rows of LightParameters. check_light() has the rules between them.
const ParameterTable& light_table();
/// Checks the light as a whole. Reports a sun with a day without a latitude, and more than 1000 lamps. `path` is the
/// path of the scene.
void check_light(const LightParameters& settings, const DocumentPath& path, ParameterReader& reader);

/// Sets the scene's light, its sun in pictures, its latitude and its clock. `path` is the scene's path. Warns if the
/// sun gives no light. The settings must have passed check_light() without faults.
void light_scene(const LightParameters& settings, const DocumentPath& path, ParameterReader& reader, Scene& scene);

}  // namespace meristem
