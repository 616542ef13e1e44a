// SPDX-License-Identifier: Apache-2.0
// Growth in the light, with the trees of the published evaluation: 900 points, step 0.02 m, no influence limit. Times
// are processor times.
// - `growth`: one tree on one thread, without and with response A (5 mm a step), under a still sun or the sun of a day.
//   The tree stands in the open, or among ten balls of about a thousand triangles that stand before the sun. Counters:
//   nodes; `shaded`, the share of the cloud's light that the balls keep off; `to_open`, the median ratio of the time
//   among balls to the time in the open, taken in turns; `to_open_a_node`, this ratio for each node.
// - `evaluation`: ten clouds, eleven shifts, two scenes, grown and measured.
// - `response_...`: means over ten clouds of the measures of the evaluation (degrees, metres, percent), in scene A or
//   B. `shifted` moves the points by a number of millimetres per step, `scaled` makes the trees 3.7 m high, `limited`
//   leaves out the darkest share (percent), and `drifted` moves points at a held height.
// - `cloud_light`: the light of each point of a cloud among the other points, under 15 positions of the sun.
//   `a_point_and_light` must not grow with the number of points.
#include <algorithm>
#include <cstdint>
#include <ctime>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/base/parallel.h"
#include "meristem/measure/crown_light.h"
#include "meristem/measure/tree_form.h"
#include "meristem/scene/light_of_points.h"
#include "meristem/shape/solid/primitives.h"
#include "tests/support/evaluation.h"

namespace {

using meristem::DirectionalLight;
using meristem::LightResponse;
using meristem::Scene;
using meristem::Skeleton;
using meristem::Vec3;

std::vector<DirectionalLight> day_in_london() { return meristem::sun_of_day(meristem::radians(51.5), 126, 1); }

/// A ball of about a thousand triangles.
meristem::Obstacle ball(Vec3 centre, double radius) {
  meristem::Obstacle obstacle;
  const meristem::Mesh sphere = meristem::make_sphere(radius, 32);
  for (const Vec3 position : sphere.positions) obstacle.mesh.positions.emplace_back(centre + position);
  obstacle.mesh.triangles = sphere.triangles;
  return obstacle;
}

/// Ten balls between the crown and the positions of the sun from 8 to 17 h. The ball of noon is also before the still
/// sun.
meristem::Obstacles balls_before_the_sun() {
  const Vec3 crown(0, 2.5F, 0);
  const std::vector<DirectionalLight> day = day_in_london();
  std::vector<meristem::Obstacle> bodies;
  for (std::size_t k = 3; k < 13; ++k) bodies.push_back(ball(crown + 6.0F * day[k].toward, 1.3));
  return meristem::Obstacles(bodies);
}

/// Returns the share of the open-air light of `cloud` that obstacles block.
double shaded_share(const std::vector<Vec3>& cloud, const Scene& scene) {
  double shaded = 0;
  for (const Vec3 point : cloud) {
    for (const DirectionalLight& sun : scene.light.sun) {
      if (scene.obstacles.block(point, sun.toward, 1e9)) shaded += sun.strength;
    }
  }
  return shaded / static_cast<double>(cloud.size());
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void growth(benchmark::State& state) {
  const meristem::ThreadLimit limit(1);
  const LightResponse light{.shift = 0.001 * static_cast<double>(state.range(0))};
  Scene open = meristem::evaluation_scene_a();
  if (state.range(1) != 0) open.light.sun = day_in_london();
  Scene among_balls = open;
  if (state.range(2) != 0) among_balls.obstacles = balls_before_the_sun();
  const std::vector<Vec3> cloud = meristem::evaluation_cloud(0);
  std::vector<double> seconds;
  std::vector<double> ratios;
  std::size_t nodes = 0;
  std::size_t open_nodes = 0;
  for (auto _ : state) {
    const double begin = processor_seconds();
    nodes = meristem::grow_evaluation_tree(cloud, among_balls, light).node_count();
    const double end = processor_seconds();
    state.SetIterationTime(end - begin);
    seconds.push_back(end - begin);
    if (among_balls.obstacles.empty()) continue;
    open_nodes = meristem::grow_evaluation_tree(cloud, open, light).node_count();
    ratios.push_back((end - begin) / (processor_seconds() - end));
  }
  state.counters["nodes"] = static_cast<double>(nodes);
  state.counters["median_ms"] = 1000 * median(seconds);
  if (among_balls.obstacles.empty()) return;
  state.counters["shaded"] = shaded_share(cloud, among_balls);
  state.counters["to_open"] = median(ratios);
  state.counters["to_open_a_node"] = median(ratios) * static_cast<double>(open_nodes) / static_cast<double>(nodes);
}
BENCHMARK(growth)
    ->ArgNames({"shift_mm", "day", "balls"})
    ->Args({0, 0, 0})
    ->Args({0, 0, 10})
    ->Args({5, 0, 0})
    ->Args({5, 0, 10})
    ->Args({5, 1, 0})
    ->Args({5, 1, 10})
    ->Unit(benchmark::kMillisecond)
    ->MinTime(meristem::bench::sized(2.0, 1e-6))
    ->UseManualTime();

void evaluation(benchmark::State& state) {
  const std::size_t clouds = meristem::bench::sized(10, 1);
  const std::size_t shifts = meristem::bench::sized(11, 1);
  const std::vector<Scene> scenes{meristem::evaluation_scene_a(), meristem::evaluation_scene_b()};
  std::vector<meristem::TreeForm> forms(clouds * shifts * scenes.size());
  std::vector<double> lit_shares(forms.size());
  for (auto _ : state) {
    meristem::parallel_for(forms.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const Scene& scene = scenes[k / (clouds * shifts)];
        const LightResponse light{.shift = 0.001 * static_cast<double>(k / clouds % shifts)};
        const Skeleton tree = meristem::grow_evaluation_tree(meristem::evaluation_cloud(k % clouds), scene, light);
        forms[k] = measure_form(tree, meristem::NodeChildren(tree));
        lit_shares[k] = meristem::measure_crown_light(forms[k].crown_hull, scene).lit_share;
      }
    });
  }
  double nodes = 0;
  double lit = 0;
  for (const meristem::TreeForm& form : forms) nodes += static_cast<double>(form.nodes);
  for (const double share : lit_shares) lit += share;
  state.counters["trees"] = static_cast<double>(forms.size());
  state.counters["nodes"] = nodes;
  state.counters["lit_share"] = lit / static_cast<double>(forms.size());
}
BENCHMARK(evaluation)->Unit(benchmark::kSecond)->Iterations(1)->MeasureProcessCPUTime()->UseRealTime();

Scene scene_of(const benchmark::State& state) {
  return state.range(0) == 0 ? meristem::evaluation_scene_a() : meristem::evaluation_scene_b();
}

void show(benchmark::State& state, const meristem::Evaluation& mean) {
  state.counters["azimuth"] = mean.azimuth;
  state.counters["spread"] = mean.spread;
  state.counters["altitude"] = mean.altitude;
  state.counters["centroid_azimuth"] = mean.centroid_azimuth;
  state.counters["centroid_radius"] = mean.centroid_radius;
  state.counters["height"] = mean.height;
  state.counters["lit_share"] = mean.lit_share;
}

void response_shifted(benchmark::State& state) {
  meristem::Evaluation mean;
  for (auto _ : state) mean = evaluate(scene_of(state), {.shift = 0.001 * static_cast<double>(state.range(1))});
  show(state, mean);
}
BENCHMARK(response_shifted)
    ->ArgNames({"scene", "mm"})
    ->ArgsProduct({{0, 1}, meristem::bench::sized(benchmark::CreateDenseRange(0, 10, 1), {5})})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->UseRealTime();

void response_scaled(benchmark::State& state) {
  meristem::Evaluation mean;
  for (auto _ : state) {
    mean = evaluate_at_height(scene_of(state), {.shift = 0.001 * static_cast<double>(state.range(1))}, 3.7);
  }
  show(state, mean);
}
BENCHMARK(response_scaled)
    ->ArgNames({"scene", "mm"})
    ->ArgsProduct({{1}, meristem::bench::sized({0, 5, 10}, {0})})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->UseRealTime();

void response_limited(benchmark::State& state) {
  meristem::Evaluation mean;
  const LightResponse light{.limit = {.share = 0.01 * static_cast<double>(state.range(1)), .radius = 0.3, .k = 0.1}};
  for (auto _ : state) mean = evaluate(scene_of(state), light);
  show(state, mean);
}
BENCHMARK(response_limited)
    ->ArgNames({"scene", "percent"})
    ->ArgsProduct({meristem::bench::sized({0, 1}, {0}), meristem::bench::sized({0, 24, 36, 60}, {24})})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->UseRealTime();

void response_drifted(benchmark::State& state) {
  meristem::Evaluation mean;
  const LightResponse light{
      .drift = 0.001 * static_cast<double>(state.range(1)), .sunlit_weight = 0.25, .hold_height = true};
  for (auto _ : state) mean = evaluate(scene_of(state), light);
  show(state, mean);
}
BENCHMARK(response_drifted)
    ->ArgNames({"scene", "mm"})
    ->ArgsProduct({meristem::bench::sized({0, 1}, {0}), meristem::bench::sized({0, 10, 18}, {10})})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->UseRealTime();

void cloud_light(benchmark::State& state) {
  const meristem::ThreadLimit limit(1);
  const std::vector<Vec3> cloud = meristem::evaluation_cloud(0, static_cast<std::uint64_t>(state.range(0)));
  Scene scene;
  scene.light.sun = day_in_london();
  const LightResponse response;
  std::vector<double> light;
  for (auto _ : state) {
    light = light_of_points(cloud, scene, response.limit.radius, response.limit.k, meristem::Progress());
  }
  double sum = 0;
  for (const double of_point : light) sum += of_point;
  const auto rays = static_cast<double>(cloud.size() * scene.light.sun.size());
  state.counters["mean_light"] = sum / static_cast<double>(light.size());
  state.counters["a_point_and_light"] =
      benchmark::Counter(rays, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(cloud_light)
    ->ArgName("points")
    ->ArgsProduct({meristem::bench::sized({2'400, 24'000, 240'000}, {2'400})})
    ->Unit(benchmark::kMillisecond);

}  // namespace

int main(int count, char** arguments) { return meristem::bench::run(count, arguments); }
