// SPDX-License-Identifier: Apache-2.0
// Expressions over many lanes, compared with an equal formula as a C++ function in the same program. `native` uses the
// C library's functions in radians, as an author would write it. Counters: lanes a second, and `to_native`, the
// expression's speed divided by the speed of the native code, which is measured right before it.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/base/expression/expression.h"
#include "meristem/base/vec.h"

namespace {

using meristem::Expression;
using meristem::RandomKey;

constexpr std::size_t kLanes = 4096;

struct Lanes {
  Lanes() {
    for (std::size_t k = 0; k < kLanes; ++k) {
      i.push_back(static_cast<double>(k));
      u.push_back(static_cast<double>(k) / kLanes);
      keys.push_back(RandomKey(1).child(k));
    }
    out.resize(kLanes);
  }
  std::vector<double> i, u, out;
  std::vector<RandomKey> keys;
};

struct Formula {
  const char* name;
  const char* text;
  double (*native)(double i, double u);
};

constexpr Formula kFormulas[] = {
    {"angle", "20 + 15*sin(i*137.5)*u",
     [](double i, double u) { return 20 + 15 * std::sin(meristem::radians(i * 137.5)) * u; }},
    {"arithmetic", "(1 - u)*(i % 2 == 0 ? 0.4 : 0.6) + 0.1*u*u",
     [](double i, double u) { return (1 - u) * (std::fmod(i, 2) == 0 ? 0.4 : 0.6) + 0.1 * u * u; }},
    {"taper", "0.02*pow(1 - u, 1.3) + 0.001", [](double, double u) { return 0.02 * std::pow(1 - u, 1.3) + 0.001; }},
    {"profile", "smoothstep(0, 0.2, u)*lerp(1, 0.3, u)",
     [](double, double u) {
       const double t = std::fmin(std::fmax(u / 0.2, 0), 1);
       return t * t * (3 - 2 * t) * (1 + (0.3 - 1) * u);
     }},
};

void run_native(const Formula& formula, Lanes& lanes) {
  for (std::size_t k = 0; k < kLanes; ++k) lanes.out[k] = formula.native(lanes.i[k], lanes.u[k]);
  benchmark::DoNotOptimize(lanes.out.data());
  benchmark::ClobberMemory();
}

void run_expression(const Expression& expression, Lanes& lanes) {
  const double* const variables[] = {lanes.i.data(), lanes.u.data()};
  expression.evaluate(kLanes, variables, lanes.keys, lanes.out.data());
  benchmark::DoNotOptimize(lanes.out.data());
  benchmark::ClobberMemory();
}

/// Returns the shortest time of several runs of `work`, in seconds.
template <typename Work>
double min_seconds(Work work) {
  double min = 1e9;
  for (int attempt = 0; attempt < meristem::bench::sized(200, 1); ++attempt) {
    const auto start = std::chrono::steady_clock::now();
    work();
    min = std::min(min, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return min;
}

void count_lanes(benchmark::State& state) {
  state.counters["lanes"] =
      benchmark::Counter(static_cast<double>(kLanes), benchmark::Counter::kIsIterationInvariantRate);
}

void native(benchmark::State& state, const Formula& formula) {
  Lanes lanes;
  while (state.KeepRunning()) run_native(formula, lanes);
  count_lanes(state);
}

void batched(benchmark::State& state, const Formula& formula) {
  Lanes lanes;
  const Expression expression = Expression::compile(formula.text, {{"i", "u"}, {}});
  while (state.KeepRunning()) run_expression(expression, lanes);
  count_lanes(state);
  state.counters["to_native"] =
      min_seconds([&] { run_native(formula, lanes); }) / min_seconds([&] { run_expression(expression, lanes); });
}

/// One lane per call, as for a component with a single instance.
void single(benchmark::State& state, const Formula& formula) {
  const Expression expression = Expression::compile(formula.text, {{"i", "u"}, {}});
  double values[] = {3, 0.25};
  while (state.KeepRunning()) {
    values[0] += 1;
    benchmark::DoNotOptimize(expression.evaluate(values));
  }
  state.SetItemsProcessed(state.iterations());
}

/// Functions without a native counterpart of equal result.
void drawing(benchmark::State& state, const char* text) {
  Lanes lanes;
  const Expression expression = Expression::compile(text, {{"i", "u"}, {}});
  while (state.KeepRunning()) run_expression(expression, lanes);
  count_lanes(state);
}

void compile(benchmark::State& state) {
  const meristem::ExpressionNames names{{"v", "i", "n", "u", "depth", "order", "x", "y", "z"}, {{"age", 12}}};
  while (state.KeepRunning()) benchmark::DoNotOptimize(Expression::compile("20 + 15*sin(i*137.5)*u*age", names));
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK(compile);
BENCHMARK_CAPTURE(drawing, rand, "rand(-1, 1)");
BENCHMARK_CAPTURE(drawing, gauss, "gauss(0, 1)");
BENCHMARK_CAPTURE(drawing, noise_3, "noise(i*0.1, u, 0.5)");

}  // namespace

int main(int argc, char** argv) {
  for (const Formula& formula : kFormulas) {
    const std::string name = formula.name;
    benchmark::RegisterBenchmark(("native/" + name).c_str(), native, formula);
    benchmark::RegisterBenchmark(("batched/" + name).c_str(), batched, formula);
    benchmark::RegisterBenchmark(("single/" + name).c_str(), single, formula);
  }
  return meristem::bench::run(argc, argv);
}
