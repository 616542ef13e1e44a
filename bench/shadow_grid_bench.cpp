// SPDX-License-Identifier: Apache-2.0
// Shade of the buds of a crown. Counters: shaders or queries a second; voxels that a shader touches; bytes of the grid.
// `to_plain` is the time of a map with an entry per voxel divided by the library's time, in one run.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <unordered_map>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/base/random.h"
#include "meristem/scene/light/shadow_grid.h"

namespace {

using meristem::ShadowGrid;
using meristem::ShadowParameters;
using meristem::Vec3;

const std::uint64_t kBuds = meristem::bench::sized(20'000, 500);

/// Buds all over a ball of 3 m, each near the one before, as along shoots.
std::vector<Vec3> buds() {
  const meristem::RandomKey key(3);
  std::vector<Vec3> places;
  Vec3 position(0);
  for (std::uint64_t k = 0; k < kBuds; ++k) {
    if (k % 10 == 0) position = static_cast<float>(3 * std::cbrt(key.uniform(k))) * key.direction(k);
    position += 0.1F * key.direction(k + kBuds);
    places.push_back(position);
  }
  return places;
}

ShadowParameters form_of(const benchmark::State& state) {
  ShadowParameters form;
  form.depth = static_cast<int>(state.range(0));
  if (state.range(1) != 0) form.toward_light = glm::normalize(Vec3(0.4F, 0.7F, 0.5F));
  return form;
}

/// The plain grid: light from the zenith, with a map entry per voxel.
class PlainGrid {
 public:
  explicit PlainGrid(const ShadowParameters& form) : form_(form) {}
  void add(Vec3 position) {
    const auto voxel = [&](int k) { return static_cast<std::int64_t>(std::floor(position[k] / form_.voxel)); };
    double shade = form_.amount;
    for (int q = 0; q <= form_.depth; ++q, shade /= form_.base) {
      for (int x = -q; x <= q; ++x) {
        for (int z = -q; z <= q; ++z) voxels_[key(voxel(0) + x, voxel(1) - q, voxel(2) + z)] += shade;
      }
    }
  }

 private:
  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    const auto part = [](std::int64_t at) { return static_cast<std::uint64_t>(at) & 0x1FFFFF; };
    return part(x) | part(y) << 21 | part(z) << 42;
  }
  ShadowParameters form_;
  std::unordered_map<std::uint64_t, double> voxels_;
};

template <class Grid>
double seconds_of_adding(const ShadowParameters& form, const std::vector<Vec3>& places) {
  double best = 1e9;
  for (int k = 0; k < 3; ++k) {
    const auto begin = std::chrono::steady_clock::now();
    Grid grid(form);
    for (const Vec3 position : places) grid.add(position);
    benchmark::DoNotOptimize(&grid);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return best;
}

void count(benchmark::State& state, const char* what) {
  state.counters[what] = benchmark::Counter(kBuds, benchmark::Counter::kIsIterationInvariantRate);
}

/// Adds all buds to an empty grid.
void add(benchmark::State& state) {
  const std::vector<Vec3> places = buds();
  const ShadowParameters form = form_of(state);
  std::size_t bytes = 0;
  for (auto _ : state) {
    ShadowGrid grid(form);
    for (const Vec3 position : places) grid.add(position);
    bytes = grid.bytes();
  }
  count(state, "shaders/s");
  const double layers = form.depth + 1;
  state.counters["voxels"] = layers * (2 * layers - 1) * (2 * layers + 1) / 3;
  state.counters["bytes"] = static_cast<double>(bytes);
  state.counters["to_plain"] = seconds_of_adding<PlainGrid>(form, places) / seconds_of_adding<ShadowGrid>(form, places);
}
BENCHMARK(add)->ArgNames({"depth", "tilted"})->ArgsProduct({{3, 8}, {0, 1}})->Unit(benchmark::kMillisecond);

/// A round of growth that sheds as much as it adds: shade moves within an existing grid.
void move(benchmark::State& state) {
  const std::vector<Vec3> places = buds();
  ShadowGrid grid(form_of(state));
  for (const Vec3 position : places) grid.add(position);
  for (auto _ : state) {
    for (const Vec3 position : places) {
      grid.remove(position);
      grid.add(position);
    }
  }
  count(state, "shaders/s");
}
BENCHMARK(move)->ArgNames({"depth", "tilted"})->Args({3, 0})->Unit(benchmark::kMillisecond);

void ask(benchmark::State& state) {
  const std::vector<Vec3> places = buds();
  ShadowGrid grid(form_of(state));
  for (const Vec3 position : places) grid.add(position);
  double sum = 0;
  for (auto _ : state) {
    for (const Vec3 position : places) sum += grid.shade(position);
  }
  benchmark::DoNotOptimize(sum);
  count(state, "queries/s");
}
BENCHMARK(ask)->ArgNames({"depth", "tilted"})->Args({3, 0})->Unit(benchmark::kMillisecond);

void turn(benchmark::State& state) {
  const std::vector<Vec3> places = buds();
  ShadowGrid grid(form_of(state));
  for (const Vec3 position : places) grid.add(position);
  Vec3 sum(0);
  for (auto _ : state) {
    for (const Vec3 position : places) sum += grid.brighter_way(position);
  }
  benchmark::DoNotOptimize(sum);
  count(state, "queries/s");
}
BENCHMARK(turn)->ArgNames({"depth", "tilted"})->Args({3, 0})->Unit(benchmark::kMillisecond);

}  // namespace

int main(int count, char** arguments) { return meristem::bench::run(count, arguments); }
