// SPDX-License-Identifier: Apache-2.0
// Fewer triangles: a crown of spheres from 0.5 and 5 million triangles, and a forked trunk with thin ends. Counters:
// triangles before and after; input triangles per second; volume and area of the result divided by volume and area of
// the input. `closed` is 1 if each edge has two triangles that agree. Another counter is the longest time until a call
// stopped, in milliseconds. The label is the hash of the result's positions. `to_grid` is the time divided by the time
// of plain vertex clustering in one run: each vertex is mapped to a grid, and the vertices of a cell become one vertex,
// without errors and with holes.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <span>
#include <thread>
#include <unordered_map>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/base/hash.h"
#include "meristem/shape/mesh/simplify.h"
#include "tests/support/field_mesh.h"

namespace {

using namespace meristem;

using Seconds = std::chrono::duration<double>;

double now() { return Seconds(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double volume(const Mesh& mesh) {
  double sixfold = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sixfold += glm::dot(DVec3(mesh.positions[a]), glm::cross(DVec3(mesh.positions[b]), DVec3(mesh.positions[c])));
  }
  return sixfold / 6;
}

double area(const Mesh& mesh) {
  double doubled = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const DVec3 at(mesh.positions[a]);
    doubled += glm::length(glm::cross(DVec3(mesh.positions[b]) - at, DVec3(mesh.positions[c]) - at));
  }
  return doubled / 2;
}

bool is_closed(const Mesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> turned;
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      sides.emplace_back(t[k], t[(k + 1) % 3]);
      turned.emplace_back(t[(k + 1) % 3], t[k]);
    }
  }
  std::sort(sides.begin(), sides.end());
  std::sort(turned.begin(), turned.end());
  return sides == turned && std::adjacent_find(sides.begin(), sides.end()) == sides.end();
}

/// The plain reference: vertices in one cell of a grid are replaced by their mean.
double seconds_of_grid(const Mesh& mesh, float cell) {
  const double begin = now();
  std::unordered_map<std::uint64_t, std::uint32_t> cells;
  std::vector<std::uint32_t> index;
  std::vector<std::pair<DVec3, double>> sums;
  for (const Vec3 position : mesh.positions) {
    const glm::ivec3 c = glm::ivec3(glm::floor(position / cell)) + (1 << 20);
    const std::uint64_t key = (static_cast<std::uint64_t>(c.x) << 42) | (static_cast<std::uint64_t>(c.y) << 21) | c.z;
    const auto [found, is_new] = cells.try_emplace(key, static_cast<std::uint32_t>(sums.size()));
    if (is_new) sums.emplace_back(DVec3(0), 0);
    sums[found->second].first += DVec3(position);
    sums[found->second].second += 1;
    index.push_back(found->second);
  }
  Mesh less;
  for (const auto& [sum, count] : sums) less.positions.emplace_back(sum / count);
  for (const auto& [a, b, c] : mesh.triangles) {
    if (index[a] == index[b] || index[b] == index[c] || index[c] == index[a]) continue;
    less.triangles.push_back({index[a], index[b], index[c]});
  }
  benchmark::DoNotOptimize(less.triangles.data());
  return now() - begin;
}

/// Returns the longest time from a stop request to the stop. Requests come at four moments of a call that takes `whole`
/// seconds.
double seconds_to_stop(const Mesh& mesh, std::size_t triangles, double whole) {
  double longest = 0;
  for (int k = 0; k < 4; ++k) {
    Progress progress;
    double asked = 0;
    std::thread asker([&] {
      std::this_thread::sleep_for(Seconds(whole * (k + 0.5) / 4));
      asked = now();
      progress.cancel();
    });
    double stopped = 0;
    try {
      benchmark::DoNotOptimize(simplify(mesh, {triangles}, progress).triangles.data());
    } catch (const Cancelled&) {
      stopped = now();
    }
    asker.join();
    longest = std::max(longest, stopped - asked);
  }
  return longest;
}

void run(benchmark::State& state, const Mesh& mesh) {
  const auto wanted = static_cast<std::size_t>(state.range(1));
  double min = 1e9;
  Mesh less;
  for (auto _ : state) {
    Progress progress;
    const double begin = now();
    less = simplify(mesh, {wanted}, progress);
    min = std::min(min, now() - begin);
  }
  const auto triangles = static_cast<double>(mesh.triangle_count());
  state.counters["in"] = triangles;
  state.counters["left"] = static_cast<double>(less.triangle_count());
  state.counters["triangles/s"] = triangles / min;
  state.counters["volume"] = volume(less) / volume(mesh);
  state.counters["area"] = area(less) / area(mesh);
  state.counters["closed"] = is_closed(less) ? 1 : 0;
  state.counters["to_grid"] = min / seconds_of_grid(mesh, 0.05F);
  state.counters["stop_ms"] = 1e3 * seconds_to_stop(mesh, wanted, min);
  state.SetLabel(hash128_hex(std::as_bytes(std::span(less.positions))));
}

/// Keeps the last input, because making it takes longer than the measured work.
const Mesh& mesh_of(const std::vector<Capsule>& capsules, int cells) {
  static Mesh mesh;
  static std::pair<std::size_t, int> made;
  const std::pair wanted(capsules.size(), cells);
  if (std::exchange(made, wanted) != wanted) mesh = capsule_mesh(capsules, 0.02F, cells);
  return mesh;
}

void crown(benchmark::State& state) { run(state, mesh_of(sphere_crown(20), static_cast<int>(state.range(0)))); }
BENCHMARK(crown)
    ->ArgNames({"cells", "wanted"})
    ->Args({bench::sized(160, 24), 50'000})
    ->Args({bench::sized(160, 24), 5'000})
    ->Args({bench::sized(160, 24), 500})
    ->Args({bench::sized(505, 24), 5'000})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

void trunk(benchmark::State& state) { run(state, mesh_of(forked_trunk(3), static_cast<int>(state.range(0)))); }
BENCHMARK(trunk)
    ->ArgNames({"cells", "wanted"})
    ->Args({bench::sized(400, 40), 5'000})
    ->Args({bench::sized(400, 40), 500})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace

int main(int count, char** arguments) { return meristem::bench::run(count, arguments); }
