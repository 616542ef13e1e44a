// SPDX-License-Identifier: Apache-2.0
// Textures with their normals. Counters: pixels per second, and `to_plain`. `to_plain` is the time of one octave of
// gradient noise at each pixel, by the noise function of a position (base/noise.h), divided by the library's time for
// the whole texture, in one run.
#include <algorithm>
#include <chrono>
#include <span>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/base/hash.h"
#include "meristem/base/noise.h"
#include "meristem/base/parallel.h"
#include "meristem/shape/texture/texture_recipe.h"

namespace {

using meristem::Vec3;

constexpr Vec3 kColour{0.48F, 0.42F, 0.35F};

const int kPixels = meristem::bench::sized(512, 32);

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// One octave at each pixel.
double plain_seconds(int pixels) {
  const auto begin = std::chrono::steady_clock::now();
  double sum = 0;
  for (int y = 0; y < pixels; ++y) {
    for (int x = 0; x < pixels; ++x) sum += meristem::gradient_noise(meristem::RandomKey(1), 0.04 * x, 0.04 * y);
  }
  benchmark::DoNotOptimize(sum);
  return seconds_since(begin);
}

template <class Make>
void measure(benchmark::State& state, int pixels, const Make& make) {
  double plain = 1e9;
  for (int k = 0; k < 3; ++k) plain = std::min(plain, plain_seconds(pixels));
  double ours = 1e9;
  meristem::Texture texture;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    texture = make();
    ours = std::min(ours, seconds_since(begin));
  }
  state.counters["pixels/s"] =
      benchmark::Counter(static_cast<double>(pixels) * pixels, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["to_plain"] = plain / ours;
  state.SetLabel(texture.name + " " + meristem::hash128_hex(std::as_bytes(std::span(texture.colour.rgba))));
}

void bark(benchmark::State& state) {
  const meristem::BarkRecipe recipe{.style = static_cast<meristem::BarkRecipe::Style>(state.range(0))};
  const meristem::ThreadLimit limit(static_cast<int>(state.range(1)));
  measure(state, kPixels, [&] { return make_bark_texture(recipe, kColour, kPixels); });
}
BENCHMARK(bark)
    ->ArgNames({"style", "threads"})
    ->ArgsProduct({{0, 1, 2, 3}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void leaf(benchmark::State& state) {
  const meristem::LeafRecipe recipe{.veins = static_cast<meristem::LeafRecipe::Veins>(state.range(0))};
  const meristem::TextureShape shape{{{0.5F, 0}, {1, 0.4F}, {0.5F, 1}, {0, 0.4F}}, true, 0.7};
  const meristem::ThreadLimit limit(static_cast<int>(state.range(1)));
  measure(state, kPixels, [&] { return make_leaf_texture(recipe, shape, kColour, kPixels); });
}
BENCHMARK(leaf)
    ->ArgNames({"veins", "threads"})
    ->ArgsProduct({{0, 1, 2}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

int main(int count, char** arguments) { return meristem::bench::run(count, arguments); }
