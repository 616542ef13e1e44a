// SPDX-License-Identifier: Apache-2.0
// The light that plants grow in: the sun over a day or a season, the sky, lamps. Growth and measures ask it which
// directions light reaches a position from, and how strong it is; whether anything stands in the way they ask the
// obstacles.
#pragma once

#include <limits>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/scene/light/sun.h"

namespace meristem {

/// Light that comes from one direction everywhere, as from very far away: the sun at one hour, a patch of the sky.
struct DirectionalLight {
  Vec3 toward = kUp;    ///< unit vector toward the light
  double strength = 1;  ///< share of all directional light
};

/// A light at one position that shines to all sides.
struct Lamp {
  Vec3 position{0};     ///< metres
  double strength = 1;  ///< one metre away, against all directional light; falls with the square of the distance
};

/// The light that comes to one position from one side.
struct LightRay {
  Vec3 toward = kUp;                                          ///< unit vector
  double distance = std::numeric_limits<double>::infinity();  ///< metres to the source of the light
  double strength = 1;                                        ///< at the position; 1 for all directional light
};

/// All light of a scene. The strengths of sun and sky sum to 1, unless the sun never rises.
struct Light {
  /// The sun's positions, one after another; at the zenith unless set.
  std::vector<DirectionalLight> sun{DirectionalLight{}};
  std::vector<DirectionalLight> sky;  ///< patches of the dome, above the horizon
  std::vector<Lamp> lamps;

  bool is_none() const { return sun.empty() && sky.empty() && lamps.empty(); }
  /// Calls `visit(LightRay)` for each light that shines on a position, in the order of the members.
  template <class Visit>
  void for_each_ray(Vec3 point, Visit visit) const {
    for (const DirectionalLight& one : sun) visit(LightRay{.toward = one.toward, .strength = one.strength});
    for (const DirectionalLight& one : sky) visit(LightRay{.toward = one.toward, .strength = one.strength});
    for (const Lamp& lamp : lamps) visit(ray_to(lamp, point));
  }

  /// The unit vector toward the middle of the directional light; up where there is none, or as much from all sides.
  Vec3 mean_direction() const;
  /// The light of a lamp at a position; nearer than a hand's breadth, as strong as at that distance.
  static LightRay ray_to(const Lamp& lamp, Vec3 point);
};

/// The sun's positions over a day, every `every_hours` hours from noon both ways as long as it is above the horizon, in
/// the order of time; strengths in proportion to their altitudes, 1 in all. Empty in the polar night. `latitude` in
/// radians.
std::vector<DirectionalLight> sun_of_day(double latitude, double day, double every_hours);
/// The sun's positions over several days, one day after another; strengths in proportion to the altitudes over all
/// days, 1 in all.
std::vector<DirectionalLight> sun_of_days(double latitude, const std::vector<double>& days, double every_hours);

/// A dome of even brightness: 40 patches of equal solid angle, strengths in proportion to the sine of the altitude
/// (what falls on level ground), `strength` in all. A dome turned by a quarter is the dome itself.
std::vector<DirectionalLight> even_sky(double strength);

}  // namespace meristem
