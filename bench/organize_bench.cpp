// SPDX-License-Identifier: Apache-2.0
// Self-organizing trees grown to a million metamers, by shade and by markers. Counters: `metamers/s`, where living
// metamers are summed over all iterations; `metamers` at the end; `ns/metamer`, the reciprocal as a time;
// `bytes/metamer`, the largest memory in use between two rounds of the growth, including shade or markers. The hash of
// the skeleton must be equal on any number of threads. `far` is a stand of eight trees up to 7 km apart: the cost
// depends on the trees and not on the space around them. `plain_light` counts the light of a growth anew in each
// iteration, in a map with an entry per voxel, and grows nothing. Its light must equal the library's light. `to_growth`
// is its time divided by the time of the library's whole growth. After the runs the program prints the growth of the
// cost with the number of metamers.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <malloc.h>

#include "bench/harness.h"
#include "meristem/base/parallel.h"
#include "meristem/grow/organize/organize.h"

namespace {

using meristem::BudLightModel;
using meristem::OrganizeParameters;
using meristem::Skeleton;
using meristem::Vec3;

const meristem::Scene kOpenScene;

OrganizeParameters parameters(BudLightModel::Kind kind, int iterations) {
  OrganizeParameters made;
  made.iterations = iterations;
  made.light.kind = kind;
  if (kind == BudLightModel::Kind::markers) {
    made.direction = {.persistence = 0.55, .light = 0.3, .up = 0.15};
  }
  return made;
}

double bytes_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// A member of the stand that only measures the memory in use.
class MemoryProbe : public meristem::Grower {
 public:
  MemoryProbe(int rounds, double& max) : rounds_(rounds), max_(max) {}
  int step_limit() const override { return rounds_; }
  bool step(meristem::Progress&) override {
    max_ = std::max(max_, bytes_in_use());
    return true;
  }
  Skeleton take_skeleton(meristem::Progress&) override { return {}; }

 private:
  int rounds_;
  double& max_;
};

Skeleton grow(const OrganizeParameters& parameters, int trees, float apart, double& max_bytes) {
  meristem::Progress progress;
  meristem::Stand stand;
  std::vector<meristem::OrganizeSeed> seeds(static_cast<std::size_t>(trees));
  for (std::size_t k = 0; k < seeds.size(); ++k) seeds[k].frame.origin.x = apart * static_cast<float>(k);
  stand.add(make_organizer(stand, seeds, parameters, meristem::RandomKey(1), kOpenScene, {}, "tree"));
  stand.add(std::make_unique<MemoryProbe>(parameters.iterations + 1, max_bytes));
  stand.grow(progress);
  return std::move(stand.take_skeletons(progress)[0]);
}

/// Returns the number of living metamers, summed over all iterations. No metamer is shed.
double living_metamers(const Skeleton& skeleton, int iterations) {
  double sum = 0;
  for (const float birth : skeleton.birth) sum += iterations + 1 - static_cast<double>(birth);
  return sum;
}

struct Run {
  std::string hash;
  double metamers = 0;
  double nanoseconds = 0;  // for each metamer in each iteration
};
std::map<std::pair<int, int>, Run>& runs() {
  static std::map<std::pair<int, int>, Run> all;
  return all;
}

void measure(benchmark::State& state, BudLightModel::Kind kind, int trees, float apart) {
  const int iterations = static_cast<int>(state.range(0));
  const meristem::ThreadLimit threads(static_cast<int>(state.range(1)));
  const OrganizeParameters wanted = parameters(kind, iterations);
  double bytes = 0;
  double best = 1e9;
  double living = 0;
  Skeleton skeleton;
  for (auto _ : state) {
    skeleton = Skeleton();
    const double before = bytes_in_use();
    double max = before;
    const auto begin = std::chrono::steady_clock::now();
    skeleton = grow(wanted, trees, apart, max);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    living += living_metamers(skeleton, iterations);
    bytes = max - before;
  }
  const auto metamers = static_cast<double>(skeleton.node_count());
  state.counters["metamers/s"] = benchmark::Counter(living, benchmark::Counter::kIsRate);
  state.counters["metamers"] = metamers;
  const double nanoseconds = 1e9 * best / living_metamers(skeleton, iterations);
  state.counters["ns/metamer"] = nanoseconds;
  state.counters["bytes/metamer"] = bytes / metamers;
  const std::string hash = skeleton_hash(skeleton).substr(0, 16);
  state.SetLabel(hash);
  if (trees > 1) return;
  const auto [run, is_new] = runs().try_emplace({static_cast<int>(kind), iterations}, Run{hash, metamers, nanoseconds});
  if (!is_new && state.range(1) == 1) run->second.nanoseconds = std::min(run->second.nanoseconds, nanoseconds);
  if (!is_new && run->second.hash != hash) {
    std::fprintf(stderr, "%d iterations: another tree on %d threads\n", iterations, static_cast<int>(state.range(1)));
    std::exit(1);
  }
}

void shadow(benchmark::State& state) { measure(state, BudLightModel::Kind::shadow, 1, 0); }
void far(benchmark::State& state) { measure(state, BudLightModel::Kind::shadow, 8, 1000); }
void markers(benchmark::State& state) { measure(state, BudLightModel::Kind::markers, 1, 0); }

/// Shade from the zenith by the default parameters, in a map with an entry per voxel.
class PlainShade {
 public:
  explicit PlainShade(const OrganizeParameters& parameters) : parameters_(parameters) {}
  void add(Vec3 position) {
    double shade = parameters_.light.a;
    for (int q = 0; q <= parameters_.light.depth; ++q, shade /= parameters_.light.b) {
      for (int x = -q; x <= q; ++x) {
        for (int z = -q; z <= q; ++z) voxels_[key(position, x, -q, z)] += shade;
      }
    }
  }
  double at(Vec3 position) const {
    const auto found = voxels_.find(key(position, 0, 0, 0));
    return found == voxels_.end() ? 0 : found->second;
  }

 private:
  std::uint64_t key(Vec3 position, int x, int y, int z) const {
    const auto part = [&](float at, int aside) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(at / parameters_.length)) + aside) &
             0x1FFFFF;
    };
    return part(position.x, x) | part(position.y, y) << 21 | part(position.z, z) << 42;
  }
  const OrganizeParameters& parameters_;
  std::unordered_map<std::uint64_t, double> voxels_;
};

/// Returns the light of all open buds of the metamers that exist after `iteration`.
double plain_light_of(const Skeleton& skeleton, const OrganizeParameters& parameters, int iteration) {
  PlainShade shade(parameters);
  const auto is_there = [&](meristem::NodeIndex node) { return skeleton.birth[node] <= static_cast<float>(iteration); };
  for (meristem::NodeIndex node = 1; node < skeleton.node_count(); ++node) {
    if (is_there(node)) shade.add(skeleton.position[node]);
  }
  const std::vector<float>& terminal = skeleton.extra.find("terminal_bud")->second;
  const std::vector<float>& lateral = skeleton.extra.find("lateral_bud")->second;
  double sum = 0;
  for (meristem::NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (!is_there(node)) continue;
    const double own = node == 0 ? 0 : parameters.light.a;
    const double light = std::clamp(1 - shade.at(skeleton.position[node]) + own, 0.0, 1.0);
    sum += light * ((terminal[node] == 0 ? 1 : 0) + (lateral[node] == 0 ? 1 : 0));
  }
  return sum;
}

void plain_light(benchmark::State& state) {
  const int iterations = static_cast<int>(state.range(0));
  const OrganizeParameters wanted = parameters(BudLightModel::Kind::shadow, iterations);
  double unused = 0;
  const Skeleton skeleton = grow(wanted, 1, 0, unused);
  double last = 0;
  double best = 1e9;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    for (int iteration = 0; iteration <= iterations; ++iteration) last = plain_light_of(skeleton, wanted, iteration);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  const double ours = skeleton.extra.find("light")->second[0];
  if (std::abs(last - ours) > 1e-4 * ours) {
    std::fprintf(stderr, "the plain light is %g, ours %g\n", last, ours);
    std::exit(1);
  }
  const double nanoseconds = 1e9 * best / living_metamers(skeleton, iterations);
  state.counters["ns/metamer"] = nanoseconds;
  state.counters["metamers"] = static_cast<double>(skeleton.node_count());
  const auto growth = runs().find({static_cast<int>(BudLightModel::Kind::shadow), iterations});
  if (growth != runs().end()) state.counters["to_growth"] = nanoseconds / growth->second.nanoseconds;
}

void sizes(benchmark::internal::Benchmark* bench, const std::vector<std::int64_t>& iterations) {
  bench->ArgNames({"iterations", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const std::int64_t count : iterations) bench->Args({count, 1});
  bench->Args({iterations.back(), 2});
}
BENCHMARK(shadow)->Apply([](auto* bench) { sizes(bench, meristem::bench::sized({28, 50, 93}, {8})); });
BENCHMARK(far)->Apply([](auto* bench) { sizes(bench, meristem::bench::sized({50}, {6})); });
BENCHMARK(plain_light)
    ->ArgName("iterations")
    ->ArgsProduct({meristem::bench::sized({28, 50}, {8})})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(markers)->Apply([](auto* bench) { sizes(bench, meristem::bench::sized({12, 25, 45}, {6})); });

void print_growth(const char* name, BudLightModel::Kind kind) {
  const Run* smallest = nullptr;
  const Run* largest = nullptr;
  for (const auto& [key, run] : runs()) {
    if (key.first != static_cast<int>(kind)) continue;
    if (smallest == nullptr || run.metamers < smallest->metamers) smallest = &run;
    if (largest == nullptr || run.metamers > largest->metamers) largest = &run;
  }
  if (smallest == largest) return;
  const double power =
      1 + std::log(largest->nanoseconds / smallest->nanoseconds) / std::log(largest->metamers / smallest->metamers);
  std::printf("%s: an iteration's cost grows with metamers^%.2f from %.0f to %.0f\n", name, power, smallest->metamers,
              largest->metamers);
}

}  // namespace

int main(int count, char** arguments) {
  return meristem::bench::run(count, arguments, {}, [] {
    print_growth("shadow", BudLightModel::Kind::shadow);
    print_growth("markers", BudLightModel::Kind::markers);
    return true;
  });
}
