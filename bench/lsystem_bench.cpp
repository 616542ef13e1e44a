// SPDX-License-Identifier: Apache-2.0
// Honda's tree with one axis as an L-system (P. Prusinkiewicz, A. Lindenmayer: The Algorithmic Beauty of Plants, 1990,
// figure 2.6), with two parameters and 18 steps: 1,835,002 modules. `hard_coded` is the same derivation written in C++
// for this tree alone. Counters: modules of the last word a second, and `to_hard_coded`, the time as a multiple of the
// hard-coded derivation's, both the least of some runs taken in turn.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "meristem/base/parallel.h"
#include "meristem/grow/lsystem/derive.h"
#include "tests/support/build_grammar.h"

namespace {

using namespace meristem;

constexpr int kSteps = 18;
constexpr std::size_t kModules = 1'835'002;

Grammar honda_tree() {
  return build_grammar({"A(1,10)",
                        {"A(l,w) -> !(w)F(l)[&(45)B(l*0.6,w*0.707)]/(137.5)A(l*0.9,w*0.707)",
                         "B(l,w) -> !(w)F(l)[-(45)$C(l*0.6,w*0.707)]C(l*0.9,w*0.707)",
                         "C(l,w) -> !(w)F(l)[+(45)$B(l*0.6,w*0.707)]B(l*0.9,w*0.707)"}});
}

/// A module with room for the parameters of all.
struct Module {
  char symbol;
  double first, second;
};

void append_fork(const Module& apex, char turn, char next, std::vector<Module>& word) {
  const double l = apex.first;
  const double w = apex.second;
  word.push_back({'!', w, 0});
  word.push_back({'F', l, 0});
  word.push_back({'[', 0, 0});
  word.push_back({turn, 45, 0});
  if (turn != '&') word.push_back({'$', 0, 0});
  word.push_back({turn == '&' ? 'B' : next, l * 0.6, w * 0.707});
  word.push_back({']', 0, 0});
  if (turn == '&') word.push_back({'/', 137.5, 0});
  word.push_back({next, l * 0.9, w * 0.707});
}

std::vector<Module> derive_hard_coded() {
  std::vector<Module> word = {{'A', 1, 10}};
  std::vector<Module> next;
  for (int step = 0; step < kSteps; ++step) {
    next.clear();
    next.reserve(2 * word.size() + 16);
    for (const Module& module : word) {
      switch (module.symbol) {
        case 'A':
          append_fork(module, '&', 'A', next);
          break;
        case 'B':
          append_fork(module, '-', 'C', next);
          break;
        case 'C':
          append_fork(module, '+', 'B', next);
          break;
        default:
          next.push_back(module);
      }
    }
    std::swap(word, next);
  }
  return word;
}

Word derive_tree(const Grammar& grammar, int threads) {
  const ThreadLimit limit(threads);
  Progress progress;
  return derive(grammar, kSteps, RandomKey(1), Limits(), progress);
}

/// Ends the program if the two derivations differ.
void require_same() {
  const Grammar grammar = honda_tree();
  const Word word = derive_tree(grammar, 1);
  const std::vector<Module> expected = derive_hard_coded();
  bool is_same = word.module_count() == kModules && expected.size() == kModules;
  std::size_t parameter = 0;
  for (std::size_t k = 0; is_same && k < kModules; ++k) {
    const Letter& letter = grammar.alphabet[word.letters[k]];
    is_same = letter.symbol[0] == expected[k].symbol &&
              (letter.arity < 1 || word.parameters[parameter] == expected[k].first) &&
              (letter.arity < 2 || word.parameters[parameter + 1] == expected[k].second);
    parameter += letter.arity;
  }
  if (is_same) return;
  std::fprintf(stderr, "the derivations differ\n");
  std::exit(1);
}

template <typename Work>
double seconds(Work work) {
  const auto start = std::chrono::steady_clock::now();
  benchmark::DoNotOptimize(work());
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void hard_coded(benchmark::State& state) {
  while (state.KeepRunning()) benchmark::DoNotOptimize(derive_hard_coded());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kModules));
}

void derived(benchmark::State& state) {
  const Grammar grammar = honda_tree();
  const int threads = static_cast<int>(state.range(0));
  while (state.KeepRunning()) benchmark::DoNotOptimize(derive_tree(grammar, threads));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kModules));
  double least = 1e9;
  double least_hard_coded = 1e9;
  for (int run = 0; run < 20; ++run) {
    least = std::min(least, seconds([&] { return derive_tree(grammar, threads); }));
    least_hard_coded = std::min(least_hard_coded, seconds(derive_hard_coded));
  }
  state.counters["to_hard_coded"] = least / least_hard_coded;
}

BENCHMARK(hard_coded)->Unit(benchmark::kMillisecond);
BENCHMARK(derived)->ArgName("threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

int main(int argc, char** argv) {
  require_same();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
