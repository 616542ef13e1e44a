// SPDX-License-Identifier: Apache-2.0
// The cost of operations. All benchmarks run on one thread and measure its CPU time, so that the figures hold on a busy
// machine.
// - `by_condition` and `by_label`: a tree of some 100,000 metamers is grown twice. The first list of cuts acts after
//   the last iteration, and the second list never acts. `ms/operation` is the difference divided by the number of cuts.
//   Each cut removes a few metamers.
// - `waiting`: a tree with operations that never act. `to_free` is its time divided by the time of a tree without
//   operations.
// - `list`: a small tree with a list of operations. `exponent` is the power of the list's length with which the time
//   grows, 1 for linear time.
// - `row`: an espalier row of 200 trees over 15 iterations.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/base/parallel.h"
#include "meristem/grow/organize/organize.h"
#include "meristem/grow/prune/operation.h"

namespace {

using meristem::CutOperation;
using meristem::Expression;
using meristem::OperationSchedule;
using meristem::OrganizeParameters;
using meristem::ShootChoice;
using meristem::Skeleton;
using meristem::TreeOperation;
using meristem::Vec3;

const meristem::Scene kOpenScene;

struct Timed {
  Skeleton skeleton;
  double seconds = 0;
};

Timed grow(const OrganizeParameters& parameters, int trees = 1) {
  meristem::Progress progress;
  meristem::Stand stand;
  std::vector<meristem::OrganizeSeed> seeds(static_cast<std::size_t>(trees));
  for (std::size_t k = 0; k < seeds.size(); ++k) seeds[k].frame.origin.x = 3 * static_cast<float>(k);
  const meristem::ThreadLimit one_thread(1);
  const std::clock_t begin = std::clock();
  stand.add(make_organizer(stand, seeds, parameters, meristem::RandomKey(1), kOpenScene, {}, "tree"));
  stand.grow(progress);
  Timed timed{std::move(stand.take_skeletons(progress)[0])};
  timed.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return timed;
}

ShootChoice condition(const std::string& text) {
  return {ShootChoice::Kind::condition, text, Expression::compile(text, {meristem::shoot_variables(), {}})};
}

TreeOperation cut(int at, ShootChoice shoots) {
  TreeOperation operation;
  operation.when = OperationSchedule::at(at);
  operation.shoots = std::move(shoots);
  operation.path = "operation";
  CutOperation what;
  what.above = 1;
  operation.what = std::move(what);
  return operation;
}

/// Returns the requested number of labels of shoots with two or three metamers, spread over the tree. Cuts then remove
/// almost nothing, so the measured time does not include the faster last iteration of a smaller tree.
std::vector<std::string> twigs(const Skeleton& tree, std::size_t max) {
  const auto& number = tree.extra.find("metamer")->second;
  std::vector<int> borne(tree.node_count(), 1);
  for (auto node = static_cast<meristem::NodeIndex>(tree.node_count()); node-- > 1;) {
    borne[tree.parent[node]] += borne[node];
  }
  std::vector<std::string> name(1 + *std::max_element(tree.axis.begin(), tree.axis.end()));
  std::vector<std::string> found;
  name[0] = "main";
  for (meristem::NodeIndex node = 1; node < tree.node_count(); ++node) {
    const meristem::NodeIndex parent = tree.parent[node];
    std::string& own = name[tree.axis[node]];
    if (own.empty()) own = name[tree.axis[parent]] + "." + std::to_string(static_cast<int>(number[parent]));
    if (tree.axis[node] != 0 && number[node] == 2 && borne[parent] <= 3) found.push_back(own);
  }
  std::vector<std::string> spread;
  for (std::size_t k = 0; k < std::min(max, found.size()); ++k) {
    spread.push_back(found[k * found.size() / std::min(max, found.size())]);
  }
  return spread;
}

/// Compares with the same operations at a time that never comes. This excludes the other costs of a tree with
/// operations, which `waiting` measures.
void measure(benchmark::State& state, const std::vector<TreeOperation>& operations, const OrganizeParameters& free) {
  OrganizeParameters pruned = free, waiting = free;
  pruned.operations = waiting.operations = operations;
  for (TreeOperation& operation : waiting.operations) operation.when = OperationSchedule::at(meristem::kLastIteration);
  double without = 1e9, with = 1e9;
  Skeleton skeleton;
  double whole = 0;
  for (auto _ : state) {
    const Timed free_tree = grow(waiting);
    without = std::min(without, free_tree.seconds);
    whole = static_cast<double>(free_tree.skeleton.node_count());
    Timed timed = grow(pruned);
    with = std::min(with, timed.seconds);
    skeleton = std::move(timed.skeleton);
  }
  const auto left = static_cast<double>(skeleton.node_count());
  state.counters["metamers"] = left;
  state.counters["gone_percent"] = 100 * (1 - left / whole);
  state.counters["cuts"] = static_cast<double>(skeleton.operations.size());
  state.counters["ms/operation"] = 1e3 * (with - without) / static_cast<double>(operations.size());
  state.SetLabel(skeleton_hash(skeleton).substr(0, 16));
}

OrganizeParameters large() {
  OrganizeParameters parameters;
  parameters.iterations = static_cast<int>(meristem::bench::sized({50}, {8})[0]);
  return parameters;
}

void by_condition(benchmark::State& state) {
  const OrganizeParameters free = large();
  const TreeOperation some =
      cut(free.iterations, condition("rank >= 2 && length > 0.15 && length < 0.35 && rand(0, 1) < 0.001"));
  measure(state, std::vector<TreeOperation>(100, some), free);
}

void by_label(benchmark::State& state) {
  const OrganizeParameters free = large();
  std::vector<TreeOperation> operations;
  for (std::string& name : twigs(grow(free).skeleton, 100)) {
    operations.push_back(cut(free.iterations, ShootChoice::label(std::move(name))));
  }
  if (operations.empty()) operations.push_back(cut(free.iterations, condition("rank == 1")));
  measure(state, operations, free);
}

void waiting(benchmark::State& state) {
  const OrganizeParameters free = large();
  OrganizeParameters pruned = free;
  pruned.operations.assign(10, cut(meristem::kLastIteration, ShootChoice::leader()));
  double without = 1e9, with = 1e9;
  for (auto _ : state) {
    without = std::min(without, grow(free).seconds);
    with = std::min(with, grow(pruned).seconds);
  }
  state.counters["to_free"] = with / without;
}

void list(benchmark::State& state) {
  OrganizeParameters parameters;
  parameters.iterations = 8;
  const auto count = static_cast<std::size_t>(state.range(0));
  parameters.operations.assign(count, cut(6, condition("rank == 1 && length > 90")));
  double best = 1e9;
  for (auto _ : state) best = std::min(best, grow(parameters).seconds);
  state.counters["us/operation"] = 1e6 * best / static_cast<double>(count);
  static std::pair<double, double> fewest;  // operations and seconds
  if (fewest.first == 0) fewest = {static_cast<double>(count), best};
  if (static_cast<double>(count) == fewest.first) return;
  state.counters["exponent"] = std::log(best / fewest.second) / std::log(static_cast<double>(count) / fewest.first);
}

void row(benchmark::State& state) {
  OrganizeParameters parameters;
  parameters.iterations = 15;
  parameters.resource.alpha = 2.3;
  const auto add = [&](ShootChoice shoots, auto what) {
    TreeOperation& operation = parameters.operations.emplace_back();
    operation.shoots = std::move(shoots);
    operation.what = std::move(what);
  };
  add(ShootChoice::leader(), meristem::TrainingSupport{.line = {Vec3(0), Vec3(0, 1.8F, 0)}});
  add(ShootChoice::leader(), meristem::LayersOperation{});
  add(condition("rank == 1"), meristem::LimitOperation{12});
  add(condition("rank >= 2"), meristem::SpurOperation{2});
  double best = 1e9;
  Skeleton skeleton;
  for (auto _ : state) {
    Timed timed = grow(parameters, static_cast<int>(state.range(0)));
    best = std::min(best, timed.seconds);
    skeleton = std::move(timed.skeleton);
  }
  state.counters["s"] = best;
  state.counters["metamers"] = static_cast<double>(skeleton.node_count());
  state.counters["records"] = static_cast<double>(skeleton.operations.size());
  state.SetLabel(skeleton_hash(skeleton).substr(0, 16));
}

BENCHMARK(by_condition)->Iterations(3)->Unit(benchmark::kMillisecond);
BENCHMARK(by_label)->Iterations(3)->Unit(benchmark::kMillisecond);
BENCHMARK(waiting)->Iterations(3)->Unit(benchmark::kMillisecond);
BENCHMARK(list)
    ->ArgName("operations")
    ->ArgsProduct({meristem::bench::sized({1000, 10'000, 100'000}, {10})})
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(row)
    ->ArgName("trees")
    ->ArgsProduct({meristem::bench::sized({200}, {2})})
    ->Iterations(2)
    ->Unit(benchmark::kMillisecond);

}  // namespace

int main(int count, char** arguments) {
  using meristem::bench::Asked;
  return meristem::bench::run(count, arguments,
                              {{"by_condition", "ms/operation", Asked::at_most, 10},
                               {"by_label", "ms/operation", Asked::at_most, 1},
                               {"list/operations:10000", "exponent", Asked::at_most, 1.1},
                               {"waiting", "to_free", Asked::at_most, 1.05},
                               {"row/trees:200", "s", Asked::at_most, 10}});
}
