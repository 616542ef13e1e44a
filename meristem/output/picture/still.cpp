// SPDX-License-Identifier: Apache-2.0
// Renders a picture tile by tile. Rows of tiles are exposed ahead, because a tile's pixels gather indirect light from
// the tiles around it. The result is tone mapped and dithered to 8 bits.
#include "meristem/output/picture/still.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <immintrin.h>

#include "meristem/base/colour.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/output/picture/camera.h"
#include "meristem/output/picture/film.h"
#include "meristem/output/picture/free_side.h"
#include "meristem/output/picture/ground.h"
#include "meristem/output/picture/obstacle_meshes.h"
#include "meristem/output/picture/path_tracer.h"
#include "meristem/output/picture/photographer.h"
#include "meristem/output/picture/tone_map.h"
#include "meristem/shape/scene/scene_size.h"

namespace meristem {

namespace {

constexpr int kTilesAtOnce = 1024;  // half a gigabyte

/// While this object exists, denormal numbers count as 0 in this thread, as Embree requires.
class FlushToZero {
 public:
  FlushToZero() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }
  ~FlushToZero() { _mm_setcsr(before_); }
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

 private:
  unsigned before_;
};

void check_range(const char* path, int value, int max) {
  if (value >= 1 && value <= max) return;
  Diagnostic error;
  error.message = fmt::format("{} is out of range", value);
  error.expected = fmt::format("1 to {}", max);
  error.path = path;
  throw InputError(std::move(error));
}

/// Returns a number in [0, 1) that is spread over neighbouring pixels, so that smooth skies show no steps in 8 bits.
float dither(int x, int y) {
  return unit_float(mixed_bits(static_cast<std::uint32_t>(x) * 0x9E3779B1U ^ mixed_bits(y)));
}

/// Converts the mean of a pixel's samples to bytes.
class Developer {
 public:
  Developer(const CameraView& view, const StillOptions& options, float exposure)
      : background_(view.background.value_or(Vec3(0))),
        shows_background_(view.background.has_value()),
        exposure_(exposure),
        keeps_alpha_(options.transparent) {}

  bool shows_sky() const { return !keeps_alpha_ && !shows_background_; }

  void develop(Vec3 light, float cover, float noise, std::uint8_t* rgba) const {
    const Vec3 colour = cover > 0 ? tone_mapped(exposure_ * light / cover) : Vec3(0);
    const bool is_flat = !keeps_alpha_ && !shows_sky();
    const Vec3 shown = is_flat ? glm::mix(background_, colour, cover) : colour;
    const float rounding = cover > 0 ? noise : 0.5F;
    for (int c = 0; c < 3; ++c) rgba[c] = byte(shown[c], rounding);
    rgba[3] = keeps_alpha_ ? byte(cover, 0.5F) : 255;
  }

 private:
  static std::uint8_t byte(float value, float rounding) {
    return static_cast<std::uint8_t>(std::clamp(std::floor(255 * value + rounding), 0.0F, 255.0F));
  }

  Vec3 background_;
  bool shows_background_;
  float exposure_;
  bool keeps_alpha_;
};

Air air_of(const CameraView& view, const Sky& sky) {
  Air air;
  if (view.haze) air.haze = static_cast<float>(*view.haze);
  if (view.clouds > 0) {
    const Vec3 white = Vec3(0.8F / static_cast<float>(kPi));
    const Vec3 dome = sky.dome_irradiance();
    air.clouds =
        Clouds(view.clouds, sky.sun_direction(), white * (0.75F * sky.sun_irradiance() + dome), 0.6F * white * dome);
  }
  return air;
}

/// Returns the mean brightness of lamps on the visible surfaces, if half of them are turned away or in the shade. Roots
/// are averaged, so that a bright spot beside a lamp does not hide the rest.
float metered(const Lamplight& lamps, const RayScene& rays, const Camera& camera) {
  constexpr int kRays = 48;  // across the picture and down
  double sum = 0;
  int hits = 0;
  for (int k = 0; k < kRays * kRays; ++k) {
    const Vec2 film((static_cast<float>(k % kRays) + 0.5F) / kRays, (static_cast<float>(k / kRays) + 0.5F) / kRays);
    const Ray ray{camera.position(), camera.direction(2.0F * film - 1.0F)};
    const std::optional<RayHit> hit = rays.first_hit(ray);
    if (!hit) continue;
    sum += std::sqrt(luminance(lamps.irradiance(ray.origin + hit->distance * ray.direction)));
    ++hits;
  }
  const double root = hits > 0 ? sum / hits : 0;
  return static_cast<float>(0.5 * root * root);
}

}  // namespace

void check_still_options(const StillOptions& options) {
  check_range("output.size[0]", options.width, 16384);
  check_range("output.size[1]", options.height, 16384);
  check_range("output.samples", options.samples, 65536);
}

namespace {

/// The camera of a picture, and the ground below the plants. Both depend on the plants, not on the obstacles.
struct Framing {
  Camera camera;
  Ground ground;
};

bool shows_obstacles(const Scene& scene, const StillOptions& options) {
  return !options.transparent && has_visible(scene.obstacles);
}

/// Returns the camera and the ground for the plants, or for the obstacles if there are no plants.
Framing framing_of(const MeshScene& plants, const Scene& scene, const CameraView& view, const StillOptions& options,
                   const Progress& progress) {
  const bool has_obstacles = shows_obstacles(scene, options);
  const MeshScene alone = plants.meshes.empty() && has_obstacles ? with_obstacles({}, scene.obstacles) : MeshScene();
  const MeshScene& framed = plants.meshes.empty() ? alone : plants;
  const double aspect = aspect_of(options);
  const CameraView seen = has_obstacles ? view_past_obstacles(plants, scene.obstacles, view, aspect, progress) : view;
  return {place_camera(framed, seen, aspect), ground_below(framed, scene)};
}

/// Returns a picture of the whole scene.
Image exposed(const MeshScene& shown, const Framing& framing, const Scene& scene, const CameraView& view,
              const StillOptions& options, Progress& progress) {
  Image image{options.width, options.height, {}};
  image.rgba.resize(std::size_t{4} * options.width * options.height);

  // Set up light and ground.
  const RayScene rays(shown, progress);
  const Sky sky(scene.sun);
  const bool shows_ground = options.ground && !options.transparent;
  const Lamplight lamps(scene.light.lamps);
  const auto& [camera, ground] = framing;
  const PathTracer tracer(shown, rays, Daylight(sky, ground.colour),
                          shows_ground ? std::optional(ground) : std::nullopt, lamps, air_of(view, sky));
  const float brightness = exposure(sky, lamps.empty() ? 0 : metered(lamps, rays, camera));
  const Developer developer(view, options, brightness);
  const Photographer photographer(tracer, camera,
                                  {.width = options.width,
                                   .height = options.height,
                                   .samples = options.samples,
                                   .exposure = brightness,
                                   .shows_sky = developer.shows_sky(),
                                   .is_even = options.even});

  // Repeat: expose some rows of tiles, and develop the rows whose next row is exposed.
  Film film(options.width, options.height, photographer.pixel_angle());
  const int columns = film.columns();
  const int rows_at_once = std::max(1, kTilesAtOnce / columns);
  const auto for_each_tile = [&](int begin, int end, const auto& visit) {
    parallel_for(static_cast<std::size_t>(columns) * (end - begin), 1, [&](std::size_t tile, std::size_t) {
      const FlushToZero flush_to_zero;
      visit(static_cast<int>(tile) % columns, begin + static_cast<int>(tile) / columns);
    });
  };
  int developed = 0;
  for (int exposed = 0; exposed < film.rows();) {
    const int end = std::min(exposed + rows_at_once, film.rows());
    for_each_tile(exposed, end, [&](int column, int row) {
      const Tile tile = film.tile(column, row);
      film.keep(column, row, photographer.expose(tile, progress));
      progress.advance(static_cast<std::uint64_t>(tile.right - tile.left) * (tile.bottom - tile.top));
    });
    exposed = end;
    const int ready = exposed == film.rows() ? exposed : exposed - 1;
    for_each_tile(developed, ready, [&](int column, int row) {
      const Tile tile = film.tile(column, row);
      const std::vector<PixelLight> pixels = film.pixels(column, row);
      const PixelLight* pixel = pixels.data();
      for (int y = tile.top; y < tile.bottom; ++y) {
        for (int x = tile.left; x < tile.right; ++x) {
          const float cover = developer.shows_sky() ? 1 : pixel->cover;
          std::uint8_t* rgba = image.rgba.data() + 4 * (std::size_t{1} * y * options.width + x);
          developer.develop(pixel->light, cover, dither(x, y), rgba);
          ++pixel;
        }
      }
    });
    for (int row = std::max(0, developed - 1); row < ready - 1; ++row) film.drop(row);
    developed = ready;
  }
  return image;
}

void begin(const StillOptions& options, Progress& progress) {
  check_still_options(options);
  progress.begin("rendering", std::uint64_t{1} * options.width * options.height);
}

}  // namespace

Image render_still(const MeshScene& meshes, const Scene& scene, const CameraView& view, const StillOptions& options,
                   Progress& progress) {
  if (shows_obstacles(scene, options)) return render_still(MeshScene(meshes), scene, view, options, progress);
  begin(options, progress);
  return exposed(meshes, framing_of(meshes, scene, view, options, progress), scene, view, options, progress);
}

Image render_still(MeshScene&& meshes, const Scene& scene, const CameraView& view, const StillOptions& options,
                   Progress& progress) {
  begin(options, progress);
  const Framing framing = framing_of(meshes, scene, view, options, progress);
  MeshScene shown = std::move(meshes);
  if (distinct_size(shown) > RaySceneOptions().large_from) free_tangents(shown);
  if (shows_obstacles(scene, options)) shown = with_obstacles(std::move(shown), scene.obstacles);
  return exposed(shown, framing, scene, view, options, progress);
}

}  // namespace meristem
