// SPDX-License-Identifier: Apache-2.0
// Obstacles: rays to the first surface, segments that may be blocked, positions that may be inside, and building. Ten
// spheres of 1,000 triangles, one thread. Counters: queries a second, the share of queries that hit, and `to_plain`.
// `to_plain` is the time of testing every triangle (Moeller and Trumbore) divided by the library's time, per ray, in
// one run.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/base/random.h"
#include "meristem/scene/obstacle/obstacles.h"

namespace {

using meristem::DVec3;
using meristem::Obstacle;
using meristem::Obstacles;
using meristem::RandomKey;
using meristem::TriangleMesh;
using meristem::Vec3;

constexpr std::uint32_t kRings = 20;
constexpr std::uint32_t kSectors = 26;
constexpr std::size_t kQueries = 4096;
constexpr float kReach = 12;

/// A sphere of 988 triangles between its poles.
TriangleMesh sphere(DVec3 centre, double radius) {
  TriangleMesh mesh;
  mesh.positions = {centre + DVec3(0, radius, 0), centre - DVec3(0, radius, 0)};
  for (std::uint32_t ring = 1; ring < kRings; ++ring) {
    for (std::uint32_t sector = 0; sector < kSectors; ++sector) {
      const double polar = meristem::kPi * ring / kRings;
      const double turn = 2 * meristem::kPi * sector / kSectors;
      mesh.positions.push_back(
          centre + radius * DVec3(std::sin(polar) * std::sin(turn), std::cos(polar), std::sin(polar) * std::cos(turn)));
    }
  }
  const auto vertex = [](std::uint32_t ring, std::uint32_t sector) {
    return 2 + (ring - 1) * kSectors + sector % kSectors;
  };
  for (std::uint32_t k = 0; k < kSectors; ++k) {
    mesh.triangles.push_back({0, vertex(1, k), vertex(1, k + 1)});
    for (std::uint32_t ring = 1; ring + 1 < kRings; ++ring) {
      mesh.triangles.push_back({vertex(ring, k), vertex(ring + 1, k), vertex(ring + 1, k + 1)});
      mesh.triangles.push_back({vertex(ring, k), vertex(ring + 1, k + 1), vertex(ring, k + 1)});
    }
    mesh.triangles.push_back({1, vertex(kRings - 1, k + 1), vertex(kRings - 1, k)});
  }
  return mesh;
}

Vec3 random_position(std::uint64_t index) {
  const RandomKey key(1);
  const Vec3 share(key.uniform(index, 0), key.uniform(index, 1), key.child("z").uniform(index));
  return (2.0F * share - 1.0F) * kReach;
}

std::vector<Obstacle> ten_spheres() {
  std::vector<Obstacle> bodies;
  for (std::uint64_t k = 0; k < 10; ++k) {
    bodies.push_back({.mesh = sphere(DVec3(random_position(k)), RandomKey(2).uniform(k, 1.5, 4))});
  }
  return bodies;
}

/// The plain reference: tests every triangle.
double plain_first_hit(const std::vector<Obstacle>& bodies, DVec3 origin, DVec3 direction) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Obstacle& body : bodies) {
    for (const auto& triangle : body.mesh.triangles) {
      const DVec3 a = body.mesh.positions[triangle[0]];
      const DVec3 u = body.mesh.positions[triangle[1]] - a;
      const DVec3 v = body.mesh.positions[triangle[2]] - a;
      const DVec3 p = glm::cross(direction, v);
      const double determinant = glm::dot(u, p);
      if (determinant == 0) continue;
      const DVec3 w = origin - a;
      const double along_u = glm::dot(w, p) / determinant;
      if (!(along_u >= 0 && along_u <= 1)) continue;
      const DVec3 q = glm::cross(w, u);
      const double along_v = glm::dot(direction, q) / determinant;
      if (!(along_v >= 0 && along_u + along_v <= 1)) continue;
      const double distance = glm::dot(v, q) / determinant;
      if (distance >= 0 && distance < nearest) nearest = distance;
    }
  }
  return nearest;
}

struct Queries {
  std::vector<Vec3> places;
  std::vector<Vec3> directions;

  Queries() {
    for (std::uint64_t k = 0; k < kQueries; ++k) {
      places.push_back(random_position(1000 + k));
      directions.push_back(glm::normalize(random_position(9000 + k) - places.back()));
    }
  }
};

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Runs `ask(k)` over all queries and counts the hits.
template <class Ask>
double run(benchmark::State& state, Ask ask) {
  std::size_t met = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (auto _ : state) {
    met = 0;
    for (std::size_t k = 0; k < kQueries; ++k) met += ask(k) ? 1 : 0;
    benchmark::DoNotOptimize(met);
  }
  const double seconds = seconds_since(begin);
  const auto count = static_cast<double>(state.iterations() * kQueries);
  state.counters["queries"] = benchmark::Counter(count, benchmark::Counter::kIsRate);
  state.counters["met"] = static_cast<double>(met) / kQueries;
  return seconds / count;
}

void first_hits(benchmark::State& state) {
  const Obstacles obstacles(ten_spheres());
  const Queries queries;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double ours = run(state, [&](std::size_t k) {
    return obstacles.first_hit(queries.places[k], queries.directions[k], kInfinity).has_value();
  });

  constexpr std::size_t kPlain = 200;
  std::size_t differ = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t k = 0; k < kPlain; ++k) {
    const double plain = plain_first_hit(obstacles.bodies(), DVec3(queries.places[k]), DVec3(queries.directions[k]));
    const auto hit = obstacles.first_hit(queries.places[k], queries.directions[k], kInfinity);
    differ += std::abs((hit ? hit->distance : 1e9) - std::min(plain, 1e9)) > 1e-9 ? 1 : 0;
  }
  state.counters["to_plain"] = seconds_since(begin) / kPlain / ours;
  if (differ > 0) state.SkipWithError("differs from the plain way");
}
BENCHMARK(first_hits);

void crossed_steps(benchmark::State& state) {
  const Obstacles obstacles(ten_spheres());
  const Queries queries;
  run(state, [&](std::size_t k) {
    return obstacles.cross(queries.places[k], queries.places[k] + 0.05F * queries.directions[k]);
  });
}
BENCHMARK(crossed_steps);

void contained_places(benchmark::State& state) {
  std::vector<Obstacle> bodies = ten_spheres();
  for (Obstacle& body : bodies) body.is_broken = state.range(0) != 0;
  const Obstacles obstacles(std::move(bodies));
  const Queries queries;
  run(state, [&](std::size_t k) { return obstacles.contain(queries.places[k]); });
}
BENCHMARK(contained_places)->ArgName("broken")->Arg(0)->Arg(1);

void build(benchmark::State& state) {
  const std::vector<Obstacle> bodies = ten_spheres();
  for (auto _ : state) benchmark::DoNotOptimize(Obstacles(bodies));
}
BENCHMARK(build)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

int main(int count, char** arguments) { return meristem::bench::run(count, arguments); }
