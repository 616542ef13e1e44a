// SPDX-License-Identifier: Apache-2.0
// A stem of 200,000 sections that turns toward light and gravity section by section. `plain` uses the scene's own light
// and gravity, which are equal everywhere. All other benchmarks use fields of gravity. Counters: `ns/section`;
// `to_plain`, the time divided by the time of the plain stem. Both are the shortest of several runs taken in turn.
#include <algorithm>
#include <array>
#include <chrono>
#include <memory>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/components/parts/stem_path.h"
#include "meristem/scene/field/expression_field.h"
#include "meristem/scene/field/ready_fields.h"

namespace {

using namespace meristem;
using bench::Asked;

const int kSections = bench::sized(200'000, 200);

StemParameters long_stem() {
  StemParameters form;
  form.length = 40;
  form.segments = kSections;
  return form;
}

double milliseconds(const StemParameters& form, const Directions& directions) {
  const auto begin = std::chrono::steady_clock::now();
  const StemPath path = grow_stem(form, Site(), {.directions = &directions, .gravitropism = 0.8, .phototropism = 0.6});
  benchmark::DoNotOptimize(path.skeleton.position.data());
  return 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

Directions in_gravity(FieldPointer field) {
  const Directions plain;
  return plain.with(plain.light_sense(), plain.gravity_sense().with(std::move(field), false));
}

void stem_in(benchmark::State& state, const Directions& directions) {
  const StemParameters form = long_stem();
  const Directions plain;
  double best = 1e9, best_plain = 1e9;
  for (auto _ : state) {
    best_plain = std::min(best_plain, milliseconds(form, plain));
    best = std::min(best, milliseconds(form, directions));
  }
  state.counters["ns/section"] = 1e6 * best / kSections;
  state.counters["to_plain"] = best / best_plain;
}

ExpressionField formula(std::array<const char*, 3> texts) {
  const auto compile = [](const char* text) { return Expression::compile(text, {field_variables(), {}}); };
  return ExpressionField({compile(texts[0]), compile(texts[1]), compile(texts[2])}, {});
}

void plain(benchmark::State& state) { stem_in(state, Directions()); }
void cylinder(benchmark::State& state) {
  stem_in(state, in_gravity(std::make_shared<CylinderField>(FieldAxis{{1, 0, 0}}, 0.5, 0.2)));
}
void vortex(benchmark::State& state) {
  stem_in(state, in_gravity(std::make_shared<VortexField>(FieldAxis{{1, 0, 0}}, 0.2)));
}
void gusts(benchmark::State& state) {
  stem_in(state, in_gravity(std::make_shared<WindField>(Vec3(1, 0, 0), WindGusts{.share = 0.5, .size = 2})));
}
void expressions(benchmark::State& state) {
  const auto field = std::make_shared<ExpressionField>(formula({"-(x - 1)", "-1", "0.5 - z*abs(y)/(1 + x^2)"}));
  stem_in(state, in_gravity(std::make_shared<PlacedField>(field, Frame{}, 1)));
}
BENCHMARK(plain)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(cylinder)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(vortex)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(gusts)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(expressions)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

int main(int count, char** arguments) {
  return meristem::bench::run(count, arguments,
                              {{"cylinder", "to_plain", Asked::at_most, 1.5},
                               {"vortex", "to_plain", Asked::at_most, 1.5},
                               {"gusts", "to_plain", Asked::at_most, 1.5},
                               {"expressions", "to_plain", Asked::at_most, 1.5}});
}
