// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/output/picture/sampling.h"
#include "meristem/scene/light/light.h"

namespace meristem {

/// The lamps of a scene in pictures: warm white spheres the size of a fist, or of their own colour and size. A surface
/// that faces a lamp a metre away receives the lamp's strength times the light of the clear midday sun.
class Lamplight {
 public:
  /// Light from a lamp to a position, without obstacles.
  struct Ray {
    Vec3 toward;      ///< unit vector to a point of the lamp
    float distance;   ///< metres
    Vec3 irradiance;  ///< irradiance of a surface that faces the lamp
  };

  explicit Lamplight(std::vector<Lamp> lamps = {}) : lamps_(std::move(lamps)) {}
  bool empty() const { return lamps_.empty(); }

  /// Returns the irradiance of a surface that would face all lamps at once.
  Vec3 irradiance(Vec3 position) const;

  /// Calls `visit(Ray)` for each of one or two lamps. With more lamps, draws one in proportion to its light and visits
  /// it with a light whose mean is that of all. Lamps that are nearer than `nearest` metres count as if they were at
  /// this distance.
  template <class Visit>
  void for_each_ray(Vec3 position, float nearest, SampleStream& samples, Visit visit) const {
    if (lamps_.size() > 2) return visit(drawn_ray(position, nearest, samples));
    for (const Lamp& lamp : lamps_) visit(ray_to(lamp, position, nearest, samples.next()));
  }

 private:
  static Vec3 irradiance_at_one(const Lamp& lamp);
  static Ray ray_to(const Lamp& lamp, Vec3 position, float nearest, Vec2 sample);
  Ray drawn_ray(Vec3 position, float nearest, SampleStream& samples) const;

  std::vector<Lamp> lamps_;
};

}  // namespace meristem
