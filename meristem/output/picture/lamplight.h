// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/output/picture/sampling.h"
#include "meristem/scene/light/light.h"

namespace meristem {

/// The lamps of a scene in pictures: warm white spheres the size of a fist. What falls on a surface a metre away that
/// faces one is its strength times the light of the clear midday sun.
class Lamplight {
 public:
  /// From a lamp to a position, as if nothing stood in the way.
  struct Ray {
    Vec3 toward;      ///< unit vector to a point of the lamp
    float distance;   ///< metres
    Vec3 irradiance;  ///< on a surface that faces it
  };

  explicit Lamplight(std::vector<Lamp> lamps = {}) : lamps_(std::move(lamps)) {}
  bool empty() const { return lamps_.empty(); }

  /// On a surface that could face all lamps at once.
  Vec3 irradiance(Vec3 position) const;

  /// Calls `visit(Ray)` for each of one or two lamps. Among more it takes one, drawn in proportion to its light, with
  /// the light of all. No lamp is taken to be nearer than `nearest` metres.
  template <class Visit>
  void for_each_ray(Vec3 position, float nearest, SampleStream& samples, Visit visit) const {
    if (lamps_.size() > 2) return visit(drawn_ray(position, nearest, samples));
    for (const Lamp& lamp : lamps_) visit(ray_to(lamp, position, nearest, samples.next()));
  }

 private:
  static Ray ray_to(const Lamp& lamp, Vec3 position, float nearest, Vec2 sample);
  Ray drawn_ray(Vec3 position, float nearest, SampleStream& samples) const;

  std::vector<Lamp> lamps_;
};

}  // namespace meristem
