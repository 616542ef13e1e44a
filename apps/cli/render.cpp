// SPDX-License-Identifier: Apache-2.0
// The command `render`: draws pictures of a document, turntables and films, with the true depth, normals and masks. All
// pictures are planned and checked before any work. Pictures that differ only in the camera share one growth.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "apps/film/film.h"
#include "apps/film/frames.h"
#include "commands.h"
#include "documents.h"
#include "meristem/base/fingerprint.h"
#include "meristem/base/parallel.h"
#include "meristem/base/version.h"
#include "meristem/components/camera.h"
#include "meristem/document/grow.h"
#include "meristem/export/output_files.h"
#include "meristem/export/overlay/overlay.h"
#include "meristem/export/picture/picture.h"
#include "meristem/export/picture/picture_fingerprint.h"
#include "meristem/export/picture/truth.h"
#include "meristem/export/picture/truth_files.h"
#include "meristem/output/mesh/chosen_objects.h"
#include "meristem/output/picture/camera.h"
#include "meristem/output/picture/cards.h"
#include "meristem/output/picture/free_side.h"
#include "meristem/output/write/picture_file.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

struct RenderOptions {
  DocumentOptions document;
  std::string output;
  std::string size;
  std::string view;
  std::optional<std::string> time;
  std::optional<int> samples;
  std::optional<int> turntable;  // number of pictures around the plant
  std::optional<int> step;       // step of growth that is shown
  std::string show;              // names of overlays
  bool no_plant = false;         // true: only overlays and obstacles are drawn
  bool transparent = false;
  bool hull = false;
  std::vector<std::string> only;  // objects that are drawn; empty: all
  bool fingerprint = false;       // true: prints a fingerprint of the picture instead of drawing it
  std::optional<int> quality;
  std::optional<double> max_kilobytes;
  MeshDetail detail;
  std::optional<int> cards;  // number of copies that the plant is shown as
  // File of each kind of truth; may be empty
  std::vector<std::string> truths = std::vector<std::string>(truth_formats().size());

  bool wants_truth() const {
    return std::any_of(truths.begin(), truths.end(), [](const std::string& path) { return !path.empty(); });
  }
};

/// A picture to make.
struct Picture {
  std::string path;  // empty: only its truth is written
  double time;       // seconds
  double turn;       // of the camera around the plant, radians
  std::vector<TruthFile> truths{};
};

void check_turntable(const RenderOptions& options, const std::vector<double>& times) {
  if (options.turntable && (*options.turntable < 1 || *options.turntable > film::kMaxFrames)) {
    throw InputError(Diagnostic{.message = fmt::format("--turntable cannot be {}", *options.turntable),
                                .expected = fmt::format("1 to {} frames", film::kMaxFrames)});
  }
  if (options.turntable && times.size() > 1) {
    throw InputError(
        Diagnostic{.message = "--turntable needs a plant that stands still", .expected = "a single --time beside it"});
  }
}

/// Returns the pictures of a film. They have only numbers so far, and no paths.
std::vector<Picture> pictures_of_film(const RenderOptions& options, const std::vector<double>& times) {
  check_turntable(options, times);
  const int count = options.turntable.value_or(static_cast<int>(times.size()));
  std::vector<Picture> pictures;
  for (int k = 0; k < count; ++k) {
    pictures.push_back({"", options.turntable ? times[0] : times[static_cast<std::size_t>(k)],
                        options.turntable ? 2 * kPi * k / count : 0});
  }
  return pictures;
}

/// Returns the times of a film: the requested times, or the whole animation of the document.
std::vector<double> film_times(const RenderOptions& options, const Document& document) {
  if (options.time) return film::frame_times(*options.time);
  if (!document.graph.animation) {
    throw InputError(Diagnostic{.message = "the document has no animation that tells how long a film of it is",
                                .expected = "--time FROM:TO:STEP"});
  }
  const Animation& animation = *document.graph.animation;
  return film::frame_times(animation.length, animation.fps).all();
}

/// Returns one picture, or one for each time or each side. Pictures of a film get numbered paths in its folder.
std::vector<Picture> planned_pictures(const RenderOptions& options, const Document& document) {
  const std::vector<double> times = film::is_film(options.output) && !options.turntable
                                        ? film_times(options, document)
                                        : film::frame_times(options.time.value_or("0"));
  if (film::is_film(options.output)) return pictures_of_film(options, times);
  if (times.size() == 1 && !options.turntable) return {{options.output, times[0], 0}};
  check_turntable(options, times);
  const int count = options.turntable.value_or(static_cast<int>(times.size()));
  const std::vector<std::string> paths = film::frame_paths(options.output, count);
  std::vector<Picture> pictures;
  for (int k = 0; k < count; ++k) {
    pictures.push_back(
        {paths[k], options.turntable ? times[0] : times[k], options.turntable ? 2 * kPi * k / count : 0});
  }
  return pictures;
}

/// Parses two numbers around `separator`. Throws InputError with the option's name.
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

CameraView chosen_view(const RenderOptions& options, const Document& document) {
  CameraView view = camera_view(document.graph);
  if (options.view.empty()) return view;
  const auto [azimuth, altitude] =
      number_pair<double>(options.view, ',', "--view", "AZIMUTH,ALTITUDE in degrees, such as 150,6");
  if (const auto seen = seen_from(view, azimuth, altitude)) return *seen;
  throw InputError(
      Diagnostic{.message = fmt::format("--view cannot be '{}'", options.view), .expected = std::string(kKnownSides)});
}

std::vector<OverlayPart> chosen_overlays(const RenderOptions& options) {
  if (options.no_plant && options.show.empty()) {
    throw InputError(Diagnostic{.message = "--no-plant leaves nothing to draw", .expected = "--show beside it"});
  }
  return options.show.empty() ? std::vector<OverlayPart>() : overlay_parts_named(options.show, "--show");
}

/// Returns the options of the pictures, from the document and the command line.
PictureOptions chosen_picture(const RenderOptions& options, const Document& document) {
  return {.still = chosen_still(options, document.output),
          .view = chosen_view(options, document),
          .crown_hulls = options.hull,
          .overlays = chosen_overlays(options),
          .plants = !options.no_plant};
}

/// Grows the document for each of the times and draws the pictures. The camera does not follow the plant's growth: its
/// position shows the whole plant of the last picture. Returns the warnings about that plant.
class PictureTaker {
 public:
  PictureTaker(const Document& document, PictureOptions options, const RenderOptions& chosen,
               TerminalProgress& terminal)
      : document_(document), options_(std::move(options)), chosen_(chosen), terminal_(terminal) {}

  /// Draws the pictures. If `keeps_earlier`, existing pictures of a film are kept.
  std::vector<Diagnostic> take(const std::vector<Picture>& pictures, bool keeps_earlier) {
    const PictureFileOptions file = keeps_earlier ? PictureFileOptions() : chosen_file(chosen_);
    is_still_ = std::ranges::all_of(pictures, [&](const Picture& one) { return one.time == pictures[0].time; });
    grow_at(pictures.back().time);
    std::vector<Diagnostic> warnings = grown_.warnings;
    const Vec3 middle = grown_.meshes.bounds().centre();
    const bool moves = pictures.front().time != pictures.back().time;
    const MeshScene last = moves && document_.at_time ? grown_.meshes : MeshScene();
    options_.view = from_free_side(grown_.meshes, options_.view);
    if (moves) options_.view = placed_view(grown_.meshes, options_.view, aspect());
    const CameraView view = options_.view;
    std::size_t found = 0;
    for (std::size_t k = 0; k < pictures.size(); ++k) {
      const Picture& picture = pictures[k];
      if (keeps_earlier && std::filesystem::exists(picture.path)) {
        ++found;
        continue;
      }
      if (pictures.size() > 1) terminal_.tell_parts("frame", k, found, pictures.size());
      if (picture.time != grown_time_) grow_at(picture.time);
      // A camera with keys moves.
      options_.view = turned(moves && document_.at_time
                                 ? placed_view(last, from_free_side(last, chosen_view(chosen_, now())), aspect())
                                 : view,
                             middle, picture.turn);
      if (chosen_.fingerprint) {
        fmt::print("{}\n", picture_fingerprint(grown_, now().graph.limits, now().scene, options_));
      } else if (!picture.path.empty()) {
        write_picture(take(k + 1 == pictures.size()), picture.path, file);
      }
      if (!picture.truths.empty()) write_truth(picture);
    }
    return warnings;
  }

 private:
  double aspect() const { return static_cast<double>(options_.still.width) / options_.still.height; }
  const Document& now() const { return other_ ? *other_ : document_; }

  Image take(bool is_last) {
    const SizeLimits& limits = now().graph.limits;
    Progress& progress = terminal_.progress();
    if (is_last && !keeps_plant()) return take_last_picture(grown_, limits, now().scene, options_, progress);
    return take_picture(grown_, limits, now().scene, options_, progress);
  }

  /// Returns true if the pictures need more than meshes, or if the document grows again.
  bool keeps_plant() const { return !is_still_ || !shows_meshes_alone(options_) || chosen_.wants_truth(); }

  /// Returns the view from a side without obstacles. All pictures use this side, even if the camera turns.
  CameraView from_free_side(const MeshScene& plants, const CameraView& view) {
    if (options_.still.transparent) return view;
    return view_past_obstacles(plants, now().scene.obstacles, view, aspect(), terminal_.progress());
  }

  /// Writes the truth of a picture as files: depth, normals and masks.
  void write_truth(const Picture& picture) {
    const StillOptions& still = options_.still;
    const TruthOptions options{.width = still.width, .height = still.height, .transparent = still.transparent};
    write_truths(see_truth(grown_, now().graph.limits, now().scene, options_.view, options, terminal_.progress()),
                 picture.truths,
                 {.picture = std::filesystem::path(picture.path).filename().string(),
                  .name = document_.name,
                  .licence = document_.licence});
  }

  void grow_at(double time) {
    grown_time_ = time;
    other_.reset();
    const Document& document = document_at(document_, time, other_, &terminal_.progress());
    const GrowthView view{checked_step(chosen_.step), request_for_overlays(options_.overlays)};
    grown_ = grow_document(document, terminal_.progress(),
                           {.time = time,
                            .detail = chosen_.detail,
                            .cache = is_still_ ? nullptr : &cache_,
                            .view = view,
                            .keeps_plant = keeps_plant()});
    if (!chosen_.only.empty()) grown_.meshes = chosen_objects(grown_.meshes, chosen_.only, "--only");
    if (chosen_.cards) grown_.meshes = make_cards(grown_.meshes, {.cards = *chosen_.cards}, terminal_.progress());
  }

  const Document& document_;
  PictureOptions options_;
  const RenderOptions& chosen_;
  TerminalProgress& terminal_;
  GrowthCache cache_;     // keeps results that do not change with time
  bool is_still_ = true;  // all pictures show one time
  double grown_time_ = 0;
  std::optional<Document> other_;
  GrownDocument grown_;
};

/// Returns a hash of everything that the pictures of a film show.
std::uint64_t hash_of_film(const Document& document, const std::vector<Picture>& pictures,
                           const PictureOptions& picture, const RenderOptions& options) {
  Fingerprint all;
  all.add_text(version()).add_text(document.source.text).add(document.graph.seed).add_text(options.view);
  for (const std::string& set : document.source.sets) all.add_text(set);
  for (const std::string& file : document.source.named_files) {
    std::error_code error;
    all.add_text(file).add(std::filesystem::file_size(file, error));
    all.add(std::filesystem::last_write_time(file, error).time_since_epoch().count());
  }
  all.add(picture.still.width).add(picture.still.height).add(picture.still.samples).add(picture.still.transparent);
  all.add_text(options.show).add(options.step.value_or(-1)).add(options.no_plant);
  all.add(options.hull).add(options.detail.level).add(options.cards.value_or(0));
  for (const std::string& object : options.only) all.add_text(object);
  for (const Picture& one : pictures) all.add(one.time).add(one.turn);
  return all.hash();
}

/// Returns the pictures per second with which a film runs at the speed of the document.
double film_rate(const std::vector<Picture>& pictures, const Document& document) {
  const double step = pictures.size() > 1 ? pictures[1].time - pictures[0].time : 0;
  if (step > 0) return 1 / step;
  return document.graph.animation ? document.graph.animation->fps : Animation().fps;
}

/// Returns the option that makes the pictures show something other than the plain plants, or an empty text.
std::string other_picture(const RenderOptions& options) {
  if (film::is_film(options.output)) return "film";
  if (options.cards) return "--cards";
  if (options.detail.level > 0) return "--lod";
  if (!options.show.empty()) return "--show";
  if (options.hull) return "--hull";
  if (!options.only.empty()) return "--only";
  return options.no_plant ? "--no-plant" : "";
}

/// Throws InputError if two files of a run have one path.
void check_different(const std::vector<Picture>& pictures) {
  std::set<std::filesystem::path> places;
  const auto add = [&places](const std::string& path) {
    if (path.empty() || path == "-") return;
    if (places.insert(place_of(path)).second) return;
    throw InputError(Diagnostic{.message = fmt::format("'{}' would be written twice", path),
                                .expected = "different files for the picture and what is written beside it"});
  };
  for (const Picture& picture : pictures) {
    add(picture.path);
    for (const TruthFile& truth : picture.truths) add(truth.path);
  }
}

/// Sets the files for the truth of each picture. They are numbered like the pictures.
void plan_truths(const RenderOptions& options, std::vector<Picture>& pictures) {
  if (!options.wants_truth()) return;
  if (options.output.empty()) {
    for (Picture& picture : pictures) picture.path.clear();
  }
  if (const std::string other = other_picture(options); !other.empty()) {
    throw InputError(
        Diagnostic{.message = "depth, normals, masks and annotations are written beside pictures of the whole plant",
                   .expected = "no " + other});
  }
  for (std::size_t kind = 0; kind < options.truths.size(); ++kind) {
    const std::string& path = options.truths[kind];
    if (path.empty()) continue;
    const TruthFormat& format = truth_formats()[kind];
    check_truth_file(format, path);
    const std::vector<std::string> paths = pictures.size() == 1
                                               ? std::vector<std::string>{path}
                                               : film::frame_paths(path, static_cast<int>(pictures.size()));
    for (std::size_t k = 0; k < pictures.size(); ++k) pictures[k].truths.push_back({&format, paths[k]});
  }
  check_different(pictures);
}

void render(const RenderOptions& options) {
  // All faults of the command line and of the document are reported before any work.
  if (options.output.empty() && !options.wants_truth()) {
    throw InputError(Diagnostic{.message = "no file to write is given", .expected = "-o FILE, or --fingerprint"});
  }
  const bool films = film::is_film(options.output);
  if (!options.fingerprint && !options.output.empty()) {
    check_picture_file(films ? "film.png" : options.output, options.transparent && !films, chosen_file(options));
  }
  if (films && options.transparent) {
    throw InputError(
        Diagnostic{.message = "a film has no alpha channel", .expected = "no --transparent, or -o film.png"});
  }
  if (options.detail.level < 0 || options.detail.level > kCoarsestDetail) {
    throw InputError(Diagnostic{.message = fmt::format("--lod cannot be {}", options.detail.level),
                                .expected = fmt::format("a level from 0 to {}", kCoarsestDetail)});
  }
  if (options.cards && (*options.cards < 1 || *options.cards > kMaxCards)) {
    throw InputError(Diagnostic{.message = fmt::format("--cards cannot be {}", *options.cards),
                                .expected = fmt::format("1 to {} cards", kMaxCards)});
  }
  checked_step(options.step);
  const Document document = open_document(options.document);
  std::vector<Picture> pictures = planned_pictures(options, document);
  plan_truths(options, pictures);
  const PictureOptions picture_options = chosen_picture(options, document);
  const std::vector<std::string> inputs = input_files(document);
  std::string folder;
  if (films) {
    film::check_film(options.output, picture_options.still.width, picture_options.still.height);
    check_output(options.output, inputs);
    folder = film::frames_folder(options.output, hash_of_film(document, pictures, picture_options, options));
    for (std::size_t k = 0; k < pictures.size(); ++k) pictures[k].path = film::frame_path(folder, k);
  }
  for (const Picture& picture : pictures) {
    if (!options.fingerprint && !films && !picture.path.empty()) check_output(picture.path, inputs);
    for (const TruthFile& truth : picture.truths) check_output(truth.path, inputs);
  }

  const ThreadLimit threads = limited_threads(options.document.threads, options.document.quiet);
  std::vector<Diagnostic> warnings;
  {
    TerminalProgress terminal(options.document.quiet);
    warnings = PictureTaker(document, picture_options, options, terminal).take(pictures, films);
    if (films) {
      film::make_film(folder, pictures.size(), film_rate(pictures, document), options.output, terminal.progress());
    }
  }
  if (!options.document.quiet) print_diagnostics(warnings);
  if (!options.document.quiet && !options.fingerprint) {
    const std::string written = films ? fmt::format("{}: {} frames", options.output, pictures.size())
                                : pictures.size() == 1
                                    ? pictures[0].path
                                    : fmt::format("{} to {}", pictures.front().path, pictures.back().path);
    const StillOptions& still = picture_options.still;
    if (!options.output.empty()) {
      print_status(fmt::format("{}: {} x {} pixels, {} samples", written, still.width, still.height, still.samples));
    }
    std::string truths;
    for (const TruthFile& truth : pictures.front().truths) truths += (truths.empty() ? "" : ", ") + truth.path;
    if (!truths.empty()) print_status(fmt::format("{}: {} x {} pixels", truths, still.width, still.height));
  }
}

/// Returns a sentence as part of another one: without its capital letter and its full stop.
std::string lower_first(std::string_view sentence) {
  std::string text(sentence.substr(0, sentence.size() - 1));
  text[0] = static_cast<char>(text[0] - 'A' + 'a');
  return text;
}

}  // namespace

void add_render(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("render", "Grow a document and make a picture of it");
  auto options = std::make_shared<RenderOptions>();
  options->document.add_to(*command);
  CLI::Option* const output =
      command
          ->add_option("-o,--output", options->output,
                       "PNG or JPEG file to write, - for a PNG on standard output; a film that ends in .mp4 or "
                       ".webm needs ffmpeg, and goes on where it was stopped")
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
                   "Draw the document at this time in seconds, by default 0; FROM:TO:STEP writes one numbered picture "
                   "per time, or a film. By default, a film shows the whole animation")
      ->type_name("T|FROM:TO:STEP");
  add_step_option(*command, options->step);
  std::string parts;
  for (const OverlayPartInfo& part : overlay_parts()) {
    parts += fmt::format("  {:<10} {}\n", part.name, part.doc);
  }
  command
      ->add_option("--show", options->show,
                   "Draw these over the plant, with a legend: a list of names separated by commas (see below)")
      ->type_name("NAMES");
  command
      ->add_option("--only", options->only,
                   "Draw only these objects: ids of components, and the id with _crown for a crown body, such as tree "
                   "or tree_crown")
      ->type_name("OBJECT");
  command->add_flag("--no-plant", options->no_plant,
                    "Leave out the plants themselves, so that what --show names is seen alone");
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
  for (std::size_t kind = 0; kind < truth_formats().size(); ++kind) {
    const TruthFormat& format = truth_formats()[kind];
    CLI::Option* const truth =
        command
            ->add_option(fmt::format("--{}", format.name), options->truths[kind],
                         fmt::format("File to write, in {}: {}", format.ending_list(), lower_first(format.doc)))
            ->type_name("FILE");
    truth->excludes(fingerprint);
  }
  command->footer("--show takes:\n" + parts +
                  "Example: meristem render models/oak.json -o oak.png --size 800x800 --samples 64");
  command->callback([options, &run] {
    if (options->fingerprint) options->output = "picture.png";  // gives numbered frames their names; nothing is written
    run = [options] { render(*options); };
  });
}

}  // namespace meristem::cli
