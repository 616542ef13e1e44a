// SPDX-License-Identifier: Apache-2.0
// Tubes and leaf blades. Counters: triangles (or blades) a second, and bytes of mesh. For tubes, `to_plain` is the time
// of a plain tube mesher divided by the library's time, per triangle, in one run on one thread. The plain mesher sets
// rings at right angles to each segment, without mitres and tapered normals, in growing arrays.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/base/frame.h"
#include "meristem/base/hash.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/shape/leaf/leaf_blade.h"
#include "meristem/shape/tube/tubes.h"

namespace {

using meristem::Mesh;
using meristem::NodeIndex;
using meristem::Skeleton;
using meristem::SurfaceOptions;
using meristem::Vec3;

/// A crown of `axes` axes of ten nodes, each on a random node of an earlier one.
Skeleton random_crown(std::uint32_t axes) {
  constexpr std::uint32_t kNodes = 10;
  const meristem::RandomKey key(1);
  Skeleton skeleton;
  skeleton.reserve(axes * kNodes);
  for (std::uint32_t axis = 0; axis < axes; ++axis) {
    NodeIndex last = axis == 0 ? skeleton.add_node(meristem::kNoNode, Vec3(0), 0)
                               : static_cast<NodeIndex>(key.child("parent").uniform(axis, 0, axis * kNodes));
    if (axis == 0) skeleton.radius[0] = 0.2F;
    const Vec3 heading = glm::normalize(key.child("heading").direction(axis) + Vec3(0, 0.5F, 0));
    for (std::uint32_t i = axis == 0 ? 1 : 0; i < kNodes; ++i) {
      const Vec3 wobble = 0.3F * key.child("wobble").direction(axis * kNodes + i);
      const NodeIndex node = skeleton.add_node(last, skeleton.position[last] + 0.05F * (heading + wobble), 0);
      skeleton.radius[node] = 0.98F * skeleton.radius[last];
      skeleton.axis[node] = axis;
      last = node;
    }
  }
  return skeleton;
}

/// The plain reference: each segment's ring is at right angles to the segment.
Mesh plain_tubes(const Skeleton& skeleton, int sides) {
  const meristem::SkeletonAxes axes(skeleton);
  Mesh mesh;
  for (meristem::AxisIndex axis = 0; axis < axes.count(); ++axis) {
    const auto nodes = axes.of(axis);
    float v = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Vec3 here = skeleton.position[nodes[i]];
      const Vec3 other =
          i + 1 < nodes.size() ? skeleton.position[nodes[i + 1]] : 2.0F * here - skeleton.position[nodes[i - 1]];
      const Vec3 x = meristem::any_perpendicular(other - here);
      const Vec3 y = glm::normalize(glm::cross(other - here, x));
      for (int k = 0; k <= sides; ++k) {
        const auto angle = static_cast<float>(2 * meristem::kPi * k / sides);
        const Vec3 out = std::cos(angle) * x + std::sin(angle) * y;
        mesh.positions.push_back(here + skeleton.radius[nodes[i]] * out);
        mesh.normals.push_back(out);
        mesh.uvs.emplace_back(static_cast<float>(k) / static_cast<float>(sides), v);
      }
      v += glm::distance(here, other);
      if (i == 0) continue;
      const auto stride = static_cast<std::uint32_t>(sides + 1);
      const auto first = static_cast<std::uint32_t>(mesh.positions.size()) - 2 * stride;
      for (std::uint32_t k = first; k + 1 < first + stride; ++k) {
        mesh.triangles.push_back({k, k + 1, k + 1 + stride});
        mesh.triangles.push_back({k, k + 1 + stride, k + stride});
      }
    }
  }
  return mesh;
}

double seconds_a_triangle(const Skeleton& skeleton, int sides) {
  const auto begin = std::chrono::steady_clock::now();
  const Mesh mesh = plain_tubes(skeleton, sides);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  return seconds.count() / static_cast<double>(mesh.triangle_count());
}

void tubes(benchmark::State& state) {
  const Skeleton skeleton = random_crown(static_cast<std::uint32_t>(state.range(0) / 10));
  const SurfaceOptions surface{.sides = static_cast<int>(state.range(1))};
  const meristem::ThreadLimit limit(static_cast<int>(state.range(2)));
  double plain = 1e9;
  for (int i = 0; i < 3; ++i) plain = std::min(plain, seconds_a_triangle(skeleton, surface.sides));
  double ours = 1e9;
  Mesh mesh;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    meristem::Progress progress;
    mesh = Mesh();
    mesh = make_tubes(skeleton, surface, progress);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    ours = std::min(ours, seconds.count() / static_cast<double>(mesh.triangle_count()));
  }
  const auto triangles = static_cast<double>(mesh.triangle_count());
  state.counters["triangles"] = triangles;
  state.counters["triangles/s"] = benchmark::Counter(triangles, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["bytes"] = static_cast<double>(mesh.bytes());
  state.counters["to_plain"] = plain / ours;
  state.SetLabel(meristem::hash128_hex(std::as_bytes(std::span(mesh.positions))));
}
const std::int64_t kFew = meristem::bench::sized(10'000, 500);
const std::int64_t kMany = meristem::bench::sized(1'000'000, 2'000);
BENCHMARK(tubes)
    ->ArgNames({"nodes", "sides", "threads"})
    ->Args({kFew, 8, 1})
    ->Args({kMany, 5, 1})
    ->Args({kMany, 8, 1})
    ->Args({kMany, 8, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void leaf_blades(benchmark::State& state) {
  meristem::LeafBlade blade;
  blade.curl = 0.5;
  blade.curl_across = 0.3;
  blade.petiole = 0.02;
  blade.rows = static_cast<int>(state.range(0));
  std::size_t triangles = 0;
  for (auto _ : state) {
    blade.curl += 1e-6;
    triangles = make_leaf_blade(blade).triangle_count();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["blades/s"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(leaf_blades)->ArgName("rows")->Arg(6)->Arg(24);

}  // namespace

int main(int count, char** arguments) {
  using meristem::bench::Asked;
  // The largest measured figure is 19 million. Rings take a third of the mesher's own time, collars and their search
  // for the bark another third, and planning a quarter. All three look up parents all over a random crown.
  return meristem::bench::run(count, arguments,
                              {{"tubes/nodes:1000000/sides:8/threads:1", "triangles/s", Asked::at_least, 25e6}});
}
