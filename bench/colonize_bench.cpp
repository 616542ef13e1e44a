// SPDX-License-Identifier: Apache-2.0
// Space colonization of an ellipsoid crown, from 2,400 to 240,000 points, with an equal number of nodes per point at
// every size. The step is 0.02 (2400/N)^(1/3) m, the influence 17 steps, the kill distance 2 steps. Counters: nodes,
// steps, peak memory of the process. `growth` is the library's growth. `rebuilt_tree` finds nearest nodes with a k-d
// tree of all nodes, built anew in every step. `new_nodes_tree` uses a k-d tree of the step's new nodes alone. All
// three must grow an identical tree, or the program fails. After the runs the program prints the growth of the cost
// with N, and the ratios of one thread of the library to the two references, by medians.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <tuple>

#include <benchmark/benchmark.h>
#include <nanoflann.hpp>

#include "bench/harness.h"
#include "meristem/base/hash.h"
#include "meristem/base/parallel.h"
#include "meristem/grow/colonize/colonize.h"
#include "tests/support/plain_colonizer.h"

namespace {

using meristem::ColonizeParameters;
using meristem::NodeIndex;
using meristem::PlainPoints;
using meristem::Skeleton;
using meristem::Vec3;

const meristem::RandomKey kKey(1);

/// Returns points, uniform in an ellipsoid with half axes of 0.33, 0.55 and 0.33 m that touches the root from above.
std::vector<Vec3> ellipsoid(std::uint64_t count) {
  std::vector<Vec3> points;
  for (std::uint64_t trial = 0; points.size() < count; ++trial) {
    const Vec3 point =
        2.0F * Vec3(kKey.uniform(3 * trial), kKey.uniform(3 * trial + 1), kKey.uniform(3 * trial + 2)) - 1.0F;
    if (glm::dot(point, point) <= 1) points.push_back(Vec3(0.33F, 0.55F, 0.33F) * point + Vec3(0, 0.56F, 0));
  }
  return points;
}

ColonizeParameters parameters(std::uint64_t count) {
  const double step = 0.02 * std::cbrt(2400.0 / static_cast<double>(count));
  return {.step = step,
          .influence = 17 * step,
          .kill = 2 * step,
          .iterations = 100'000,
          .finish = {.decimate = 0, .relax = false, .subdivide = 0}};
}

/// A k-d tree of some nodes. Coordinates are added in the order x, z, y, as growth does.
class NodeTree {
 public:
  NodeTree(const std::vector<Vec3>& nodes, std::size_t first) : nodes_(nodes), first_(first), tree_(3, *this, {10}) {
    tree_.buildIndex();
  }
  /// Returns the nearest node and its squared distance.
  std::pair<NodeIndex, float> nearest(Vec3 point) const {
    const float query[3] = {point.x, point.z, point.y};
    std::uint32_t index = 0;
    float distance2 = 0;
    tree_.knnSearch(query, 1, &index, &distance2);
    return {static_cast<NodeIndex>(first_ + index), distance2};
  }

  std::size_t kdtree_get_point_count() const { return nodes_.size() - first_; }
  float kdtree_get_pt(std::size_t index, std::size_t axis) const {
    constexpr int kAxes[3] = {0, 2, 1};
    return nodes_[first_ + index][kAxes[axis]];
  }
  template <class Bounds>
  bool kdtree_get_bbox(Bounds&) const {
    return false;
  }

 private:
  using Tree =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, NodeTree>, NodeTree, 3, std::uint32_t>;
  const std::vector<Vec3>& nodes_;
  std::size_t first_;
  Tree tree_;
};

void search_rebuilt_tree(const std::vector<Vec3>& nodes, NodeIndex, PlainPoints& points) {
  const NodeTree tree(nodes, 0);
  for (std::size_t k = 0; k < points.position.size(); ++k) {
    std::tie(points.nearest[k], points.distance2[k]) = tree.nearest(points.position[k]);
  }
}

void search_new_nodes_tree(const std::vector<Vec3>& nodes, NodeIndex first_new, PlainPoints& points) {
  const NodeTree tree(nodes, first_new);
  for (std::size_t k = 0; k < points.position.size(); ++k) {
    const auto [node, distance2] = tree.nearest(points.position[k]);
    if (distance2 >= points.distance2[k]) continue;
    points.nearest[k] = node;
    points.distance2[k] = distance2;
  }
}

const meristem::Scene kOpenScene;

Skeleton grow(const std::vector<Vec3>& points) {
  meristem::Progress progress;
  meristem::Stand stand;
  stand.add(
      make_colonizer(stand, {{Vec3(0), points}}, parameters(points.size()), kKey, kOpenScene, {}, "tree", progress));
  stand.grow(progress);
  return std::move(stand.take_skeletons(progress)[0]);
}

/// Returns a hash of the positions and parents of the nodes, without radii and axes.
std::string form_hash(const Skeleton& skeleton) {
  return meristem::hash128_hex(std::as_bytes(std::span(skeleton.position))).substr(0, 8) +
         meristem::hash128_hex(std::as_bytes(std::span(skeleton.parent))).substr(0, 8);
}

/// The form and the times of every run, by name and points.
struct Run {
  std::string form;
  std::vector<double> seconds;

  double median() const {
    std::vector<double> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted.empty() ? 0 : sorted[sorted.size() / 2];
  }
};
std::map<std::pair<std::string, std::uint64_t>, Run>& runs() {
  static std::map<std::pair<std::string, std::uint64_t>, Run> all;
  return all;
}

template <class Grow>
void measure(benchmark::State& state, const std::string& name, Grow grow_tree) {
  const auto count = static_cast<std::uint64_t>(state.range(0));
  const std::vector<Vec3> points = ellipsoid(count);
  Run& run = runs()[{name, count}];
  Skeleton skeleton;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    skeleton = grow_tree(points);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    run.seconds.push_back(seconds.count());
  }
  run.form = form_hash(skeleton);
  state.counters["nodes"] = static_cast<double>(skeleton.node_count());
  state.counters["steps"] = *std::max_element(skeleton.birth.begin(), skeleton.birth.end());
  state.counters["peak_MB"] = meristem::bench::peak_megabytes();
  state.counters["median_ms"] = 1000 * run.median();
  state.SetLabel(run.form);
}

void growth(benchmark::State& state) {
  const auto threads = static_cast<int>(state.range(1));
  const meristem::ThreadLimit limit(threads);
  measure(state, threads == 1 ? "growth" : "growth_threads", grow);
}
BENCHMARK(growth)
    ->ArgNames({"points", "threads"})
    ->ArgsProduct({meristem::bench::sized({2'400, 7'590, 24'000, 75'900, 240'000}, {2'400}), {1}})
    ->Args({meristem::bench::sized(240'000, 2'400), 2})
    ->MinTime(meristem::bench::sized(3.0, 1e-6))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The references take half a minute, so each runs once.
void as_reference(benchmark::internal::Benchmark* reference) {
  reference->ArgName("points")->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const std::int64_t points : meristem::bench::sized({24'000, 240'000}, {2'400})) reference->Arg(points);
}

void rebuilt_tree(benchmark::State& state) {
  measure(state, "rebuilt_tree", [](const std::vector<Vec3>& points) {
    return grow_plainly(points, parameters(points.size()), kKey.child("tree").child(0), search_rebuilt_tree);
  });
}
BENCHMARK(rebuilt_tree)->Apply(as_reference);

void new_nodes_tree(benchmark::State& state) {
  measure(state, "new_nodes_tree", [](const std::vector<Vec3>& points) {
    return grow_plainly(points, parameters(points.size()), kKey.child("tree").child(0), search_new_nodes_tree);
  });
}
BENCHMARK(new_nodes_tree)->Apply(as_reference);

/// Prints exponent and ratios of the runs. Returns true if all runs grew equal trees.
bool compare_runs() {
  const auto seconds = [](const std::string& name, std::uint64_t count) {
    const auto found = runs().find({name, count});
    return found == runs().end() ? 0.0 : found->second.median();
  };
  if (seconds("growth", 2'400) > 0 && seconds("growth", 240'000) > 0) {
    std::printf("cost grows with points^%.2f from 2,400 to 240,000\n",
                std::log(seconds("growth", 240'000) / seconds("growth", 2'400)) / std::log(100.0));
  }
  bool all_equal = true;
  for (const auto& [key, run] : runs()) {
    const auto& [name, count] = key;
    const auto ours = runs().find({"growth", count});
    if (ours == runs().end() || name == "growth") continue;
    std::printf("%s / growth at %lu points: %.1f\n", name.c_str(), static_cast<unsigned long>(count),
                run.median() / ours->second.median());
    if (run.form == ours->second.form) continue;
    std::printf("%s grew another tree\n", name.c_str());
    all_equal = false;
  }
  return all_equal;
}

}  // namespace

int main(int count, char** arguments) { return meristem::bench::run(count, arguments, {}, compare_runs); }
