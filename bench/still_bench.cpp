// SPDX-License-Identifier: Apache-2.0
// Parts of pictures of shipped models, with the pixel size of a whole picture. Counters:
// - `noise`: the root mean square difference of the bytes from a picture with eight times as many samples;
// - `even_noise`: this difference for a picture in which every pixel takes all samples;
// - `to_even`: the time of the even picture divided by the time of the adaptive picture, on one thread, in one run;
// - `for_noise`: this ratio for equal noise, where the square of the noise falls as the time rises. It is below 1 if
//   noise is distributed unevenly for the look of plain ground. It is above 1 if few samples are enough, since squares
//   share samples with each other;
// - `brighter`: the mean difference of the bytes, which early stopping biases.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/base/parallel.h"
#include "meristem/components/camera.h"
#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "meristem/output/picture/camera.h"
#include "meristem/output/picture/still.h"

namespace {

using meristem::CameraView;
using meristem::Document;
using meristem::GrownDocument;
using meristem::Image;
using meristem::Progress;
using meristem::StillOptions;
using meristem::bench::sized;

const int kWholePixels = sized(1000, 40);  // of the whole picture
const int kPixels = sized(120, 8);
const int kSamples = sized(64, 4);

/// The part of a model that is drawn: its middle in film coordinates.
struct Motive {
  const char* model;
  meristem::Vec2 middle;
};
const Motive kMotives[] = {{"oak", {-0.2F, -0.35F}},
                           {"chestnut", {0.1F, 0.3F}},
                           {"wheat", {0, 0.2F}},
                           {"low-poly-oak", {0.2F, 0.2F}},
                           {"lime-row", {-0.2F, 0}}};
constexpr int kQuickMotive = 3;

/// A grown model, and the view of a part of it.
class Sitter {
 public:
  explicit Sitter(const Motive& motive) : document_(read(motive.model)), grown_(grow_document(document_, progress_)) {
    view_ = meristem::placed_view(grown_.meshes, meristem::camera_view(document_.graph), 1);
    const meristem::Camera camera(*view_.position, *view_.target, view_.field_of_view, 1);
    const float distance = glm::distance(*view_.position, *view_.target);
    view_.target = *view_.position + distance * camera.direction(motive.middle);
    view_.field_of_view = 2 * std::atan(std::tan(view_.field_of_view / 2) * kPixels / kWholePixels);
  }

  Image picture(int samples, bool even) {
    const StillOptions options{.width = kPixels, .height = kPixels, .samples = samples, .even = even};
    return render_still(grown_.meshes, document_.scene, view_, options, progress_);
  }

 private:
  static Document read(const std::string& model) {
    const std::string file = std::string(MERISTEM_SOURCE_DIR) + "/models/" + model + ".json";
    return meristem::read_document(meristem::read_text_file(file), file, meristem::builtin_components());
  }

  Progress progress_;
  Document document_;
  GrownDocument grown_;
  CameraView view_;
};

template <class Call>
double seconds_of(const Call& call) {
  const auto begin = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Returns the root mean square of the difference in red, green and blue.
double noise(const Image& picture, const Image& truth) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    const double difference = picture.rgba[i] - truth.rgba[i];
    sum += difference * difference;
  }
  return std::sqrt(sum / (0.75 * static_cast<double>(picture.rgba.size())));
}

/// Returns the mean difference in red, green and blue.
double brighter(const Image& picture, const Image& truth) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) sum += picture.rgba[i] - truth.rgba[i];
  return sum / (0.75 * static_cast<double>(picture.rgba.size()));
}

void still(benchmark::State& state) {
  const meristem::ThreadLimit limit(1);
  const Motive& motive = kMotives[state.range(0)];
  Sitter sitter(motive);
  const Image truth = sitter.picture(8 * kSamples, true);
  Image ours;
  Image even;
  double our_time = 1e9;
  double even_time = 1e9;
  for (auto _ : state) {
    our_time = std::min(our_time, seconds_of([&] { ours = sitter.picture(kSamples, false); }));
    state.PauseTiming();
    even_time = std::min(even_time, seconds_of([&] { even = sitter.picture(kSamples, true); }));
    state.ResumeTiming();
  }
  const double our_noise = noise(ours, truth);
  const double even_noise = noise(even, truth);
  state.counters["noise"] = our_noise;
  state.counters["even_noise"] = even_noise;
  state.counters["to_even"] = even_time / our_time;
  state.counters["for_noise"] = even_time * even_noise * even_noise / (our_time * our_noise * our_noise);
  state.counters["brighter"] = brighter(ours, truth);
  state.SetLabel(motive.model);
}
// A small run draws only the model that grows quickly.
BENCHMARK(still)
    ->ArgName("motive")
    ->DenseRange(sized(0, kQuickMotive), sized(4, kQuickMotive))
    ->Unit(benchmark::kMillisecond)
    ->Iterations(sized(2, 1));

}  // namespace

int main(int count, char** arguments) { return meristem::bench::run(count, arguments); }
