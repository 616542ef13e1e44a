// SPDX-License-Identifier: Apache-2.0
// Follows paths of light from the camera through the scene with a fixed maximum of two bounces. Paths that carry little
// light are stopped at random, and the survivors are scaled up (Russian roulette). Sources are in the header.
#include "meristem/output/picture/path_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meristem/base/colour.h"

namespace meristem {

namespace {

constexpr int kBounces = 2;
constexpr float kBounceSpread = 0.25F;  // spread of rays after a bounce: light from all sides sees blurred textures
// Probability that a path continues, divided by its weight. Indirect light is gathered over many pixels, so few paths
// need to continue. At 5, the oak takes a quarter more time for equal noise. At 1.4, plain surfaces show patches.
constexpr float kKeenness = 2.5F;
// Minimum distance of lamps after a bounce, metres. Without it, a few paths would find the bright spot around a lamp on
// its support and cause specks.
constexpr float kNearestByBounce = 1;
constexpr int kMaxPasses = 64;  // surfaces that one ray passes through
constexpr auto kPiF = static_cast<float>(kPi);

/// Returns the colour of light that shines through a thin blade: yellower than the blade, as green absorbs twice.
Vec3 transmission_tint(Vec3 colour) {
  const float brightest = std::max({colour.r, colour.g, colour.b, 1e-6F});
  return colour * glm::mix(Vec3(1), colour / brightest, Vec3(0.0F, 0.0F, 0.6F)) * Vec3(1.25F, 1.1F, 1.0F);
}

/// Returns the mirror reflection of rough plant wax, with the distribution of Trowbridge and Reitz, times the cosine.
float gloss(Vec3 normal, Vec3 to_light, Vec3 to_viewer, float width) {
  const float n_l = glm::dot(normal, to_light);
  const float n_v = glm::dot(normal, to_viewer);
  if (n_l <= 0 || n_v <= 0) return 0;
  const Vec3 half = glm::normalize(to_light + to_viewer);
  const float n_h = glm::dot(normal, half);
  const float a2 = width * width;
  const float spread = n_h * n_h * (a2 - 1) + 1;
  const float distribution = a2 / (kPiF * spread * spread);
  const float masking =
      0.5F / (n_l * std::sqrt(n_v * n_v * (1 - a2) + a2) + n_v * std::sqrt(n_l * n_l * (1 - a2) + a2));
  const float grazing = 1 - std::max(0.0F, glm::dot(half, to_viewer));
  const float squared = grazing * grazing;
  const float fresnel = 0.04F + 0.96F * squared * squared * grazing;
  return distribution * masking * fresnel * n_l;
}

}  // namespace

PathTracer::PathTracer(const MeshScene& meshes, const RayScene& rays, Daylight light, std::optional<Ground> ground,
                       Lamplight lamps, Air air)
    : rays_(rays), light_(std::move(light)), ground_(ground), lamps_(std::move(lamps)), air_(air) {
  for (const MeshInstances& part : meshes.meshes) {
    const Material& material = meshes.materials[part.material];
    const float roughness = std::clamp(material.roughness, 0.2F, 1.0F);
    Look look{material.tint(),       std::clamp(material.translucency, 0.0F, 1.0F),
              roughness * roughness, std::clamp(material.opacity, 0.0F, 1.0F),
              material.two_sided,    nullptr};
    has_glass_ = has_glass_ || look.opacity < 1;
    if (const Texture* texture = material.texture.get(); texture != nullptr && !texture->colour.is_empty()) {
      look.texture = &textures_.try_emplace(texture, *texture).first->second;
    }
    looks_.push_back(look);
  }
}

/// Returns the texture's colour at a hit. Its normal map turns the point's normal.
Vec3 PathTracer::textured(const Look& look, const RayHit& hit, const Ray& ray, SurfacePoint& point) const {
  const TextureMapping place = rays_.texture_mapping(hit);
  // At a low angle, the footprint of a ray is long and narrow. Average over a square of equal area instead.
  const float cosine = std::max(0.05F, std::abs(glm::dot(point.normal, ray.direction)));
  const float width = ray.spread * hit.distance * place.uvs_per_metre / std::sqrt(cosine);
  if (look.texture->has_normals()) {
    const Vec3 mapped = look.texture->normal(place.uv, width);
    const Vec3 along_u = place.along_u - glm::dot(place.along_u, point.normal) * point.normal;
    const Vec3 along_v = place.along_v - glm::dot(place.along_v, point.normal) * point.normal;
    point.normal = normalized_or(mapped.x * normalized_or(along_u, Vec3(0)) +
                                     mapped.y * normalized_or(along_v, Vec3(0)) + mapped.z * point.normal,
                                 point.normal);
  }
  return look.texture->colour(place.uv, width);
}

PathTracer::Vertex PathTracer::surface_vertex(const Ray& ray, const RayHit& hit) const {
  SurfacePoint point = rays_.surface_point(hit);
  const Look& look = looks_[hit.part];
  Vertex vertex;
  vertex.position = point.position;
  const bool is_front = glm::dot(point.face_normal, ray.direction) <= 0;
  vertex.face_normal = is_front ? point.face_normal : -point.face_normal;
  const bool is_behind = glm::dot(point.normal, vertex.face_normal) < 0;
  // On solid bodies, the smooth normal decides which side is lit. Whole triangles would show as steps at the shadow's
  // edge. Shadow rays still find the body itself.
  vertex.facing = is_front && !look.is_thin && !is_behind ? point.normal : vertex.face_normal;
  Vec3 colour = look.tint * rays_.tint(hit);
  if (look.texture != nullptr) colour *= textured(look, hit, ray, point);
  colour = glm::clamp(colour, Vec3(0), Vec3(1));
  vertex.normal = is_behind ? -point.normal : point.normal;
  // A normal that leans away from the viewer would make a bright rim. Turn it until it is seen edge on.
  const float away = glm::dot(vertex.normal, ray.direction);
  if (away > 0) vertex.normal = normalized_or(vertex.normal - 1.01F * away * ray.direction, vertex.face_normal);
  vertex.lifted = point.position;
  if (is_front && !look.is_thin) vertex.lifted += point.smooth_offset;
  vertex.reflected = colour * (1 - look.through);
  vertex.transmitted = look.through > 0 ? glm::min(transmission_tint(colour), Vec3(1)) * look.through : Vec3(0);
  vertex.gloss_width = look.gloss_width;
  vertex.cover = 1;
  vertex.sight = Sight::surface;
  return vertex;
}

PathTracer::Vertex PathTracer::ground_vertex(const Ray& ray, float distance) const {
  Vertex vertex;
  vertex.position = ray.origin + distance * ray.direction;
  vertex.position.y = ground_->height;
  vertex.lifted = vertex.position;
  vertex.face_normal = kUp;
  vertex.normal = kUp;
  vertex.facing = kUp;
  vertex.reflected = ground_->colour;
  vertex.transmitted = Vec3(0);
  vertex.gloss_width = 0;
  vertex.sight = Sight::ground;
  const float away =
      glm::distance(Vec2(vertex.position.x, vertex.position.z), Vec2(ground_->centre.x, ground_->centre.z)) /
      ground_->fade_distance;
  vertex.cover = 1 / (1 + away * away * away);
  return vertex;
}

std::optional<PathTracer::Vertex> PathTracer::next_vertex(const Ray& ray, SampleStream& samples) const {
  std::optional<RayHit> hit = rays_.first_hit(ray);
  // Let a share of the rays pass through glass and thin petals.
  Ray onward = ray;
  float passed = 0;
  for (int k = 0; hit && k < kMaxPasses && looks_[hit->part].opacity < 1; ++k) {
    if (samples.next().x < looks_[hit->part].opacity) break;
    const Vec3 position = onward.origin + hit->distance * onward.direction;
    const float step = hit->distance + RayScene::clearance(position);
    onward.origin += step * onward.direction;
    passed += step;
    hit = rays_.first_hit(onward);
  }
  if (hit) hit->distance += passed;
  if (ground_ && ray.direction.y < 0 && ray.origin.y > ground_->height) {
    const float distance = (ground_->height - ray.origin.y) / ray.direction.y;
    if (!hit || distance < hit->distance) return ground_vertex(ray, distance);
  }
  if (!hit) return std::nullopt;
  return surface_vertex(ray, *hit);
}

Vec3 PathTracer::sunlight(const Vertex& vertex, Vec3 to_viewer, Vec2 sample) const {
  if (!light_.has_sun()) return Vec3(0);
  const Vec3 to_sun = cone_direction(light_.sun_direction(), light_.sun_angular_radius(), sample);
  return share_seen(vertex, to_viewer, to_sun, std::numeric_limits<float>::infinity()) * light_.sun_irradiance();
}

Vec3 PathTracer::lamplight(const Vertex& vertex, Vec3 to_viewer, bool is_seen, SampleStream& samples) const {
  Vec3 seen(0);
  lamps_.for_each_ray(vertex.position, is_seen ? 0 : kNearestByBounce, samples, [&](const Lamplight::Ray& ray) {
    seen += share_seen(vertex, to_viewer, ray.toward, ray.distance) * ray.irradiance;
  });
  return seen;
}

/// Returns the share of the light from a direction and distance that reaches the viewer.
Vec3 PathTracer::share_seen(const Vertex& vertex, Vec3 to_viewer, Vec3 to_light, float distance) const {
  const bool shines_through = glm::dot(to_light, vertex.facing) < 0;
  const float cosine = glm::dot(to_light, vertex.normal) * (shines_through ? -1.0F : 1.0F);
  const Vec3 share = shines_through ? vertex.transmitted : vertex.reflected;
  if (cosine <= 0 || share == Vec3(0)) return Vec3(0);
  const Vec3 side = shines_through ? -vertex.face_normal : vertex.face_normal;
  const Ray shadow{vertex.lifted + RayScene::clearance(vertex.position) * side, to_light};
  const float clear = clearness(shadow, distance);
  if (clear == 0) return Vec3(0);
  Vec3 given = share * (cosine / kPiF);
  if (!shines_through && vertex.gloss_width > 0) {
    given += Vec3(gloss(vertex.normal, to_light, to_viewer, vertex.gloss_width));
  }
  return clear * given;
}

/// Returns the share of light that passes along a ray, up to a distance.
float PathTracer::clearness(Ray ray, float distance) const {
  if (!has_glass_) return rays_.is_blocked(ray, distance) ? 0 : 1;
  float clear = 1;
  for (int k = 0; k < kMaxPasses; ++k) {
    const std::optional<RayHit> hit = rays_.first_hit(ray);
    if (!hit || hit->distance > distance) return clear;
    clear *= 1 - looks_[hit->part].opacity;
    if (clear == 0) return 0;
    const Vec3 position = ray.origin + hit->distance * ray.direction;
    const float step = hit->distance + RayScene::clearance(position);
    ray.origin += step * ray.direction;
    distance -= step;
  }
  return 0;
}

Seen PathTracer::trace(Ray ray, SampleStream& samples) const {
  Seen seen;
  Vec3 weight(1);
  for (int bounce = 0;; ++bounce) {
    std::optional<Vertex> vertex = next_vertex(ray, samples);
    if (!vertex) {
      if (bounce > 0) seen.indirect += weight * light_.falling(ray.direction);
      return seen;
    }
    if (bounce == 0) {
      seen.cover = vertex->cover;
      weight *= vertex->cover;
      if (air_.haze) {
        // Haze adds the light of the sky at the horizon.
        const float clear = std::exp(-glm::distance(ray.origin, vertex->position) / *air_.haze);
        const Vec3 level = normalized_or(Vec3(ray.direction.x, 0, ray.direction.z), ray.direction);
        seen.direct += (1 - clear) * weight * light_.seen(level);
        weight *= clear;
      }
      seen.albedo = weight * (vertex->reflected + vertex->transmitted);
      seen.sight = vertex->sight;
      seen.normal = vertex->normal;
      seen.distance = glm::distance(ray.origin, vertex->position);
    } else {
      vertex->gloss_width = 0;  // when a matt surface reflects the path, gloss adds only noise
    }
    Vec3& light = bounce == 0 ? seen.direct : seen.indirect;
    light += weight * sunlight(*vertex, -ray.direction, samples.next());
    if (!lamps_.empty()) light += weight * lamplight(*vertex, -ray.direction, bounce == 0, samples);
    if (bounce == kBounces) return seen;

    // Continue on one side or the other, in proportion to the light.
    const float reflected = luminance(vertex->reflected);
    const float transmitted = luminance(vertex->transmitted);
    if (reflected + transmitted <= 0) return seen;
    const float share = reflected / (reflected + transmitted);
    Vec2 sample = samples.next();
    const bool reflects = sample.x < share;
    sample.x = reflects ? sample.x / share : (sample.x - share) / (1 - share);
    weight *= reflects ? vertex->reflected / share : vertex->transmitted / (1 - share);
    // Continue only few of the paths that carry little light, and give them the weight of the stopped paths.
    const float survival = std::clamp(kKeenness * luminance(weight), 0.1F, 1.0F);
    if (survival < 1 && samples.next().x >= survival) return seen;
    weight /= survival;
    const float side = reflects ? 1 : -1;
    ray.spread = kBounceSpread;
    ray.direction = glm::normalize(cosine_direction(side * vertex->normal, sample));
    // If the interpolated normal lets a direction dip below the triangle, the surface shadows itself.
    if (side * glm::dot(ray.direction, vertex->face_normal) <= 0) return seen;
    ray.origin = vertex->position + side * RayScene::clearance(vertex->position) * vertex->face_normal;
  }
}

}  // namespace meristem
