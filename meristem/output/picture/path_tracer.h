// SPDX-License-Identifier: Apache-2.0
// Computes the light along one ray. At every surface, shadow rays collect the light of sun and lamps. For the sky and
// other surfaces, the path continues twice in random directions with a cosine distribution. Surfaces are matt with a
// slight gloss in the sun, and thin blades let a part of the light through. Paths end after the second bounce: leaves
// reflect a tenth of the light, so a third bounce would add less than a hundredth.
//
// Based on: J. Kajiya: The rendering equation (1986); J. Hanika: Hacking the shadow terminator (Ray Tracing Gems II,
// 2021); E. Heitz: Understanding the masking-shadowing function (2014) for the gloss.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "meristem/output/picture/clouds.h"
#include "meristem/output/picture/daylight.h"
#include "meristem/output/picture/ground.h"
#include "meristem/output/picture/lamplight.h"
#include "meristem/output/picture/sampling.h"
#include "meristem/output/picture/texture_sampler.h"
#include "meristem/shape/rays/ray_scene.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// The air between the camera and the surfaces, and the clouds behind them.
struct Air {
  std::optional<float> haze;  ///< distance in metres over which haze hides two thirds of the light; unset: clear air
  Clouds clouds;
};

enum class Sight { nothing, surface, ground };

/// The light along one ray. Light, albedo and cover are weighted by how much of the background is hidden.
struct Seen {
  Vec3 direct{0};    ///< light directly from sun and lamps to the hit surface, plus the haze before it
  Vec3 indirect{0};  ///< light from the sky and from other surfaces to the hit surface
  Vec3 albedo{0};    ///< share of indirect light that is reflected, on both sides
  Vec3 normal{0};    ///< normal of the hit surface, on the visible side
  float distance = 0;
  float cover = 0;
  Sight sight = Sight::nothing;

  Vec3 light() const { return direct + indirect; }
};

class PathTracer {
 public:
  /// `meshes` and `rays` must outlive this object.
  PathTracer(const MeshScene& meshes, const RayScene& rays, Daylight light, std::optional<Ground> ground,
             Lamplight lamps = Lamplight(), Air air = {});

  /// Follows one path. The background is not part of the light.
  Seen trace(Ray ray, SampleStream& samples) const;
  /// Returns the light from a direction in which nothing stands.
  Vec3 background(Vec3 direction) const { return air_.clouds.over(direction, light_.seen(direction)); }
  const Daylight& light() const { return light_; }

 private:
  struct Look {
    Vec3 tint;          ///< linear factor on the texture's colour, or the colour itself
    float through;      ///< share of the light that passes to the other side
    float gloss_width;  ///< alpha of the microfacet distribution
    float opacity;      ///< share of the rays that the surface stops
    bool is_thin;
    const TextureSampler* texture;  ///< null for a single colour
  };
  struct Vertex {
    Vec3 position;
    Vec3 lifted;       ///< start of shadow rays
    Vec3 face_normal;  ///< normal on the side from which the ray came
    Vec3 normal;
    Vec3 facing;  ///< normal that decides which side the light is on
    Vec3 reflected;
    Vec3 transmitted;
    float gloss_width;  ///< 0 for no gloss
    float cover;        ///< below 1 where the ground fades
    Sight sight;
  };

  std::optional<Vertex> next_vertex(const Ray& ray, SampleStream& samples) const;
  float clearness(Ray ray, float distance) const;
  Vec3 textured(const Look& look, const RayHit& hit, const Ray& ray, SurfacePoint& point) const;
  Vertex surface_vertex(const Ray& ray, const RayHit& hit) const;
  Vertex ground_vertex(const Ray& ray, float distance) const;
  Vec3 sunlight(const Vertex& vertex, Vec3 to_viewer, Vec2 sample) const;
  Vec3 lamplight(const Vertex& vertex, Vec3 to_viewer, bool is_seen, SampleStream& samples) const;
  Vec3 share_seen(const Vertex& vertex, Vec3 to_viewer, Vec3 to_light, float distance) const;

  const RayScene& rays_;
  Daylight light_;
  std::optional<Ground> ground_;
  Lamplight lamps_;
  Air air_;
  std::vector<Look> looks_;  ///< one per part of the scene
  bool has_glass_ = false;   ///< true if rays pass through some surface
  std::map<const Texture*, TextureSampler> textures_;
};

}  // namespace meristem
