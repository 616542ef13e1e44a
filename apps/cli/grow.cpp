// SPDX-License-Identifier: Apache-2.0
// The command `grow`: grows a document and writes files in the formats of their endings. All options are checked before
// any work. Coarser levels of detail get numbered files, and the options that would change no file are refused.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "apps/film/frames.h"
#include "commands.h"
#include "documents.h"
#include "meristem/base/atomic_file.h"
#include "meristem/base/parallel.h"
#include "meristem/document/grow_moving.h"
#include "meristem/export/detail_levels.h"
#include "meristem/export/formats.h"
#include "meristem/export/moving_file.h"
#include "meristem/export/output_files.h"
#include "meristem/measure/counts.h"
#include "meristem/output/picture/cards.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

struct GrowOptions {
  DocumentOptions document;
  std::vector<std::string> outputs;
  double time = 0;
  std::optional<int> step;        // step of growth that is shown
  std::optional<int> lod;         // number of coarser levels of detail
  std::optional<int> cards;       // number of upright cards of a last level
  bool instanced = false;         // true: leaves are written as rows of arrays
  bool nodes = false;             // never, but nodes where there are many
  bool obstacles = false;         // true: files with meshes contain the obstacles
  bool shared = false;            // true: faces of .ply share vertices, without normals
  std::vector<std::string> only;  // objects that files with meshes contain; empty: all
  bool animated = false;          // true: the whole animation is written
  std::optional<int> keys;        // number of times of the animation

  GltfInstances instances() const {
    if (instanced) return GltfInstances::rows;
    return nodes ? GltfInstances::nodes : GltfInstances::automatic;
  }
};

/// A file to write.
struct PlannedFile {
  const FileFormat* format;
  std::string path;
};

InputError wrong_lod(std::string message, std::string expected) {
  return InputError(Diagnostic{.message = std::move(message), .expected = std::move(expected)});
}

/// Throws InputError for an option that would change none of the files.
void check_options(const GrowOptions& options, const std::vector<const FileFormat*>& formats) {
  const auto has_meshes = [](const FileFormat* format) { return format->has_meshes(); };
  if (options.lod && (*options.lod < 0 || *options.lod > kCoarsestDetail)) {
    throw wrong_lod(fmt::format("--lod cannot be {}", *options.lod), fmt::format("0 to {} levels", kCoarsestDetail));
  }
  if (options.lod.value_or(0) > 0) {
    if (std::find(options.outputs.begin(), options.outputs.end(), "-") != options.outputs.end()) {
      throw wrong_lod("levels of detail cannot be written to standard output", "a file name such as oak.glb");
    }
    if (std::none_of(formats.begin(), formats.end(), has_meshes)) {
      throw wrong_lod("--lod changes none of the files", "a file that ends in .glb, .obj or .ply");
    }
  }
  const auto has_textures = [](const FileFormat* format) { return format->has_textures(); };
  if (options.cards && (*options.cards < 0 || *options.cards > kMaxCards)) {
    throw wrong_lod(fmt::format("--cards cannot be {}", *options.cards), fmt::format("0 to {} cards", kMaxCards));
  }
  if (options.cards.value_or(0) > 0) {
    if (std::find(options.outputs.begin(), options.outputs.end(), "-") != options.outputs.end()) {
      throw wrong_lod("cards cannot be written to standard output", "a file name such as oak.glb");
    }
    if (std::none_of(formats.begin(), formats.end(), has_textures)) {
      throw wrong_lod("--cards changes none of the files", "a file that ends in .glb or .obj");
    }
  }
  if (options.obstacles && std::none_of(formats.begin(), formats.end(), has_meshes)) {
    throw InputError(Diagnostic{.message = "--obstacles changes none of the files",
                                .expected = "a file that ends in .glb, .obj or .ply"});
  }
  if (!options.only.empty() && std::none_of(formats.begin(), formats.end(), has_meshes)) {
    throw InputError(Diagnostic{.message = "--only changes none of the files",
                                .expected = "a file that ends in .glb, .obj or .ply"});
  }
  const auto is_ply = [](const FileFormat* format) { return format->ending == ".ply"; };
  if (options.shared && std::none_of(formats.begin(), formats.end(), is_ply)) {
    throw InputError(
        Diagnostic{.message = "--shared-vertices changes none of the files", .expected = "a file that ends in .ply"});
  }
  const auto can_instance = [](const FileFormat* format) { return format->can_instance; };
  if (options.instances() == GltfInstances::automatic) return;
  if (std::any_of(formats.begin(), formats.end(), can_instance)) return;
  throw InputError(
      Diagnostic{.message = fmt::format("{} changes none of the files", options.instanced ? "--instanced" : "--nodes"),
                 .expected = "a file that ends in .glb"});
}

InputError cannot_animate(std::string what) {
  return InputError(Diagnostic{.message = fmt::format("{} cannot stand with --animated", what),
                               .expected = "meristem grow DOCUMENT --animated [--keys N] -o FILE.glb"});
}

/// Throws InputError for options that contradict --animated, or that need it.
void check_animated(const GrowOptions& options, bool has_time) {
  if (!options.animated) {
    if (!options.keys) return;
    throw InputError(Diagnostic{.message = "--keys changes none of the files", .expected = "--animated"});
  }
  if (has_time) throw cannot_animate("--time");
  if (options.step) throw cannot_animate("--step");
  if (options.lod) throw cannot_animate("--lod");
  if (options.cards) throw cannot_animate("--cards");
  if (options.instanced) throw cannot_animate("--instanced");
  if (options.nodes) throw cannot_animate("--nodes");
  if (options.obstacles) throw cannot_animate("--obstacles");
  if (options.shared) throw cannot_animate("--shared-vertices");
  if (!options.only.empty()) throw cannot_animate("--only");
  for (const std::string& output : options.outputs) check_moving_file(output);
  const int max = static_cast<int>(kMaxKeys);
  if (options.keys && (*options.keys < 2 || *options.keys > max)) {
    throw InputError(Diagnostic{.message = fmt::format("--keys cannot be {}", *options.keys),
                                .expected = fmt::format("2 to {} keys", max)});
  }
}

/// Writes the document's animation.
void grow_animated(const GrowOptions& options) {
  const Document document = open_document(options.document, 0);
  for (const std::string& output : options.outputs) check_grown_output(document, output);
  const ThreadLimit threads = limited_threads(options.document.threads, options.document.quiet);
  std::string summary;
  {
    TerminalProgress terminal(options.document.quiet);
    Progress& progress = terminal.progress();
    MovingOptions moving;
    if (options.keys) moving.keys = static_cast<std::size_t>(*options.keys);
    const MovingScene scene = grow_moving(document, progress, moving);
    EncodedPictures pictures;
    FileSet files;
    for (const std::string& output : options.outputs) write_moving_file(document, scene, output, progress, &pictures);
    files.commit();
    summary = fmt::format("{}: {} keys over {:.6g} s, {} triangles", fmt::join(options.outputs, ", "),
                          scene.times.size(), scene.times.back(), scene.scene.triangle_count());
  }
  if (!options.document.quiet) print_status(summary);
}

/// Returns the files of each level of detail. The first level has the requested files.
std::vector<std::vector<PlannedFile>> planned_files(const GrowOptions& options,
                                                    const std::vector<const FileFormat*>& formats, int lod) {
  std::vector<std::vector<PlannedFile>> levels(static_cast<std::size_t>(lod) + 1);
  for (std::size_t k = 0; k < formats.size(); ++k) {
    const std::string& output = options.outputs[k];
    levels[0].push_back({formats[k], output});
    if (!formats[k]->has_meshes() || output == "-") continue;
    for (int level = 1; level <= lod; ++level) {
      const std::string path = detail_path(*formats[k], output, level);
      if (std::find(options.outputs.begin(), options.outputs.end(), path) != options.outputs.end()) {
        throw wrong_lod(fmt::format("'{}' would be written twice: also as a level of detail", path), "another name");
      }
      levels[static_cast<std::size_t>(level)].push_back({formats[k], path});
    }
  }
  return levels;
}

/// Returns the files of a last level of crossed cards.
std::vector<PlannedFile> planned_cards(const GrowOptions& options, const std::vector<const FileFormat*>& formats) {
  std::vector<PlannedFile> files;
  for (std::size_t k = 0; k < formats.size(); ++k) {
    const std::string& output = options.outputs[k];
    if (!formats[k]->has_textures() || output == "-") continue;
    files.push_back({formats[k], cards_path(*formats[k], output)});
    if (std::find(options.outputs.begin(), options.outputs.end(), files.back().path) == options.outputs.end()) continue;
    throw wrong_lod(fmt::format("'{}' would be written twice: also with cards", files.back().path), "another name");
  }
  return files;
}

std::string listed(const std::vector<PlannedFile>& files) {
  std::vector<std::string> paths;
  for (const PlannedFile& file : files) paths.push_back(file.path);
  return fmt::format("{}", fmt::join(paths, ", "));
}

/// Writes the files of one level. Returns a description of their content.
std::string write_level(const Document& document, const GrownDocument& grown, const std::vector<PlannedFile>& files,
                        const FormatOptions& options, Progress& progress) {
  for (const PlannedFile& file : files) file.format->write(document, grown, file.path, options, progress);
  return listed(files);
}

/// Writes the coarser levels of a grown document, while they get smaller enough. Returns a description of each.
std::vector<std::string> write_coarser(const Document& document, GrownDocument& grown,
                                       const std::vector<std::vector<PlannedFile>>& levels,
                                       const FormatOptions& options, Progress& progress) {
  std::vector<std::string> summary;
  // All levels have files of the kinds of the first level.
  const int count = levels.size() > 1 && !levels[1].empty() ? static_cast<int>(levels.size()) - 1 : 0;
  MeshScene whole = std::exchange(grown.meshes, {});
  const auto write = [&](int level, MeshScene meshes) {
    grown.meshes = std::move(meshes);
    const std::string written =
        write_level(document, grown, levels[static_cast<std::size_t>(level)], options, progress);
    summary.push_back(fmt::format("{}: {} triangles", written, grown.meshes.triangle_count()));
    grown.meshes = {};
  };
  if (const auto worthless = make_levels(document, grown.plant, whole, count, write, progress)) {
    summary.push_back(fmt::format("{} and coarser ones are not written: {}",
                                  listed(levels[static_cast<std::size_t>(worthless->number)]), worthless->reason));
  }
  grown.meshes = std::move(whole);
  return summary;
}

std::string sizes_of(const GrownDocument& grown) {
  const PlantCounts counts = count(grown.plant, grown.meshes);
  std::string text = fmt::format("{} nodes, {} organs", counts.nodes, counts.organs);
  if (grown.traces.step) {
    text = fmt::format("step {} of {}, {}", grown.traces.shown_step(), grown.traces.last_step, text);
  }
  if (grown.up_to < GrownPart::meshes) return text;
  return text + fmt::format(", {} triangles, {:.2f} m high", counts.triangles, counts.height);
}

void grow(const GrowOptions& options, bool has_time) {
  // All faults of the command line and of the document are reported before any work.
  std::vector<const FileFormat*> formats;
  for (const std::string& output : options.outputs) formats.push_back(&format_of(output));
  const double time = film::checked_time(options.time);
  check_animated(options, has_time);
  if (options.animated) return grow_animated(options);
  const GrowthView view{checked_step(options.step), needed_request(formats)};
  check_options(options, formats);
  const Document document = open_document(options.document, time);
  const auto levels = planned_files(options, formats, options.lod.value_or(document.output.lod));
  const int card_count = options.cards.value_or(document.output.cards);
  const std::vector<PlannedFile> cards = card_count > 0 ? planned_cards(options, formats) : std::vector<PlannedFile>();
  for (const PlannedFile& file : cards) check_grown_output(document, file.path);
  for (const std::vector<PlannedFile>& files : levels) {
    for (const PlannedFile& file : files) check_grown_output(document, file.path);
  }

  const ThreadLimit threads = limited_threads(options.document.threads, options.document.quiet);
  std::vector<std::string> summary;
  std::vector<Diagnostic> warnings;
  {
    TerminalProgress terminal(options.document.quiet);
    Progress& progress = terminal.progress();
    GrownDocument grown =
        grow_document(document, progress, {.time = time, .up_to = needed_part(formats), .view = view});
    warnings = grown.warnings;
    EncodedPictures pictures;
    FileSet files;
    const FormatOptions format{.instances = options.instances(),
                               .pictures = &pictures,
                               .obstacles = options.obstacles,
                               .shared_vertices = options.shared,
                               .only = options.only};
    const std::string written = write_level(document, grown, levels[0], format, progress);
    summary.push_back(fmt::format("{}: {}", written, sizes_of(grown)));
    const std::vector<std::string> coarser = write_coarser(document, grown, levels, format, progress);
    summary.insert(summary.end(), coarser.begin(), coarser.end());
    if (!cards.empty()) {
      grown.meshes = make_cards(grown.meshes, {.cards = card_count}, progress);
      const std::string shown = write_level(document, grown, cards, format, progress);
      summary.push_back(fmt::format("{}: {} triangles", shown, grown.meshes.triangle_count()));
    }
    files.commit();
  }
  if (options.document.quiet) return;
  print_diagnostics(warnings);
  for (const std::string& line : summary) print_status(line);
}

}  // namespace

void add_grow(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("grow", "Grow a document and write it to files");
  auto options = std::make_shared<GrowOptions>();
  options->document.add_to(*command);
  add_output_option(*command, options->outputs);
  CLI::Option* const time = add_time_option(*command, options->time);
  command->add_flag("--animated", options->animated,
                    "Write the document's animation into .glb, for browsers and engines to play");
  command
      ->add_option(
          "--keys", options->keys,
          fmt::format("Number of times at which an animated file holds the plant, from {} to {}, between which "
                      "it moves evenly; by default {}",
                      2, kMaxKeys, kUsualKeys))
      ->type_name("N");
  add_step_option(*command, options->step);
  command
      ->add_option("--lod", options->lod,
                   "Number of coarser levels of detail to write as well: oak_lod1.glb, oak_lod2.glb, ...; by default, "
                   "the document's output.lod")
      ->type_name("N");
  command
      ->add_option("--cards", options->cards,
                   "Number of upright crossed cards, pictures of the plant, to write as a last level: oak_cards.glb; "
                   "by default, the document's output.cards")
      ->type_name("N");
  CLI::Option* const instanced =
      command->add_flag("--instanced", options->instanced,
                        "Write leaves into .glb as instances of one mesh, which is the default beyond 5 million "
                        "triangles: small files, which not every program reads");
  command
      ->add_flag(
          "--nodes", options->nodes,
          "Write leaves into .glb as nodes, also beyond 5 million triangles: large files, which every program reads")
      ->excludes(instanced);
  command->add_flag("--obstacles", options->obstacles,
                    "Also write the scene's visible obstacles into .glb, .obj and .ply");
  command
      ->add_option("--only", options->only,
                   "Write only these objects into .glb, .obj and .ply: ids of components, and the id with _crown for a "
                   "crown body, such as tree or tree_crown")
      ->type_name("OBJECT");
  command->add_flag("--shared-vertices", options->shared,
                    "Leave normals and texture coordinates out of .ply, so that the faces of a mesh share vertices, as "
                    "programs for 3D printing want them");
  command->footer(endings_of(formats()) +
                  "Example: meristem grow models/oak.json -o oak.glb --seed 3 --set leaf.length=0.12");
  command->callback(
      [options, time, &run] { run = [options, has_time = time->count() > 0] { grow(*options, has_time); }; });
}

}  // namespace meristem::cli
