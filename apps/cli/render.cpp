// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "commands.h"
#include "documents.h"
#include "meristem/base/parallel.h"
#include "meristem/components/camera.h"
#include "meristem/document/grow.h"
#include "meristem/output/png.h"
#include "meristem/output/still.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

struct RenderOptions {
  DocumentOptions document;
  std::string output;
  std::string size;
  std::string view;
  std::optional<int> samples;
  std::optional<int> turntable;  // frames all around
  bool transparent = false;
};

constexpr int kMostFrames = 9999;

/// `oak_007.png` for frame 7 of some hundred of `oak.png`: as many digits as the last frame needs, at least three.
std::string frame_path(const std::string& path, int frame, int frames) {
  const std::size_t digits = std::max<std::size_t>(3, std::to_string(frames - 1).size());
  return fmt::format("{}_{:0{}}{}", path.substr(0, path.size() - 4), frame, digits, path.substr(path.size() - 4));
}

std::vector<std::string> picture_paths(const RenderOptions& options) {
  if (!options.turntable) return {options.output};
  if (options.output == "-") {
    throw InputError(Diagnostic{.message = "numbered frames cannot be written to standard output",
                                .expected = "a file name such as oak.png for oak_000.png, oak_001.png, ..."});
  }
  if (*options.turntable < 1 || *options.turntable > kMostFrames) {
    throw InputError(Diagnostic{.message = fmt::format("--turntable cannot be {}", *options.turntable),
                                .expected = fmt::format("1 to {} frames", kMostFrames)});
  }
  std::vector<std::string> paths;
  for (int k = 0; k < *options.turntable; ++k) {
    paths.push_back(frame_path(options.output, k, *options.turntable));
  }
  return paths;
}

/// Two numbers around `separator`. Throws InputError with the option's name.
template <class Number>
std::pair<Number, Number> number_pair(const std::string& text, char separator, const char* option,
                                      const char* expected) {
  std::pair<Number, Number> pair{};
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, pair.first);
  if (first.ec == std::errc() && first.ptr != end && *first.ptr == separator) {
    const auto second = std::from_chars(first.ptr + 1, end, pair.second);
    const bool is_finite = std::isfinite(static_cast<double>(pair.first) + static_cast<double>(pair.second));
    if (second.ec == std::errc() && second.ptr == end && is_finite) return pair;
  }
  throw InputError(Diagnostic{.message = fmt::format("{} cannot be '{}'", option, text), .expected = expected});
}

void check_ending(const std::string& path) {
  if (path == "-" || (path.size() > 4 && (path.ends_with(".png") || path.ends_with(".PNG")))) return;
  throw InputError(Diagnostic{.message = fmt::format("pictures cannot be written to '{}'", path),
                              .expected = "a file that ends in .png"});
}

void render(const RenderOptions& options) {
  check_ending(options.output);
  const std::vector<std::string> paths = picture_paths(options);
  const Document document = open_document(options.document);
  StillOptions still{.width = document.output.size[0], .height = document.output.size[1]};
  still.samples = options.samples.value_or(document.output.samples);
  still.transparent = options.transparent;
  if (!options.size.empty()) {
    std::tie(still.width, still.height) =
        number_pair<int>(options.size, 'x', "--size", "WIDTHxHEIGHT in pixels, such as 1200x1200");
  }
  View view = camera_view(document.graph, document.structure);
  if (!options.view.empty()) {
    const auto [azimuth, altitude] =
        number_pair<double>(options.view, ',', "--view", "AZIMUTH,ALTITUDE in degrees, such as 150,6");
    if (!(std::abs(azimuth) <= 360 && std::abs(altitude) <= 89)) {
      throw InputError(Diagnostic{.message = fmt::format("--view cannot be '{}'", options.view),
                                  .expected = "an azimuth from -360 to 360 and an altitude from -89 to 89 degrees"});
    }
    view.position.reset();
    view.azimuth = radians(azimuth);
    view.altitude = radians(altitude);
  }
  check_still_options(still);
  for (const std::string& path : paths) check_output(path);

  const ThreadLimit threads(options.document.threads);
  {
    TerminalProgress terminal(options.document.quiet);
    const GrownDocument grown = grow_document(document, terminal.progress());
    const Vec3 middle = grown.meshes.bounds().centre();
    for (std::size_t k = 0; k < paths.size(); ++k) {
      const double turn = 2 * kPi * static_cast<double>(k) / static_cast<double>(paths.size());
      const View frame = turned(view, middle, turn);
      write_png(render_still(grown.meshes, document.scene, frame, still, terminal.progress()), paths[k]);
    }
  }
  if (!options.document.quiet) {
    const std::string written = paths.size() == 1 ? paths[0] : fmt::format("{} to {}", paths.front(), paths.back());
    print_status(fmt::format("{}: {} x {} pixels, {} samples", written, still.width, still.height, still.samples));
  }
}

}  // namespace

void add_render(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("render", "Grow a document and make a picture of it");
  auto options = std::make_shared<RenderOptions>();
  options->document.add_to(*command);
  command->add_option("-o,--output", options->output, "PNG file to write; - for standard output")
      ->required()
      ->type_name("FILE");
  command->add_option("--size", options->size, "Pixels; the document's output.size if not given")->type_name("WxH");
  command->add_option("--samples", options->samples, "Paths a pixel: more are slower and less noisy")->type_name("N");
  command
      ->add_option("--view", options->view,
                   "Where the camera stands, degrees from north over east and over the horizon")
      ->type_name("AZIMUTH,ALTITUDE");
  command
      ->add_option("--turntable", options->turntable,
                   "Write so many numbered pictures, the camera going once around: oak_000.png, oak_001.png, ...")
      ->type_name("N");
  command->add_flag("--transparent", options->transparent, "No sky and no ground, with an alpha channel");
  command->footer("Example: meristem render models/oak.json -o oak.png --size 800x800 --samples 64");
  command->callback([options, &run] { run = [options] { render(*options); }; });
}

}  // namespace meristem::cli
