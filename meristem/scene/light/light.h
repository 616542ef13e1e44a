// SPDX-License-Identifier: Apache-2.0
// The light that plants grow in: the sun over a day or a season, the sky, and lamps. It provides the direction and
// strength of the light at a position. The obstacles provide shadows.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/scene/light/sun.h"

namespace meristem {

/// Light with the same direction everywhere, from an infinitely distant source: the sun at one hour, or a patch of the
/// sky.
struct DirectionalLight {
  Vec3 toward = kUp;    ///< unit vector toward the light
  double strength = 1;  ///< share of all directional light
};

/// A lamp at a position. It shines in all directions, or as a spot into a cone.
struct Lamp {
  Vec3 position{0};  ///< metres
  /// Strength at one metre, relative to all directional light; falls with the square of the distance.
  double strength = 1;
  std::optional<Vec3> colour = std::nullopt;    ///< sRGB, in pictures; its brightness has no effect; unset: warm white
  std::optional<Vec3> target = std::nullopt;    ///< point on the axis of the cone, metres; unset: all directions
  double angle = kPi / 3;                       ///< opening angle of the cone, radians; its edge fades over a tenth
  std::optional<double> radius = std::nullopt;  ///< metres, in pictures; larger: softer shadows; unset: a fist

  /// Returns the share of `strength` that shines toward `point`: 1 inside the cone, 0 outside.
  double share_toward(Vec3 point) const;
};

/// The light that reaches one position from one source.
struct LightRay {
  Vec3 toward = kUp;                                          ///< unit vector
  double distance = std::numeric_limits<double>::infinity();  ///< metres to the source
  double strength = 1;  ///< at the position; 1 is as strong as all directional light together
};

/// All light of a scene. The strengths of sun and sky sum to 1, unless the sun never rises.
struct Light {
  /// The sun's positions in sequence. Default: at the zenith.
  std::vector<DirectionalLight> sun{DirectionalLight{}};
  std::vector<DirectionalLight> sky;  ///< patches of the sky dome, above the horizon
  std::vector<Lamp> lamps;            ///< lamps, in any order

  bool is_none() const { return sun.empty() && sky.empty() && lamps.empty(); }  ///< true if nothing shines
  /// Calls `visit(LightRay)` for each light that shines on a position, in the order of the members.
  template <class Visit>
  void for_each_ray(Vec3 point, Visit visit) const {
    for (const DirectionalLight& one : sun) visit(LightRay{.toward = one.toward, .strength = one.strength});
    for (const DirectionalLight& one : sky) visit(LightRay{.toward = one.toward, .strength = one.strength});
    for (const Lamp& lamp : lamps) visit(ray_to(lamp, point));
  }

  /// Returns the unit vector toward the mean of the directional light. Returns up if there is no such light, or if it
  /// is equal from all sides.
  Vec3 mean_direction() const;
  /// Returns the light of a lamp at a position. At distances below 0.1 m, the light is as strong as at 0.1 m.
  static LightRay ray_to(const Lamp& lamp, Vec3 point);
};

/// Returns the sun's positions over a day in the order of time. It samples every `every_hours` hours, from noon in both
/// directions, as long as the sun is above the horizon. Strengths are proportional to the altitudes and sum to 1. Empty
/// in the polar night. `latitude` is in radians.
std::vector<DirectionalLight> sun_of_day(double latitude, double day, double every_hours);
/// Returns the sun's positions over several days, one day after another. Strengths are proportional to the altitudes
/// over all days and sum to 1.
std::vector<DirectionalLight> sun_of_days(double latitude, const std::vector<double>& days, double every_hours);

/// Returns a sky dome of uniform brightness: 40 patches of equal solid angle. Strengths are proportional to the sine of
/// the altitude (the light on level ground) and sum to `strength`. The dome is symmetric under quarter turns about the
/// vertical.
std::vector<DirectionalLight> even_sky(double strength);

}  // namespace meristem
