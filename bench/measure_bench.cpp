// SPDX-License-Identifier: Apache-2.0
// The lit share of a crown's hull among obstacles. Counters: rays a second, the share, and `to_plain`, the time of
// plain counting (random places on the whole hull, each ray tested against every triangle of hull and obstacles) over
// ours, a ray, measured in the same run on one thread.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <benchmark/benchmark.h>

#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/measure/convex_hull.h"
#include "meristem/measure/crown_light.h"
#include "meristem/measure/surface_places.h"
#include "meristem/shape/primitives.h"

namespace {

using meristem::DVec3;
using meristem::FarLight;
using meristem::Mesh;
using meristem::RandomKey;
using meristem::Scene;
using meristem::Vec3;

/// A crown of a few metres above the origin.
Mesh crown_hull() {
  const RandomKey key(3);
  std::vector<Vec3> nodes;
  for (std::uint64_t k = 0; k < 6000; ++k) {
    nodes.push_back(Vec3(0, 2, 0) + static_cast<float>(key.uniform(k, 0, 1.6)) * key.child("way").direction(k));
  }
  return meristem::convex_hull(nodes);
}

/// A ball of about a thousand triangles.
meristem::Obstacle ball(Vec3 centre, double radius) {
  meristem::Obstacle obstacle;
  const Mesh sphere = meristem::make_sphere(radius, 32);
  for (const Vec3 position : sphere.positions) obstacle.mesh.positions.emplace_back(centre + position);
  obstacle.mesh.triangles = sphere.triangles;
  return obstacle;
}

/// Obstacles in a ring about the origin, and the sun of a May day in London or of its ten o'clock.
Scene surrounded(int obstacles, bool whole_day) {
  Scene scene;
  std::vector<meristem::Obstacle> bodies;
  for (int k = 0; k < obstacles; ++k) {
    const double angle = 2 * meristem::kPi * k / obstacles;
    bodies.push_back(ball(5.0F * Vec3(std::sin(angle), 0.6, std::cos(angle)), 1.4));
  }
  scene.obstacles = meristem::Obstacles(bodies);
  scene.light.sun = meristem::sun_of_day(meristem::radians(51.5), 126, 1);
  if (!whole_day) scene.light.sun = {scene.light.sun[5]};
  return scene;
}

/// Whether a ray from `origin` meets a triangle (Moeller and Trumbore).
bool meets(DVec3 origin, DVec3 direction, DVec3 a, DVec3 b, DVec3 c) {
  const DVec3 u = b - a;
  const DVec3 v = c - a;
  const DVec3 p = glm::cross(direction, v);
  const double determinant = glm::dot(u, p);
  if (determinant == 0) return false;
  const DVec3 w = origin - a;
  const double along_u = glm::dot(w, p) / determinant;
  const DVec3 q = glm::cross(w, u);
  const double along_v = glm::dot(direction, q) / determinant;
  return along_u >= 0 && along_v >= 0 && along_u + along_v <= 1 && glm::dot(v, q) / determinant >= 0;
}

/// Seconds a ray of plain counting under the first position of the sun.
double plain_seconds(const Mesh& hull, const Scene& scene, std::uint64_t rays) {
  std::vector<std::array<DVec3, 3>> triangles;
  const auto add = [&](const auto& mesh) {
    for (const auto& [a, b, c] : mesh.triangles) {
      triangles.push_back({DVec3(mesh.positions[a]), DVec3(mesh.positions[b]), DVec3(mesh.positions[c])});
    }
  };
  add(hull);
  for (const meristem::Obstacle& body : scene.obstacles.bodies()) add(body.mesh);
  const meristem::SurfacePlaces places(hull);
  const Vec3 toward = scene.light.sun[0].toward;
  const RandomKey key(1);
  const auto begin = std::chrono::steady_clock::now();
  std::uint64_t lit = 0;
  for (std::uint64_t k = 0; k < rays; ++k) {
    const DVec3 origin(places.position(places.at(key.uniform(k), key.uniform(k, 1))) + 1e-4F * toward);
    const auto blocks = [&](const auto& t) { return meets(origin, DVec3(toward), t[0], t[1], t[2]); };
    if (std::none_of(triangles.begin(), triangles.end(), blocks)) ++lit;
  }
  benchmark::DoNotOptimize(lit);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  return seconds.count() / static_cast<double>(rays);
}

void crown_light(benchmark::State& state) {
  constexpr std::uint64_t kPlainRays = 1000;
  const Mesh hull = crown_hull();
  const Scene scene = surrounded(static_cast<int>(state.range(0)), state.range(1) != 0);
  const meristem::ThreadLimit limit(static_cast<int>(state.range(2)));
  double plain = 1e9;
  for (int i = 0; i < 3; ++i) plain = std::min(plain, plain_seconds(hull, scene, kPlainRays));
  double ours = 1e9;
  meristem::CrownLight light;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    light = meristem::measure_crown_light(hull, scene);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    ours = std::min(ours, seconds.count() / static_cast<double>(meristem::kCrownRays));
  }
  state.counters["lit_share"] = light.lit_share;
  if (scene.obstacles.empty()) return;  // no rays
  state.counters["rays/s"] = benchmark::Counter(meristem::kCrownRays, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["to_plain"] = plain / ours;
}
BENCHMARK(crown_light)
    ->ArgNames({"obstacles", "day", "threads"})
    ->Args({0, 1, 1})
    ->Args({10, 0, 1})
    ->Args({10, 1, 1})
    ->Args({10, 1, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
