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
#include <initializer_list>
#include <string_view>
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

/// Letters, and the parameters of all modules one after another: half the memory of modules with room for two each, and
/// a third of the time.
struct HardCodedWord {
  std::vector<char> letters;
  std::vector<double> parameters;
};

std::size_t parameter_count(char letter) {
  switch (letter) {
    case 'A':
    case 'B':
    case 'C':
      return 2;
    case '[':
    case ']':
    case '$':
      return 0;
    default:
      return 1;
  }
}

struct Pen {
  char* letter;
  double* parameter;

  void write(std::string_view letters, std::initializer_list<double> parameters) {
    letter = std::copy(letters.begin(), letters.end(), letter);
    parameter = std::copy(parameters.begin(), parameters.end(), parameter);
  }
};

void rewrite_hard_coded(const HardCodedWord& word, HardCodedWord& next) {
  const auto apices = static_cast<std::size_t>(std::count_if(
      word.letters.begin(), word.letters.end(), [](char letter) { return letter >= 'A' && letter <= 'C'; }));
  next.letters.clear();
  next.parameters.clear();
  next.letters.resize(word.letters.size() + 7 * apices);
  next.parameters.resize(word.parameters.size() + 6 * apices);
  Pen pen{next.letters.data(), next.parameters.data()};
  const double* in = word.parameters.data();
  for (const char letter : word.letters) {
    const double l = in[0];
    const double w = in[1];
    switch (letter) {
      case 'A':
        pen.write("!F[&B]/A", {w, l, 45, l * 0.6, w * 0.707, 137.5, l * 0.9, w * 0.707});
        break;
      case 'B':
        pen.write("!F[-$C]C", {w, l, 45, l * 0.6, w * 0.707, l * 0.9, w * 0.707});
        break;
      case 'C':
        pen.write("!F[+$B]B", {w, l, 45, l * 0.6, w * 0.707, l * 0.9, w * 0.707});
        break;
      default:
        *pen.letter++ = letter;
        if (parameter_count(letter) == 1) *pen.parameter++ = l;
    }
    in += parameter_count(letter);
  }
  next.letters.resize(static_cast<std::size_t>(pen.letter - next.letters.data()));
  next.parameters.resize(static_cast<std::size_t>(pen.parameter - next.parameters.data()));
}

HardCodedWord derive_hard_coded() {
  HardCodedWord word{{'A'}, {1, 10}};
  HardCodedWord next;
  for (int step = 0; step < kSteps; ++step) {
    rewrite_hard_coded(word, next);
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
  const HardCodedWord expected = derive_hard_coded();
  bool is_same = word.module_count() == kModules && expected.letters.size() == kModules &&
                 std::ranges::equal(word.parameters, expected.parameters);
  for (std::size_t k = 0; is_same && k < kModules; ++k) {
    is_same = grammar.alphabet[word.letters[k]].symbol[0] == expected.letters[k];
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
