// SPDX-License-Identifier: Apache-2.0
// Trimmed stems: 100,000 stems of eight segments each about a closed mesh of some 10,000 triangles, on all threads.
// Counters: stems a second, the share of shortened stems, and `to_plain`. `to_plain` is the time of querying the mesh
// once for each node divided by the library's time, in one run.
#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/plant/trim.h"
#include "meristem/scene/crown/mesh_crown.h"
#include "tests/support/sample_bodies.h"

namespace {

using meristem::ClosedMesh;
using meristem::MeshCrown;
using meristem::NodeIndex;
using meristem::RandomKey;
using meristem::Skeleton;
using meristem::TrimMode;
using meristem::Vec3;
using meristem::bench::Asked;
using meristem::bench::sized;

constexpr int kSegments = 8;

/// Stems 0.3 m long in all directions, which begin in a ball of 1.1 m.
std::vector<Skeleton> stems_about_a_ball(std::size_t count) {
  std::vector<Skeleton> stems(count);
  const RandomKey key(3);
  for (std::size_t k = 0; k < count; ++k) {
    const auto draw = [&](std::uint64_t what) {
      const RandomKey of = key.child(what);
      return Vec3(2 * of.uniform(k, 0) - 1, 2 * of.uniform(k, 1) - 1, 2 * of.uniform(k, 2) - 1);
    };
    Vec3 at = 1.1F * draw(1);
    const Vec3 step = 0.3F / kSegments * glm::normalize(draw(2));
    NodeIndex last = meristem::kNoNode;
    for (int node = 0; node <= kSegments; ++node, at += step) {
      last = stems[k].add_node(last, at, 0);
      stems[k].radius[last] = 0.01F;
    }
  }
  return stems;
}

void trimmed_stems(benchmark::State& state) {
  const auto mode = static_cast<TrimMode>(state.range(0));
  const std::vector<Skeleton> stems = stems_about_a_ball(sized<std::size_t>(100'000, 200));
  // Each subdivision has four times as many triangles.
  const auto mesh = std::make_shared<ClosedMesh>(meristem::sphere_mesh(sized(5, 2)));
  const MeshCrown body(mesh, {});
  std::vector<std::uint8_t> shortened(stems.size());
  double ours = 0;
  const auto seconds_since = [](auto begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    meristem::parallel_for(stems.size(), 256, [&](std::size_t first, std::size_t end) {
      for (std::size_t k = first; k < end; ++k) {
        const auto left = trim_skeleton(
            stems[k], [&](Vec3 from, Vec3 to) { return body.reach(from, to); }, mode);
        shortened[k] = left.is_whole ? 0 : 1;
      }
    });
    ours = seconds_since(begin);
  }
  std::uint64_t inside = 0;
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::uint64_t> found(stems.size());
  meristem::parallel_for(stems.size(), 256, [&](std::size_t first, std::size_t end) {
    for (std::size_t k = first; k < end; ++k) {
      for (const Vec3 position : stems[k].position) found[k] += body.contains(position) ? 1 : 0;
    }
  });
  state.counters["to_plain"] = seconds_since(begin) / ours;
  double share = 0;
  for (const std::uint8_t is_shortened : shortened) share += is_shortened;
  for (const std::uint64_t count : found) inside += count;
  state.counters["shortened"] = share / static_cast<double>(stems.size());
  state.counters["triangles"] = static_cast<double>(mesh->triangle_count());
  state.counters["stems"] =
      benchmark::Counter(static_cast<double>(stems.size()), benchmark::Counter::kIsIterationInvariantRate);
  if (inside == 0) state.SkipWithError("no node is inside");
}
BENCHMARK(trimmed_stems)->ArgName("fit")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

int main(int count, char** arguments) {
  return meristem::bench::run(
      count, arguments,
      {{"trimmed_stems/fit:0", "ms", Asked::at_most, 1000}, {"trimmed_stems/fit:1", "ms", Asked::at_most, 1000}});
}
