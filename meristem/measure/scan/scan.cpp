// SPDX-License-Identifier: Apache-2.0
// In:  meshes with labels, an instrument, its stations. Out: points, in the order of the pulses.
//
// Each pulse is a bundle of rays that stand for equal shares of a Gaussian beam (beam.h) and spread from the exit
// aperture. The hits of the rays are sorted by distance and cut into returns. A return holds all surfaces within the
// instrument's resolution of its first surface, and its range is their mean by intensity. A beam on an edge therefore
// gives one point between two surfaces that are near each other, and two points if they are far apart. Waveforms, the
// reflectance of materials and multiple scattering are left out.
//
// Based on: S. Bechtold, B. Höfle, HELIOS: a multi-purpose LiDAR simulation framework, 2016. The source represents the
// beam as a bundle of rays. Here each ray stands for an equal share of the beam, so that the beam width is exact with
// any number of rays.
#include "meristem/measure/scan/scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/measure/scan/beam.h"
#include "meristem/measure/scan/scan_pattern.h"
#include "meristem/shape/rays/ray_scene.h"

namespace meristem {

namespace {

constexpr std::size_t kPulsesPerBlock = 1024;
constexpr std::size_t kBlocksAtOnce = 128;
constexpr std::size_t kMaxReturns = 15;  // maximum number of returns that file formats can count

/// The hit of one ray of a pulse.
struct Echo {
  float distance = 0;
  float strength = 0;  // share of the beam times the cosine of the incidence
  SurfaceLabel label;
};

/// A return: echoes that the instrument cannot separate.
struct Return {
  double range = 0;
  double true_range = 0;
  double strength = 0;
  SurfaceLabel label;
};

/// Returns the box around all surfaces of plants, or `whole` if no surface is known to belong to a plant.
Box bounds_of_plants(const MeshScene& meshes, const Box& whole) {
  const auto is_known = [](const MeshInstances& part) { return part.origin != nullptr; };
  if (std::ranges::all_of(meshes.meshes, is_known)) return whole;
  Box plants;
  for (const MeshInstances& part : meshes.meshes) {
    if (!is_known(part)) continue;
    MeshScene alone;
    alone.meshes.push_back(part);
    plants.add(alone.bounds());
  }
  return plants.is_empty() ? whole : plants;
}

/// The positions of the stations and the paths of the pulses.
struct Layout {
  Box box;  // box around all meshes
  ScanPattern pattern;
};

/// Throws InputError if there are too many pulses, or if a drone would fly into the scene.
Layout layout_of(const MeshScene& meshes, const ScanOptions& options) {
  const Box box = meshes.bounds();
  if (options.instrument.kind == ScannerClass::drone && !box.is_empty() && options.instrument.altitude <= box.high.y) {
    throw InputError(
        Diagnostic{.message = fmt::format("the drone would fly into the scene, which is {:.4g} m high", box.high.y),
                   .expected = "an altitude above it",
                   .path = "instrument.altitude"});
  }
  const Box plants = bounds_of_plants(meshes, box);
  ScanPattern pattern(
      options.instrument,
      options.stations.empty() ? stations_around(plants, options.around, options.instrument) : options.stations,
      options.target.value_or(plants.is_empty() ? Vec3(0) : plants.centre()), plants);
  if (pattern.pulse_count() > kMaxPulses) {
    throw InputError(Diagnostic{.message = fmt::format("{} pulses are too many", pattern.pulse_count()),
                                .expected = fmt::format("at most {}: a larger step, or fewer stations", kMaxPulses),
                                .path = "instrument.step"});
  }
  return {box, std::move(pattern)};
}

/// Merges sorted echoes into one return with the mean distance. The label is that of the surface with most of the
/// strength.
Return merged(std::span<const Echo> echoes) {
  Return made;
  double sum = 0;
  double best = -1;
  for (std::size_t k = 0; k < echoes.size(); ++k) {
    made.strength += echoes[k].strength;
    sum += double{echoes[k].strength} * echoes[k].distance;
    const auto is_like = [&](const Echo& other) { return other.label == echoes[k].label; };
    const auto before = echoes.first(k);
    if (std::find_if(before.begin(), before.end(), is_like) != before.end()) continue;
    double strength = 0;
    double way = 0;
    for (const Echo& other : echoes.subspan(k)) {
      if (!is_like(other)) continue;
      strength += other.strength;
      way += double{other.strength} * other.distance;
    }
    if (!(strength > best)) continue;
    best = strength;
    made.label = echoes[k].label;
    made.true_range = strength > 0 ? way / strength : echoes[k].distance;
  }
  made.range = made.strength > 0 ? sum / made.strength : echoes[0].distance;
  return made;
}

}  // namespace

struct Scanner::Parts {
  ScanOptions options;
  Box box;
  ScanPattern pattern;
  SurfaceLabels labels;
  std::optional<RayScene> rays;  // created after everything else is ready
  bool has_meshes;
  std::vector<Vec2> offsets;
  RandomKey turn_key;
  RandomKey noise_key;
  double spread = 0;    // spread of a ray that lies one beam radius off the axis, metres per metre
  double reach = 0;     // distance of the outermost ray from the axis, in beam radii
  double aperture = 0;  // radius of the beam at the aperture, metres

  Parts(PlantLabels&& plant, const MeshScene& meshes, const ScanOptions& given, Layout layout)
      : options(given),
        box(layout.box),
        pattern(std::move(layout.pattern)),
        labels(std::move(plant), meshes),
        has_meshes(!meshes.meshes.empty()),
        offsets(beam_offsets(given.instrument.rays)),
        turn_key(RandomKey(given.seed).child("scan").child("turn")),
        noise_key(RandomKey(given.seed).child("scan").child("noise")) {
    spread = math::tan(0.5e-3 * given.instrument.divergence);
    aperture = 0.5 * given.instrument.exit_diameter;
    for (const Vec2 offset : offsets) reach = std::max(reach, double{glm::length(offset)});
  }

  /// Returns false only if no ray of a pulse can meet the scene's box or the ground.
  bool may_meet(const Pulse& pulse) const {
    if (options.ground && pulse.direction.y < reach * spread) return true;
    if (!has_meshes) return false;
    const DVec3 low(box.low);
    const DVec3 high(box.high);
    const DVec3 farthest = glm::max(glm::abs(low - pulse.origin), glm::abs(high - pulse.origin));
    const double wide = reach * (aperture + spread * glm::length(farthest)) + 1e-6;
    double enter = 0;
    double leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const double from = low[axis] - wide - pulse.origin[axis];
      const double to = high[axis] + wide - pulse.origin[axis];
      const double rate = pulse.direction[axis];
      if (rate == 0) {
        if (from > 0 || to < 0) return false;
        continue;
      }
      enter = std::max(enter, std::min(from / rate, to / rate));
      leave = std::min(leave, std::max(from / rate, to / rate));
    }
    return enter <= leave;
  }

  /// Finds the nearest hit of a ray within the instrument's range. Returns false if there is no hit.
  bool trace(const Ray& ray, Echo& echo) const {
    std::optional<RayHit> hit;
    if (has_meshes) hit = rays->first_hit(ray);
    float distance = hit ? hit->distance : std::numeric_limits<float>::infinity();
    bool is_ground = false;
    if (options.ground && ray.direction.y < 0 && ray.origin.y > 0) {
      const float down = -ray.origin.y / ray.direction.y;
      is_ground = down < distance;
      distance = std::min(distance, down);
    }
    const auto nearest = static_cast<float>(options.instrument.nearest);
    const auto farthest = static_cast<float>(options.instrument.farthest);
    if (!(distance >= nearest && distance <= farthest)) return false;
    echo.distance = distance;
    Vec3 normal = kUp;
    if (is_ground) {
      echo.label = {.kind = SurfaceKind::ground, .component = labels.ground()};
    } else {
      normal = rays->face_normal(*hit);
      echo.label = labels.of(hit->part, hit->instance, hit->triangle, ray.origin + distance * ray.direction);
    }
    echo.strength = std::abs(glm::dot(normal, ray.direction)) / static_cast<float>(offsets.size());
    return true;
  }

  /// Collects the echoes of all rays of a pulse, sorted by distance. Equal distances keep the order of the rays.
  void gather(const Pulse& pulse, std::uint64_t number, std::vector<Echo>& echoes) const {
    echoes.clear();
    // Choose two directions at right angles to the axis, turned at random, so that the pattern of rays leaves no trace.
    const DVec3 axis = pulse.direction;
    const DVec3 helper = std::abs(axis.y) < 0.9 ? DVec3(kUp) : DVec3(1, 0, 0);
    const DVec3 first = glm::normalize(glm::cross(axis, helper));
    const DVec3 second = glm::cross(axis, first);
    const double angle = offsets.size() > 1 ? 2 * kPi * turn_key.uniform(number) : 0;
    const double cosine = math::cos(angle);
    const double sine = math::sin(angle);
    for (const Vec2 offset : offsets) {
      const DVec3 aside =
          (cosine * offset.x - sine * offset.y) * first + (sine * offset.x + cosine * offset.y) * second;
      const Ray ray{Vec3(pulse.origin + aperture * aside), Vec3(glm::normalize(axis + spread * aside))};
      Echo echo;
      if (trace(ray, echo)) echoes.push_back(echo);
    }
    // Insertion sort: there are few echoes, and std::stable_sort would allocate memory for each pulse.
    for (std::size_t k = 1; k < echoes.size(); ++k) {
      const auto is_nearer = [](const Echo& a, const Echo& b) { return a.distance < b.distance; };
      const auto place =
          std::upper_bound(echoes.begin(), echoes.begin() + static_cast<std::ptrdiff_t>(k), echoes[k], is_nearer);
      std::rotate(place, echoes.begin() + static_cast<std::ptrdiff_t>(k),
                  echoes.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    }
  }

  void add_points(std::uint64_t number, std::vector<Echo>& echoes, std::vector<ScanPoint>& points) const {
    const Pulse pulse = pattern.pulse(number);
    if (!may_meet(pulse)) return;
    gather(pulse, number, echoes);

    // Cut the echoes where they are farther apart than the instrument's resolution, and keep returns that are strong
    // enough.
    const ScanInstrument& instrument = options.instrument;
    std::array<Return, kMaxReturns> returns;
    std::size_t count = 0;
    const std::size_t max = std::min(kMaxReturns, static_cast<std::size_t>(instrument.returns));
    for (std::size_t begin = 0, end = 0; begin < echoes.size() && count < max; begin = end) {
      while (end < echoes.size() && echoes[end].distance - echoes[begin].distance <= instrument.resolution) ++end;
      const double share = static_cast<double>(end - begin) / static_cast<double>(offsets.size());
      if (share + 1e-9 < instrument.threshold) continue;
      returns[count++] = merged(std::span(echoes).subspan(begin, end - begin));
    }
    for (std::size_t k = 0; k < count; ++k) {
      const Return& found = returns[k];
      const double deviation = instrument.noise + instrument.noise_growth * found.range * found.range;
      const double noise = deviation > 0 ? deviation * noise_key.normal(number * kMaxReturns + k) : 0;
      const double range = std::max(0.0, found.range + noise);
      points.push_back({.position = Vec3(pulse.origin + range * pulse.direction),
                        .range = static_cast<float>(range),
                        .true_range = static_cast<float>(found.true_range),
                        .intensity = static_cast<float>(found.strength),
                        .label = found.label,
                        .pulse = number,
                        .station = pulse.station,
                        .number = static_cast<std::uint8_t>(k + 1),
                        .count = static_cast<std::uint8_t>(count)});
    }
  }
};

Scanner::Scanner(const Plant& plant, const SizeLimits& limits, const MeshScene& meshes, const ScanOptions& options,
                 Progress& progress) {
  Layout layout = layout_of(meshes, options);  // checks the options before any work
  auto parts = std::make_unique<Parts>(PlantLabels(plant, limits, progress), meshes, options, std::move(layout));
  parts->rays.emplace(meshes, progress);
  parts_ = std::move(parts);
}

Scanner::Scanner(PlantLabels&& labels, const MeshScene& meshes, const ScanOptions& options, Progress& progress) {
  auto parts = std::make_unique<Parts>(std::move(labels), meshes, options, layout_of(meshes, options));
  parts->rays.emplace(meshes, progress);
  parts_ = std::move(parts);
}

Scanner::~Scanner() = default;

std::uint64_t Scanner::pulse_count() const { return parts_->pattern.pulse_count(); }
const std::vector<Vec3>& Scanner::stations() const { return parts_->pattern.stations(); }
const SurfaceLabels& Scanner::labels() const { return parts_->labels; }
const ScanOptions& Scanner::options() const { return parts_->options; }
std::uint64_t Scanner::ray_bytes() const { return parts_->rays->bytes(); }

void Scanner::run(FunctionRef<void(std::span<const ScanPoint>)> take, Progress& progress) const {
  const std::uint64_t pulses = pulse_count();
  progress.begin("scanning", pulses);
  std::vector<std::vector<ScanPoint>> blocks(kBlocksAtOnce);
  for (std::uint64_t first = 0; first < pulses; first += kBlocksAtOnce * kPulsesPerBlock) {
    const std::uint64_t count = std::min<std::uint64_t>(pulses - first, kBlocksAtOnce * kPulsesPerBlock);
    parallel_for(count, kPulsesPerBlock, [&](std::size_t begin, std::size_t end) {
      std::vector<ScanPoint>& points = blocks[begin / kPulsesPerBlock];
      points.clear();
      std::vector<Echo> echoes;
      for (std::size_t k = begin; k < end; ++k) parts_->add_points(first + k, echoes, points);
      progress.advance(end - begin);
    });
    for (std::size_t k = 0; k * kPulsesPerBlock < count; ++k) {
      if (!blocks[k].empty()) take(blocks[k]);
    }
  }
}

void ShootsSeen::add(std::span<const ScanPoint> points) {
  for (const ScanPoint& point : points) {
    if (point.label.shoot != kNoShoot) is_seen_[point.label.shoot] = true;
  }
}

std::vector<std::uint32_t> ShootsSeen::numbers() const {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t k = 0; k < is_seen_.size(); ++k) {
    if (is_seen_[k]) numbers.push_back(k);
  }
  return numbers;
}

Scan take_scan(const Scanner& scanner, Progress& progress, std::uint64_t max_points) {
  Scan made{.components = scanner.labels().components(), .stations = scanner.stations()};
  ShootsSeen seen(scanner.labels().shoot_count());
  const auto take = [&](std::span<const ScanPoint> points) {
    if (made.points.size() + points.size() > max_points) {
      throw InputError(Diagnostic{.message = fmt::format("the scan has more than {} points", max_points),
                                  .expected = "a larger step, fewer stations, or a file, which holds any number",
                                  .path = "instrument.step"});
    }
    made.points.insert(made.points.end(), points.begin(), points.end());
    seen.add(points);
  };
  scanner.run(take, progress);
  made.shoots = seen.numbers();
  for (const std::uint32_t shoot : made.shoots) made.shoot_labels.push_back(scanner.labels().shoot_label(shoot));
  return made;
}

Scan scan(const Plant& plant, const SizeLimits& limits, const MeshScene& meshes, const ScanOptions& options,
          Progress& progress, std::uint64_t max_points) {
  return take_scan(Scanner(plant, limits, meshes, options, progress), progress, max_points);
}

}  // namespace meristem
