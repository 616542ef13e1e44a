// SPDX-License-Identifier: Apache-2.0
// The lit share of a crown's hull among obstacles, the light on leaves, and the shade on a facade behind a crown.
// Counters: rays per second, the share, and `to_plain`. `to_plain` is the time of plain counting (each ray tested
// against every triangle) divided by the library's time, per ray, in one run on one thread. The shade benchmark fails
// if plain counting of the same rays finds another share.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/measure/convex_hull.h"
#include "meristem/measure/crown_light.h"
#include "meristem/measure/organ_light.h"
#include "meristem/measure/shade.h"
#include "meristem/measure/surface_points.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/leaf/leaf_blade.h"
#include "meristem/shape/solid/primitives.h"

namespace {

using meristem::DirectionalLight;
using meristem::DVec3;
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

/// Obstacles in a ring about the origin, and the sun of a May day in London, all day or at ten o'clock.
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

/// Returns true if a ray from `origin` meets a triangle (Moeller and Trumbore).
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

using Corners = std::array<DVec3, 3>;

template <class AnyMesh>
void add_triangles(const AnyMesh& mesh, std::vector<Corners>& triangles) {
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.push_back({DVec3(mesh.positions[a]), DVec3(mesh.positions[b]), DVec3(mesh.positions[c])});
  }
}

/// Returns the seconds per ray of plain counting, from a mesh toward one side.
double plain_seconds(const Mesh& from, Vec3 toward, const std::vector<Corners>& triangles) {
  const std::uint64_t rays = meristem::bench::sized(500, 10);
  const meristem::SurfacePoints places(from);
  const RandomKey key(1);
  double min = 1e9;
  for (int trial = 0; trial < 3; ++trial) {
    const auto begin = std::chrono::steady_clock::now();
    std::uint64_t lit = 0;
    for (std::uint64_t k = 0; k < rays; ++k) {
      const DVec3 origin(places.position(places.at(key.uniform(k), key.uniform(k, 1))) + 1e-4F * toward);
      const auto blocks = [&](const Corners& t) { return meets(origin, DVec3(toward), t[0], t[1], t[2]); };
      if (std::none_of(triangles.begin(), triangles.end(), blocks)) ++lit;
    }
    benchmark::DoNotOptimize(lit);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    min = std::min(min, seconds.count() / static_cast<double>(rays));
  }
  return min;
}

void crown_light(benchmark::State& state) {
  const Mesh hull = crown_hull();
  const Scene scene = surrounded(static_cast<int>(state.range(0)), state.range(1) != 0);
  const meristem::ThreadLimit limit(static_cast<int>(state.range(2)));
  std::vector<Corners> triangles;
  add_triangles(hull, triangles);
  for (const meristem::Obstacle& body : scene.obstacles.bodies()) add_triangles(body.mesh, triangles);
  const double plain = plain_seconds(hull, scene.light.sun[0].toward, triangles);
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

/// Leaves of 30 cm², turned every way, in a ball of 5 m.
meristem::Plant leafy_crown(std::uint64_t leaves) {
  meristem::LeafBlade blade;
  meristem::Plant plant;
  plant.materials.resize(1);
  plant.materials[0].two_sided = true;
  plant.prototypes = {{"leaf", 0, std::make_shared<const Mesh>(meristem::make_leaf_blade(blade))}};
  const RandomKey key(7);
  for (std::uint64_t k = 0; k < leaves; ++k) {
    const auto out = static_cast<float>(2.5 * std::cbrt(key.uniform(k)));
    plant.organs.push_back({.frame = meristem::frame_along(out * key.child("place").direction(k),
                                                           key.child("way").direction(k), meristem::kUp)});
  }
  return plant;
}

void organ_light(benchmark::State& state) {
  const meristem::Plant plant = leafy_crown(static_cast<std::uint64_t>(state.range(0)));
  const Scene scene = surrounded(static_cast<int>(state.range(1)), state.range(2) != 0);
  const meristem::ThreadLimit limit(static_cast<int>(state.range(3)));
  meristem::Progress progress;
  const meristem::MeshScene meshes = make_mesh_scene(plant, {}, progress);
  std::vector<Corners> triangles;
  for (const meristem::Organ& organ : plant.organs) {
    Mesh placed = *plant.prototypes[0].mesh;
    for (Vec3& position : placed.positions) position = organ.frame.point(position);
    add_triangles(placed, triangles);
  }
  const double plain = plain_seconds(*plant.prototypes[0].mesh, scene.light.sun[0].toward, triangles);
  double ours = 1e9;
  meristem::LitOrgan mean;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    mean = mean_leaf_light(plant, measure_organ_light(plant, {}, meshes, scene, progress));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    ours = std::min(ours, seconds.count());
  }
  // Leaves of this size are sampled at four positions.
  const auto rays = static_cast<double>(4 * plant.organs.size() * scene.light.sun.size());
  state.counters["rays/s"] = benchmark::Counter(rays, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["exposure"] = mean.exposure;
  state.counters["leaf_area"] = mean.area;
  state.counters["to_plain"] = plain / (ours / rays);
}
const std::int64_t kLeaves = meristem::bench::sized(20'000, 200);
BENCHMARK(organ_light)
    ->ArgNames({"leaves", "obstacles", "day", "threads"})
    ->Args({kLeaves, 0, 0, 1})
    ->Args({kLeaves, 0, 1, 1})
    ->Args({kLeaves, 0, 1, 2})
    ->Args({kLeaves, 10, 1, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// A facade of 12 by 9 m that faces south, with a leafy crown 6 m before it.
struct ShadedFacade {
  meristem::Obstacles house;
  meristem::ShadeSurface wall;
  meristem::MeshScene crown;

  ShadedFacade(std::uint64_t leaves, double spacing) {
    meristem::Obstacle body;
    body.mesh = meristem::box_mesh(DVec3(-6, 0, -14), DVec3(6, 9, -6));
    house = meristem::Obstacles({body});
    wall = meristem::facade_surface(house, 0, meristem::FacadeSide::south, std::nullopt, spacing);
    meristem::Plant plant = leafy_crown(leaves);
    for (meristem::Organ& organ : plant.organs) organ.frame.origin.y += 4;
    meristem::Progress progress;
    crown = make_mesh_scene(plant, {}, progress);
  }

  std::vector<Corners> triangles() const {
    std::vector<Corners> all;
    add_triangles(house.bodies()[0].mesh, all);
    const meristem::MeshInstances& leaves = crown.meshes[0];
    for (const meristem::Frame& frame : leaves.frames) {
      Mesh placed = *leaves.mesh;
      for (Vec3& position : placed.positions) position = frame.point(position);
      add_triangles(placed, all);
    }
    return all;
  }
};

/// Returns the shaded share of the first points at one position of the sun, by plain counting, and the seconds per ray.
std::pair<double, double> plain_shade(const ShadedFacade& facade, std::size_t points, Vec3 toward) {
  const std::vector<Corners> triangles = facade.triangles();
  std::size_t shaded = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t k = 0; k < points; ++k) {
    const DVec3 origin(facade.wall.positions[k] + 1e-3F * facade.wall.normals[k]);
    const auto blocks = [&](const Corners& t) { return meets(origin, DVec3(toward), t[0], t[1], t[2]); };
    if (std::any_of(triangles.begin(), triangles.end(), blocks)) ++shaded;
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const auto count = static_cast<double>(points);
  return {static_cast<double>(shaded) / count, seconds.count() / count};
}

void shade(benchmark::State& state) {
  const ShadedFacade facade(static_cast<std::uint64_t>(state.range(0)), meristem::bench::sized(0.1, 1.0));
  const meristem::ThreadLimit limit(static_cast<int>(state.range(1)));
  std::vector<meristem::SkyDirection> day;
  for (int hour = 4; hour <= 20; ++hour) day.push_back(meristem::sun_position(meristem::radians(51.5), 126, hour));
  std::size_t above = 0;
  for (const meristem::SkyDirection& sun : day) above += sun.altitude > 0 ? 1 : 0;
  const auto rays = static_cast<double>(facade.wall.positions.size() * above);
  meristem::Progress progress;
  meristem::ShadeOfSurface found;
  double ours = 1e9;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    found = measure_shade(facade.wall, day, facade.crown, facade.house, progress);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    ours = std::min(ours, seconds.count());
  }
  // At noon both count the same rays.
  const std::vector<meristem::SkyDirection> noon = {day[day.size() / 2]};
  ShadedFacade part = facade;
  const std::size_t points =
      std::min(facade.wall.positions.size(), meristem::bench::sized(std::size_t{400}, std::size_t{20}));
  part.wall.positions.resize(points);
  part.wall.normals.resize(points);
  const double ours_at_noon = measure_shade(part.wall, noon, facade.crown, facade.house, progress).moments[0].shade;
  const auto [plain_at_noon, plain] = plain_shade(facade, points, unit_vector(noon[0]));
  if (std::abs(ours_at_noon - plain_at_noon) > 0.01) state.SkipWithError("plain counting finds another share");
  double share = 0;
  for (const double of_point : found.of_point) share += of_point / static_cast<double>(found.of_point.size());
  state.counters["rays/s"] = benchmark::Counter(rays, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["shade"] = share;
  state.counters["to_plain"] = plain / (ours / rays);
}
BENCHMARK(shade)
    ->ArgNames({"leaves", "threads"})
    ->Args({kLeaves, 1})
    ->Args({kLeaves, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

int main(int count, char** arguments) { return meristem::bench::run(count, arguments); }
