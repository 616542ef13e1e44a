// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "commands.h"
#include "documents.h"
#include "frames.h"
#include "meristem/base/parallel.h"
#include "meristem/components/camera.h"
#include "meristem/document/grow.h"
#include "meristem/output/output_files.h"
#include "meristem/output/picture/camera.h"
#include "meristem/output/picture/cards.h"
#include "meristem/output/picture/picture.h"
#include "meristem/output/picture/picture_fingerprint.h"
#include "meristem/output/write/picture_file.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

struct RenderOptions {
  DocumentOptions document;
  std::string output;
  std::string size;
  std::string view;
  std::string time = "0";
  std::optional<int> samples;
  std::optional<int> turntable;  // pictures all around
  bool transparent = false;
  bool hull = false;
  bool fingerprint = false;  // tells what would be drawn instead of drawing it
  std::optional<int> quality;
  std::optional<double> max_kilobytes;
  Detail detail;
  std::optional<int> cards;  // number of copies that the plant is shown as
};

/// A picture to make.
struct Picture {
  std::string path;
  double time;  // seconds
  double turn;  // of the camera around the plant, radians
};

/// One picture, or one for each time or each side.
std::vector<Picture> planned_pictures(const RenderOptions& options) {
  const std::vector<double> times = frame_times(options.time);
  if (times.size() == 1 && !options.turntable) return {{options.output, times[0], 0}};
  if (options.turntable && (*options.turntable < 1 || *options.turntable > kMostFrames)) {
    throw InputError(Diagnostic{.message = fmt::format("--turntable cannot be {}", *options.turntable),
                                .expected = fmt::format("1 to {} frames", kMostFrames)});
  }
  if (options.turntable && times.size() > 1) {
    throw InputError(
        Diagnostic{.message = "--turntable needs a plant that stands still", .expected = "a single --time beside it"});
  }
  const int count = options.turntable.value_or(static_cast<int>(times.size()));
  const std::vector<std::string> paths = frame_paths(options.output, count);
  std::vector<Picture> pictures;
  for (int k = 0; k < count; ++k) {
    pictures.push_back(
        {paths[k], options.turntable ? times[0] : times[k], options.turntable ? 2 * kPi * k / count : 0});
  }
  return pictures;
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

PictureFileOptions chosen_file(const RenderOptions& options) {
  PictureFileOptions file{.quality = options.quality};
  if (!options.max_kilobytes) return file;
  if (!(*options.max_kilobytes > 0 && *options.max_kilobytes < 1e9)) {
    throw InputError(Diagnostic{.message = fmt::format("--max-size cannot be {}", *options.max_kilobytes),
                                .expected = "kilobytes above 0"});
  }
  file.max_bytes = static_cast<std::uint64_t>(*options.max_kilobytes * 1000);
  return file;
}

StillOptions chosen_still(const RenderOptions& options, const OutputParameters& output) {
  StillOptions still{.width = output.size[0], .height = output.size[1]};
  still.samples = options.samples.value_or(output.samples);
  still.transparent = options.transparent;
  if (!options.size.empty()) {
    std::tie(still.width, still.height) =
        number_pair<int>(options.size, 'x', "--size", "WIDTHxHEIGHT in pixels, such as 1200x1200");
  }
  check_still_options(still);
  return still;
}

View chosen_view(const RenderOptions& options, const Document& document) {
  View view = camera_view(document.graph);
  if (options.view.empty()) return view;
  const auto [azimuth, altitude] =
      number_pair<double>(options.view, ',', "--view", "AZIMUTH,ALTITUDE in degrees, such as 150,6");
  if (const auto seen = seen_from(view, azimuth, altitude)) return *seen;
  throw InputError(
      Diagnostic{.message = fmt::format("--view cannot be '{}'", options.view), .expected = std::string(kKnownSides)});
}

/// What the document and the options say of the pictures.
PictureOptions chosen_picture(const RenderOptions& options, const Document& document) {
  return {.still = chosen_still(options, document.output),
          .view = chosen_view(options, document),
          .crown_hulls = options.hull};
}

/// Grows the document for each of the times and takes the pictures. The camera does not follow the plant's
/// growth: it stands where it shows the last picture's plant as a whole. Returns what is odd about that plant.
std::vector<Diagnostic> take_pictures(const Document& document, const std::vector<Picture>& pictures,
                                      PictureOptions options, const RenderOptions& chosen, Progress& progress) {
  const PictureFileOptions file = chosen_file(chosen);
  double grown_time = pictures.back().time;
  GrowthCache cache;  // what does not change with time is made once
  const auto grown_at = [&](double time) {
    GrownDocument plants = grow_document(document, progress, {.time = time, .detail = chosen.detail, .cache = &cache});
    if (chosen.cards) plants.meshes = make_cards(plants.meshes, {.cards = *chosen.cards}, progress);
    return plants;
  };
  GrownDocument grown = grown_at(grown_time);
  std::vector<Diagnostic> warnings = grown.warnings;
  const Vec3 middle = grown.meshes.bounds().centre();
  if (pictures.front().time != grown_time) {
    const double aspect = static_cast<double>(options.still.width) / options.still.height;
    options.view = placed_view(grown.meshes, options.view, aspect);
  }
  const View view = options.view;
  for (const Picture& picture : pictures) {
    if (picture.time != grown_time) {
      grown_time = picture.time;
      grown = grown_at(grown_time);
    }
    options.view = turned(view, middle, picture.turn);
    if (chosen.fingerprint) {
      fmt::print("{}\n", picture_fingerprint(grown, document.scene, options));
    } else {
      write_picture(take_picture(grown, document.scene, options, progress), picture.path, file);
    }
  }
  return warnings;
}

void render(const RenderOptions& options) {
  // Everything that can be wrong with the command line and the document comes before any work.
  if (options.output.empty()) {
    throw InputError(Diagnostic{.message = "no file to write is given", .expected = "-o FILE, or --fingerprint"});
  }
  if (!options.fingerprint) check_picture_file(options.output, options.transparent, chosen_file(options));
  if (options.detail.level < 0 || options.detail.level > kCoarsestDetail) {
    throw InputError(Diagnostic{.message = fmt::format("--lod cannot be {}", options.detail.level),
                                .expected = fmt::format("a level from 0 to {}", kCoarsestDetail)});
  }
  if (options.cards && (*options.cards < 1 || *options.cards > kMostCards)) {
    throw InputError(Diagnostic{.message = fmt::format("--cards cannot be {}", *options.cards),
                                .expected = fmt::format("1 to {} cards", kMostCards)});
  }
  const std::vector<Picture> pictures = planned_pictures(options);
  const Document document = open_document(options.document);
  const PictureOptions picture_options = chosen_picture(options, document);
  const std::vector<std::string> inputs = input_files(document);
  for (const Picture& picture : pictures) {
    if (!options.fingerprint) check_output(picture.path, inputs);
  }

  const ThreadLimit threads = limited_threads(options.document.threads, options.document.quiet);
  std::vector<Diagnostic> warnings;
  {
    TerminalProgress terminal(options.document.quiet);
    warnings = take_pictures(document, pictures, picture_options, options, terminal.progress());
  }
  if (!options.document.quiet) print_diagnostics(warnings);
  if (!options.document.quiet && !options.fingerprint) {
    const std::string written =
        pictures.size() == 1 ? pictures[0].path : fmt::format("{} to {}", pictures.front().path, pictures.back().path);
    const StillOptions& still = picture_options.still;
    print_status(fmt::format("{}: {} x {} pixels, {} samples", written, still.width, still.height, still.samples));
  }
}

}  // namespace

void add_render(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("render", "Grow a document and make a picture of it");
  auto options = std::make_shared<RenderOptions>();
  options->document.add_to(*command);
  CLI::Option* const output =
      command->add_option("-o,--output", options->output, "PNG or JPEG file to write; - for a PNG on standard output")
          ->type_name("FILE");
  CLI::Option* const fingerprint =
      command->add_flag("--fingerprint", options->fingerprint,
                        "Draw nothing; print 16 digits that change whenever the picture would change");
  output->excludes(fingerprint);
  command
      ->add_option("--quality", options->quality,
                   "Quality of a JPEG from 1 to 100; by default, 90. Higher: closer to the picture, larger file")
      ->type_name("N");
  command
      ->add_option("--max-size", options->max_kilobytes,
                   "Lower the quality of a JPEG until the file has at most this many kilobytes")
      ->type_name("KB");
  command->add_option("--size", options->size, "Width and height in pixels; by default, the document's output.size")
      ->type_name("WxH");
  command
      ->add_option("--samples", options->samples,
                   "Largest number of light paths per pixel; more take longer and give less noise")
      ->type_name("N");
  command
      ->add_option(
          "--view", options->view,
          "Direction from the plant to the camera in degrees: azimuth from north over east, altitude above the horizon")
      ->type_name("AZIMUTH,ALTITUDE");
  command
      ->add_option(
          "--turntable", options->turntable,
          "Number of pictures to write while the camera goes once around the plant: oak_000.png, oak_001.png, ...")
      ->type_name("N");
  command
      ->add_option("--time", options->time,
                   "Draw the document at this time in seconds, the t of its expressions; FROM:TO:STEP writes one "
                   "numbered picture per time")
      ->type_name("T|FROM:TO:STEP");
  command
      ->add_option("--lod", options->detail.level,
                   "Draw this level of detail (see grow --lod); by default, 0, the whole plant")
      ->type_name("LEVEL");
  command
      ->add_option("--cards", options->cards,
                   "Draw the plant as this number of crossed cards, which grow --cards writes")
      ->type_name("N");
  command->add_flag("--transparent", options->transparent, "Leave out sky and ground, and add an alpha channel");
  command->add_flag("--hull", options->hull,
                    "Draw the convex hull of each tree's crown, whose lit_share is measured, as wires");
  command->footer("Example: meristem render models/oak.json -o oak.png --size 800x800 --samples 64");
  command->callback([options, &run] {
    if (options->fingerprint) options->output = "picture.png";  // names numbered frames; nothing is written to it
    run = [options] { render(*options); };
  });
}

}  // namespace meristem::cli
