// SPDX-License-Identifier: Apache-2.0
// The light that plants grow in: the sun over a day or a season, the sky, lamps. Growth and measures ask it from where
// how much light comes to a position; whether anything stands in the way they ask the obstacles.
#pragma once

#include <limits>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/scene/light/sun.h"

namespace meristem {

/// Light from so far away that it comes from one direction everywhere: the sun at one hour, a part of the sky.
struct FarLight {
  Vec3 toward = kUp;    ///< unit vector to it
  double strength = 1;  ///< share of all far light
};

/// Shines to all sides.
struct Lamp {
  Vec3 position{0};     ///< metres
  double strength = 1;  ///< one metre away, against all far light together; falls with the square of the distance
};

/// The light that comes to one position from one side.
struct LightRay {
  Vec3 toward = kUp;                                          ///< unit vector
  double distance = std::numeric_limits<double>::infinity();  ///< metres to where it comes from
  double strength = 1;                                        ///< at the position; of all far light together 1
};

/// All light of a scene. The strengths of sun and sky sum to 1, unless the sun never rises.
struct Light {
  std::vector<FarLight> sun{FarLight{}};  ///< where it stands, one after another; from the zenith unless set
  std::vector<FarLight> sky;              ///< patches of the dome, above the horizon
  std::vector<Lamp> lamps;

  bool is_none() const { return sun.empty() && sky.empty() && lamps.empty(); }
  /// Calls `visit(LightRay)` for each light that shines on a position, in the order of the members.
  template <class Visit>
  void for_each_ray(Vec3 point, Visit visit) const {
    for (const FarLight& far : sun) visit(LightRay{.toward = far.toward, .strength = far.strength});
    for (const FarLight& far : sky) visit(LightRay{.toward = far.toward, .strength = far.strength});
    for (const Lamp& lamp : lamps) visit(ray_to(lamp, point));
  }

  /// The unit vector toward the middle of the far light; up where there is none, or as much from all sides.
  Vec3 mean_direction() const;
  /// The light of a lamp at a position; within a hand's breadth of it not stronger than there.
  static LightRay ray_to(const Lamp& lamp, Vec3 point);
};

/// The sun's positions over a day, every `every_hours` hours from noon both ways as long as it is above the horizon, in
/// the order of time; strengths in proportion to their altitudes, 1 in all. Empty in the polar night. `latitude` in
/// radians.
std::vector<FarLight> sun_of_day(double latitude, double day, double every_hours);
/// The same over several days, one after another; strengths in proportion to altitudes over all of them.
std::vector<FarLight> sun_of_days(double latitude, const std::vector<double>& days, double every_hours);

/// A dome of even brightness: 40 patches of equal solid angle, strengths in proportion to the sine of the altitude
/// (what falls on level ground), `strength` in all. The same seen from all four sides.
std::vector<FarLight> even_sky(double strength);

}  // namespace meristem
