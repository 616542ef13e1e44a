// SPDX-License-Identifier: Apache-2.0
// Honda's tree with one axis as an L-system (P. Prusinkiewicz, A. Lindenmayer: The Algorithmic Beauty of Plants, 1990,
// figure 2.6), with two parameters and 18 steps: 1,835,002 modules and 262,143 segments. `derived_hard_coded` and
// `drawn_hard_coded` are this derivation and this drawing, written in C++ for this tree alone. Both give equal numbers
// to the last bit. Counters: modules of the last word per second, and `to_hard_coded`, the time divided by the time of
// the hard-coded program. Both are the shortest of several runs taken in turn.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/base/degrees.h"
#include "meristem/base/parallel.h"
#include "meristem/grow/lsystem/derive.h"
#include "meristem/grow/lsystem/turtle.h"
#include "meristem/plant/further_columns.h"
#include "tests/support/build_grammar.h"

namespace {

using namespace meristem;

const int kSteps = bench::sized(18, 8);
const std::size_t kNodes = std::size_t{1} << kSteps;
const std::size_t kModules = 7 * kNodes - 6;
const int kLongSteps = bench::sized(11, 5);  // 2 * 5^11 modules and more

Grammar honda_tree() {
  return build_grammar({"A(1,10)",
                        {"A(l,w) -> !(w)F(l)[&(45)B(l*0.6,w*0.707)]/(137.5)A(l*0.9,w*0.707)",
                         "B(l,w) -> !(w)F(l)[-(45)$C(l*0.6,w*0.707)]C(l*0.9,w*0.707)",
                         "C(l,w) -> !(w)F(l)[+(45)$B(l*0.6,w*0.707)]B(l*0.9,w*0.707)"}});
}

/// Letters, and the parameters of all modules in one array. This takes half the memory and a third of the time of
/// modules with two parameter slots each.
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
  return derive(grammar, kSteps, RandomKey(1), SizeLimits(), progress);
}

/// The state of a drawing at a branch.
struct HardCodedTurtle {
  DVec3 position{0};
  DVec3 heading{0, 1, 0}, left{-1, 0, 0}, up{0, 0, 1};
  double width = 0.01;
  NodeIndex node = kNoNode;
  AxisIndex axis = 0;
  std::uint16_t order = 0;
  bool begins_branch = false;

  static void turn(DVec3& a, DVec3& b, double cosine, double sine) {
    const DVec3 turned = cosine * a + sine * b;
    b = cosine * b - sine * a;
    a = turned;
  }
};

Skeleton draw_hard_coded(const HardCodedWord& word) {
  Skeleton skeleton;
  skeleton.reserve(kNodes);
  HardCodedTurtle turtle;
  std::vector<HardCodedTurtle> stack;
  AxisIndex axes = 1;
  std::vector<float> ends;  // 1 where a ] ends a branch
  ends.reserve(kNodes);
  const double cos_45 = math::cos_deg(45);
  const double sin_45 = math::sin_deg(45);
  const double cos_roll = math::cos_deg(137.5);
  const double sin_roll = math::sin_deg(137.5);
  const auto add_node = [&](NodeIndex parent) {
    const NodeIndex node = skeleton.add_node(parent, Vec3(turtle.position), 0);
    skeleton.radius[node] = static_cast<float>(turtle.width);
    skeleton.axis[node] = turtle.axis;
    skeleton.order[node] = turtle.order;
    ends.push_back(0);
    return node;
  };
  const double* in = word.parameters.data();
  for (const char letter : word.letters) {
    switch (letter) {
      case 'F':
        if (turtle.node == kNoNode) turtle.node = add_node(kNoNode);
        if (turtle.begins_branch) {
          turtle.axis = axes++;
          ++turtle.order;
          turtle.begins_branch = false;
        }
        turtle.position += in[0] * turtle.heading;
        turtle.node = add_node(turtle.node);
        break;
      case '!':
        turtle.width = in[0];
        break;
      case '&':
        HardCodedTurtle::turn(turtle.up, turtle.heading, cos_45, sin_45);
        break;
      case '+':
        HardCodedTurtle::turn(turtle.heading, turtle.left, cos_45, sin_45);
        break;
      case '-':
        HardCodedTurtle::turn(turtle.heading, turtle.left, cos_45, -sin_45);
        break;
      case '/':
        HardCodedTurtle::turn(turtle.left, turtle.up, cos_roll, sin_roll);
        break;
      case '$': {
        const DVec3 left = glm::cross(DVec3(0, 1, 0), turtle.heading);
        const double length = glm::length(left);
        if (length < 1e-6) break;
        turtle.left = left / length;
        turtle.up = glm::cross(turtle.heading, turtle.left);
        break;
      }
      case '[':
        stack.push_back(turtle);
        turtle.begins_branch = true;
        break;
      case ']':
        if (turtle.node != kNoNode) ends[turtle.node] = 1;
        turtle = stack.back();
        stack.pop_back();
        break;
      default:
        break;
    }
    in += parameter_count(letter);
  }
  skeleton.extra.emplace(kEndColumn, std::move(ends));
  return skeleton;
}

Skeleton draw_tree(const Grammar& grammar, const Word& word) {
  Progress progress;
  return draw(word, grammar.alphabet, {}, {}, SizeLimits(), "", progress).skeleton;
}

/// Ends the program if derivations or drawings differ.
void require_same() {
  const Grammar grammar = honda_tree();
  const Word word = derive_tree(grammar, 1);
  const HardCodedWord expected = derive_hard_coded();
  bool is_same = word.module_count() == kModules && expected.letters.size() == kModules &&
                 std::ranges::equal(word.parameters, expected.parameters);
  for (std::size_t k = 0; is_same && k < kModules; ++k) {
    is_same = grammar.alphabet[word.letters[k]].symbol[0] == expected.letters[k];
  }
  const Skeleton drawn = draw_tree(grammar, word);
  is_same = is_same && drawn.node_count() == kNodes && skeleton_hash(drawn) == skeleton_hash(draw_hard_coded(expected));
  if (is_same) return;
  std::fprintf(stderr, "the derivations or the drawings differ\n");
  std::exit(1);
}

double clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
/// Returns processor seconds, which are reliable on a busy machine.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <typename Work>
double seconds(Work work, double (*now)()) {
  const double start = now();
  benchmark::DoNotOptimize(work());
  return now() - start;
}

/// Returns the shortest time of `work` divided by the shortest time of `reference`, run in turns.
template <typename Work, typename Reference>
double ratio(Work work, Reference reference, double (*now)() = clock_seconds) {
  double min = 1e9;
  double min_reference = 1e9;
  for (int run = 0; run < bench::sized(20, 1); ++run) {
    min = std::min(min, seconds(work, now));
    min_reference = std::min(min_reference, seconds(reference, now));
  }
  return min / min_reference;
}

void count_modules(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kModules));
}

void derived_hard_coded(benchmark::State& state) {
  while (state.KeepRunning()) benchmark::DoNotOptimize(derive_hard_coded());
  count_modules(state);
}

void derived(benchmark::State& state) {
  const Grammar grammar = honda_tree();
  const int threads = static_cast<int>(state.range(0));
  while (state.KeepRunning()) benchmark::DoNotOptimize(derive_tree(grammar, threads));
  count_modules(state);
  state.counters["to_hard_coded"] = ratio([&] { return derive_tree(grammar, threads); }, derive_hard_coded);
}

void drawn_hard_coded(benchmark::State& state) {
  const HardCodedWord word = derive_hard_coded();
  while (state.KeepRunning()) benchmark::DoNotOptimize(draw_hard_coded(word));
  count_modules(state);
}

void drawn(benchmark::State& state) {
  const Grammar grammar = honda_tree();
  const Word word = derive_tree(grammar, 1);
  const HardCodedWord hard_coded = derive_hard_coded();
  while (state.KeepRunning()) benchmark::DoNotOptimize(draw_tree(grammar, word));
  count_modules(state);
  state.counters["to_hard_coded"] =
      ratio([&] { return draw_tree(grammar, word); }, [&] { return draw_hard_coded(hard_coded); });
}

/// From the grammar to the skeleton, one thread.
void derived_and_drawn(benchmark::State& state) {
  const Grammar grammar = honda_tree();
  const auto ours = [&] { return draw_tree(grammar, derive_tree(grammar, 1)); };
  while (state.KeepRunning()) benchmark::DoNotOptimize(ours());
  count_modules(state);
  state.counters["to_hard_coded"] = ratio(
      ours, [] { return draw_hard_coded(derive_hard_coded()); }, processor_seconds);
}

/// A word of over a hundred million modules; its counters belong to the process, from this benchmark on.
void hundred_million(benchmark::State& state) {
  const Grammar grammar = build_grammar({"F", {"F -> F[+F]F[-F]F"}});
  std::size_t modules = 0;
  while (state.KeepRunning()) {
    Progress progress;
    modules = derive(grammar, kLongSteps, RandomKey(1), SizeLimits(), progress).module_count();
  }
  state.counters["modules"] = static_cast<double>(modules);
  state.counters["peak_GB"] = meristem::bench::peak_megabytes() / 1024;
}

BENCHMARK(derived_hard_coded)->Unit(benchmark::kMillisecond);
BENCHMARK(derived)->ArgName("threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(drawn_hard_coded)->Unit(benchmark::kMillisecond);
BENCHMARK(drawn)->Unit(benchmark::kMillisecond);
BENCHMARK(derived_and_drawn)->Unit(benchmark::kMillisecond);
BENCHMARK(hundred_million)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

}  // namespace

int main(int count, char** arguments) {
  require_same();
  return bench::run(count, arguments, {{"derived_and_drawn", "to_hard_coded", bench::Asked::at_most, 1.5}});
}
