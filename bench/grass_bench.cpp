// SPDX-License-Identifier: Apache-2.0
// Grass leaves.
// - `blade`: a leaf of 48 fitted pieces is reduced to the pieces for a number of triangles and meshed. Counters are the
//   triangles and the shortest time in microseconds.
// - `reduce`: computes the order in which the points of a leaf are removed, and a leaf of 10 points. `to_plain` is this
//   time divided by the time of a search through all errors in every step, in one run. `agree` is 1 if both give equal
//   points.
// - `fit`, `age`, `live` and `load`: the other stages.
// - `from_points`: a whole leaf from its digitised points to 64 triangles. `us` is the shortest time, and `to_blade` is
//   this time divided by the shortest time of reducing and meshing alone. The label is the hash of the result.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/base/hash.h"
#include "meristem/shape/grass/grass_blade.h"
#include "meristem/shape/grass/load_leaf.h"
#include "meristem/shape/grass/midrib_family.h"
#include "meristem/shape/grass/reduce_leaf.h"
#include "tests/support/grass_leaves.h"

namespace {

using namespace meristem;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::string hash_of(const GrassLeaf& leaf) { return hash128_hex(std::as_bytes(std::span(leaf.x))); }

GrassLeaf bench_leaf(std::size_t pieces) { return with_blade(arching_leaf(pieces, 0.2, 2.3)); }

void blade(benchmark::State& state) {
  const GrassLeaf leaf = bench_leaf(48);
  // Four triangles per piece, and two fewer at the tip.
  const auto pieces = static_cast<std::size_t>(state.range(0) + 2) / 4;
  Mesh mesh;
  double seconds = std::numeric_limits<double>::infinity();
  for (auto _ : state) {
    const double begin = now();
    mesh = make_grass_blade(reduced(leaf, points_kept(reduction_order(leaf), pieces)), {});
    benchmark::DoNotOptimize(mesh.positions.data());
    seconds = std::min(seconds, now() - begin);
  }
  const auto triangles = static_cast<double>(mesh.triangle_count());
  state.counters["triangles"] = triangles;
  state.counters["us/triangle"] = 1e6 * seconds / triangles;
  state.SetLabel(hash128_hex(std::as_bytes(std::span(mesh.positions))));
}
BENCHMARK(blade)->ArgName("triangles")->RangeMultiplier(2)->Range(8, 128)->Unit(benchmark::kMicrosecond);

double plain_error(const GrassLeaf& leaf, std::size_t a, std::size_t k, std::size_t b) {
  const auto square = [&](const std::vector<double>& x, const std::vector<double>& y) {
    const double ux = x[b] - x[a], uy = y[b] - y[a], vx = x[k] - x[a], vy = y[k] - y[a];
    const double length = ux * ux + uy * uy;
    const double share = length > 0 ? std::clamp((ux * vx + uy * vy) / length, 0.0, 1.0) : 0;
    const double dx = vx - share * ux, dy = vy - share * uy;
    return dx * dx + dy * dy;
  };
  return square(leaf.x, leaf.y) + square(leaf.s, leaf.r);
}

/// Returns the points in the order of their removal. Finds the smallest error by a search through all errors.
std::vector<std::uint32_t> plain_order(const GrassLeaf& leaf) {
  std::vector<std::uint32_t> left, order;
  std::vector<double> errors;
  for (std::uint32_t k = 0; k < leaf.point_count(); ++k) {
    left.push_back(k);
    const bool is_end = k == 0 || k + 1 == leaf.point_count();
    errors.push_back(is_end ? std::numeric_limits<double>::infinity() : plain_error(leaf, k - 1, k, k + 1));
  }
  while (left.size() > 2) {
    const auto min = std::min_element(errors.begin(), errors.end()) - errors.begin();
    order.push_back(left[static_cast<std::size_t>(min)]);
    left.erase(left.begin() + min);
    errors.erase(errors.begin() + min);
    const auto next = static_cast<std::size_t>(min);
    for (const std::size_t i : {next - 1, next}) {
      if (i > 0 && i + 1 < left.size()) errors[i] = plain_error(leaf, left[i - 1], left[i], left[i + 1]);
    }
  }
  return order;
}

void reduce(benchmark::State& state) {
  const GrassLeaf leaf = bench_leaf(static_cast<std::size_t>(state.range(0)) - 1);
  double ours = std::numeric_limits<double>::infinity(), plain = ours;
  ReductionOrder order;
  std::vector<std::uint32_t> expected;
  GrassLeaf less;
  for (auto _ : state) {
    const double begin = now();
    order = reduction_order(leaf);
    less = reduced(leaf, points_kept(order, 9));
    benchmark::DoNotOptimize(less.x.data());
    ours = std::min(ours, now() - begin);
  }
  for (int k = 0; k < bench::sized(200, 1); ++k) {
    const double begin = now();
    expected = plain_order(leaf);
    benchmark::DoNotOptimize(expected.data());
    plain = std::min(plain, now() - begin);
  }
  state.counters["to_plain"] = ours / plain;
  state.counters["agree"] = order.points == expected ? 1 : 0;
  state.SetLabel(hash_of(less));
}
BENCHMARK(reduce)->ArgName("points")->Arg(49)->Arg(100)->Arg(200)->Arg(1000)->Unit(benchmark::kMicrosecond);

/// A quarter of a circle with noise of 1 % of its radius.
MeasuredCurve digitised(int count) {
  const RandomKey key(1);
  MeasuredCurve midrib;
  for (int k = 0; k < count; ++k) {
    const double angle = kPi / 2 * k / (count - 1);
    const auto index = static_cast<std::uint64_t>(k);
    midrib.points.emplace_back(20 * (1 - std::cos(angle)) + 0.2 * key.child("x").normal(index),
                               20 * std::sin(angle) + 0.2 * key.child("y").normal(index));
  }
  return midrib;
}

void fit(benchmark::State& state) {
  const MeasuredCurve midrib = digitised(static_cast<int>(state.range(0))), widths = plain_widths();
  FittedLeaf fitted;
  for (auto _ : state) {
    fitted = fit_leaf(midrib, widths);
    benchmark::DoNotOptimize(fitted.leaf.x.data());
  }
  state.SetLabel(hash_of(fitted.leaf));
}
BENCHMARK(fit)->ArgName("points")->Arg(6)->Arg(12)->Arg(24)->Unit(benchmark::kMicrosecond);

void from_points(benchmark::State& state) {
  const MeasuredCurve midrib = digitised(static_cast<int>(state.range(0))), widths = plain_widths();
  const auto mesh_of = [](const GrassLeaf& leaf) {
    return make_grass_blade(reduced(leaf, points_kept(reduction_order(leaf), 16)), {});
  };
  const GrassLeaf fitted = fit_leaf(midrib, widths).leaf;
  double whole = std::numeric_limits<double>::infinity(), blade = whole;
  Mesh mesh;
  for (auto _ : state) {
    const double begin = now();
    mesh = mesh_of(fit_leaf(midrib, widths).leaf);
    benchmark::DoNotOptimize(mesh.positions.data());
    const double middle = now();
    mesh = mesh_of(fitted);
    benchmark::DoNotOptimize(mesh.positions.data());
    whole = std::min(whole, middle - begin);
    blade = std::min(blade, now() - middle);
  }
  state.counters["us"] = 1e6 * whole;
  state.counters["to_blade"] = whole / blade;
  state.counters["triangles"] = static_cast<double>(mesh.triangle_count());
  state.SetLabel(hash128_hex(std::as_bytes(std::span(mesh.positions))));
}
BENCHMARK(from_points)->ArgName("points")->Arg(12)->Unit(benchmark::kMicrosecond);

void age(benchmark::State& state) {
  const GrassLeaf leaf = bench_leaf(48);
  const MidribFamily family(leaf);
  GrassLeaf grown;
  for (auto _ : state) {
    grown = aged(leaf, family, 0.7);
    benchmark::DoNotOptimize(grown.x.data());
  }
  state.SetLabel(hash_of(grown));
}
BENCHMARK(age)->Unit(benchmark::kMicrosecond);

void live(benchmark::State& state) {
  const GrassLeaf leaf = bench_leaf(48);
  const MidribFamily family(leaf);
  GrassLeaf grown;
  for (auto _ : state) {
    grown = lived(leaf, family, 1, 1.0 / static_cast<double>(state.range(0)),
                  [](double time, double) { return GrowthRates{.length = 1 + time}; });
    benchmark::DoNotOptimize(grown.x.data());
  }
  state.SetLabel(hash_of(grown));
}
BENCHMARK(live)->ArgName("steps")->Arg(20)->Arg(100)->Unit(benchmark::kMicrosecond);

void load(benchmark::State& state) {
  const GrassLeaf leaf = bench_leaf(48);
  const bool has_wind = state.range(0) != 0;
  const LeafLoads loads = has_wind ? LeafLoads{.wind = {1, 0}} : LeafLoads{.pull = {1, 0}};
  GrassLeaf bent;
  for (auto _ : state) {
    bent = loaded(leaf, {}, loads);
    benchmark::DoNotOptimize(bent.x.data());
  }
  state.SetLabel(hash_of(bent));
}
BENCHMARK(load)->ArgName("wind")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

}  // namespace

int main(int count, char** arguments) {
  using bench::Asked;
  // Equal bytes allow about 14. Half of this time makes chords equal and measures the fit, where each of 48 sums and
  // quotients waits for the previous one. A quarter is reducing and meshing.
  return bench::run(count, arguments, {{"from_points/points:12", "us", Asked::at_most, 12}});
}
