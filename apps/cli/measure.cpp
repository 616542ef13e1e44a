// SPDX-License-Identifier: Apache-2.0
// The command `measure`: measures documents, files of skeletons, and tables of measured trees. The kind of the file
// decides which options are allowed. A document is grown only to the stage that the measures need.
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "apps/film/frames.h"
#include "commands.h"
#include "documents.h"
#include "meristem/base/atomic_file.h"
#include "meristem/base/parallel.h"
#include "meristem/base/read_file.h"
#include "meristem/document/grow.h"
#include "meristem/document/json.h"
#include "meristem/export/measure_report.h"
#include "meristem/export/output_files.h"
#include "meristem/measure/foliage.h"
#include "meristem/measure/measures.h"
#include "meristem/output/skeleton/organ_csv.h"
#include "meristem/output/write/names.h"
#include "meristem/plant/file/node_table.h"
#include "meristem/plant/mtg/mtg_skeleton.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

namespace fs = std::filesystem;

constexpr double kTallestTree = 150;  // metres: a larger value means that the file uses other units

const std::map<std::string, double>& units() {
  static const std::map<std::string, double> units{{"m", 1}, {"dm", 0.1}, {"cm", 0.01}, {"mm", 0.001}};
  return units;
}

struct MeasureCommand {
  DocumentOptions document;
  MeasureOptions measures;
  std::string output = "-";
  std::string organs;  // a file for organs; empty: not written
  std::string sun;     // JSON of a sun; empty: the document's sun
  double time = 0;
  bool json = false;
  MeasureReport report;
  bool list = false;
  bool markdown = false;
  // Options that apply only to files of skeletons.
  std::string coordinates;
  std::string diameter;
  std::string unit;
  std::string diameter_unit;

  bool needs_light() const { return measures.organ_light || !organs.empty() || names_any(&MeasureRow::needs_light); }
  /// Returns true if the measures need geometry. Without --only, a table per tree has only measures of skeletons and
  /// leaves.
  bool needs_geometry() const {
    if (report.only.empty()) return !report.each || needs_light();
    return names_any(&MeasureRow::is_geometry);
  }
  bool reads_mtg() const { return has_ending(".mtg"); }
  bool reads_table() const { return has_ending(".csv") || has_ending(".txt") || has_ending(".tsv"); }
  bool reads_skeleton() const { return reads_mtg() || reads_table(); }

 private:
  /// Returns true if --only names a measure that has the flag.
  bool names_any(bool MeasureRow::*flag) const {
    return std::ranges::any_of(measure_rows(), [&](const MeasureRow& row) {
      return row.*flag && std::ranges::find(report.only, row.name) != report.only.end();
    });
  }
  bool has_ending(std::string_view ending) const { return lower_case(document.path).ends_with(ending); }
};

/// Throws InputError for options that do not apply to the kind of the given file.
void check_kind(const MeasureCommand& command) {
  const auto require = [&](bool holds, const char* option, const char* kind) {
    if (holds) return;
    throw InputError(Diagnostic{.message = fmt::format("{} has no effect on '{}'", option, command.document.path),
                                .expected = fmt::format("{} only with {}", option, kind)});
  };
  if (command.reads_skeleton()) {
    require(command.document.sets.empty(), "--set", "a document");
    require(!command.document.seed, "--seed", "a document");
    require(!command.measures.organ_light, "--light", "a document");
    require(command.organs.empty(), "--organs", "a document");
    require(command.sun.empty(), "--sun", "a document");
    require(command.time == 0, "--time", "a document");
    require(command.measures.layer_height == 0, "--layers", "a document");
  } else {
    require(command.unit.empty(), "--unit", "a file of skeletons");
    require(command.diameter_unit.empty(), "--diameter-unit", "a file of skeletons");
  }
  if (command.reads_mtg()) return;
  require(command.coordinates.empty(), "--coordinates", "an .mtg file");
  require(command.diameter.empty(), "--diameter", "an .mtg file");
}

void check_only(const MeasureCommand& command) {
  std::vector<std::string> names;
  for (const MeasureRow& row : measure_rows()) names.emplace_back(row.name);
  std::vector<Diagnostic> errors;
  for (const std::string& name : command.report.only) {
    if (std::ranges::find(names, name) != names.end()) continue;
    errors.push_back({.message = fmt::format("there is no measure '{}'", name),
                      .expected = "a name that --list prints",
                      .nearest = nearest_name(name, names),
                      .path = "--only"});
  }
  if (!errors.empty()) throw InputError(std::move(errors));
}

void check_organs(const MeasureCommand& command, std::span<const std::string> inputs) {
  check_output(command.organs, inputs);
  if (place_of(command.organs) == place_of(command.output)) {
    throw InputError(Diagnostic{.message = "the measures and the table of organs would be written to one file",
                                .expected = "different files for -o and --organs"});
  }
}

StandMeasures measure_document(const MeasureCommand& command) {
  const double time = film::checked_time(command.time);
  const Document document = open_document(command.document, time);
  // The light of the measurement may differ from the light of the growth.
  const Scene scene = command.sun.empty() ? document.scene : scene_under(document, command.document, command.sun);
  const std::vector<std::string> inputs = input_files(document);
  check_output(command.output, inputs);
  if (!command.organs.empty()) check_organs(command, inputs);
  const ThreadLimit threads = limited_threads(command.document.threads, command.document.quiet);
  StandMeasures stand;
  std::vector<Diagnostic> warnings;
  {
    TerminalProgress terminal(command.document.quiet);
    MeasureOptions options = command.measures;
    options.organ_light = command.needs_light();
    options.organ_list = !command.organs.empty();
    Progress& progress = terminal.progress();
    GrownDocument grown = grow_document(document, progress, {.time = time, .up_to = GrownPart::plant});
    // Holes of textures are no part of a leaf, and light passes through them.
    if (has_holes(grown.plant)) paint_plant(document, grown.plant, progress);
    warnings = grown.warnings;
    const SizeLimits& limits = document.graph.limits;
    if (options.organ_light) {
      const MeshScene meshes = mesh_for_rays(document, grown.plant, progress);
      stand = measure_plant(grown.plant, limits, meshes, scene, options, progress);
    } else {
      stand = measure_plant(grown.plant, limits, scene, options, progress);
    }
    if (command.needs_geometry()) stand.whole.set_geometry(count_geometry(document, grown.plant, progress));
    if (!command.organs.empty()) write_organ_csv(grown.plant, limits, stand.organs, command.organs, progress);
  }
  if (!command.document.quiet) print_diagnostics(warnings);
  return stand;
}

/// Splits a text at commas into three names.
std::array<std::string, 3> three_names(const std::string& text) {
  const std::size_t first = text.find(',');
  const std::size_t second = text.find(',', first + 1);
  const bool has_two = first != std::string::npos && second != std::string::npos;
  if (!has_two || text.find(',', second + 1) != std::string::npos) {
    throw InputError(Diagnostic{.message = fmt::format("--coordinates cannot be '{}'", text),
                                .expected = "the names of three features, such as XX,YY,ZZ"});
  }
  return {text.substr(0, first), text.substr(first + 1, second - first - 1), text.substr(second + 1)};
}

MtgSkeleton read_mtg_skeleton(const MeasureCommand& command, const SizeLimits& limits) {
  MtgGeometry geometry{.diameter = command.diameter};
  if (!command.coordinates.empty()) geometry.position = three_names(command.coordinates);
  if (!command.unit.empty()) geometry.length_unit = units().at(command.unit);
  geometry.diameter_unit = command.diameter_unit.empty() ? geometry.length_unit : units().at(command.diameter_unit);
  const std::string& path = command.document.path;
  require_within(command.document.root, path);
  return skeleton_of(read_mtg(read_file(path, limits.file_bytes), path, limits), path, geometry, limits);
}

/// Moves the first root to the origin, because map coordinates are too large for floats.
MtgSkeleton read_table_skeleton(const MeasureCommand& command, const SizeLimits& limits) {
  const double unit = command.unit.empty() ? 1 : units().at(command.unit);
  const double diameter_unit = command.diameter_unit.empty() ? unit : units().at(command.diameter_unit);
  const std::string& path = command.document.path;
  require_within(command.document.root, path);
  const NodeTable table = read_node_table(read_file(path, limits.file_bytes), path, limits);
  MtgSkeleton read;
  read.skeleton =
      skeleton_of(table, {.unit = unit, .radius_factor = diameter_unit / unit, .is_y_up = table.is_y_up}, path);
  return read;
}

StandMeasures measure_skeleton(const MeasureCommand& command) {
  const SizeLimits limits;
  const std::string& path = command.document.path;
  const MtgSkeleton read =
      command.reads_mtg() ? read_mtg_skeleton(command, limits) : read_table_skeleton(command, limits);
  check_output(command.output, std::span(&path, 1));

  const ThreadLimit threads = limited_threads(command.document.threads, command.document.quiet);
  StandMeasures stand;
  {
    TerminalProgress terminal(command.document.quiet);
    const Skeleton* const skeleton = &read.skeleton;
    stand = measure_skeletons(std::span(&skeleton, 1), nullptr, command.measures, terminal.progress());
  }
  if (command.document.quiet) return stand;
  std::vector<Diagnostic> warnings;
  const auto warn = [&](std::string message) {
    warnings.push_back({.severity = Severity::warning, .message = std::move(message), .file = path});
  };
  if (stand.whole.height > kTallestTree) {
    warn(fmt::format("the plant is {:.0f} m high; --unit gives the unit of its coordinates", stand.whole.height));
  }
  if (read.guessed > 0) {
    warn(fmt::format("entities without coordinates stand where their parents end: {}", read.guessed));
  }
  print_diagnostics(warnings);
  return stand;
}

void measure(const MeasureCommand& command) {
  check_kind(command);
  check_only(command);
  const StandMeasures measures = command.reads_skeleton() ? measure_skeleton(command) : measure_document(command);
  const std::string text =
      command.json ? write_json(measures_value(measures, command.report)) : measures_text(measures, command.report);
  AtomicFile file(command.output);
  file.write(text.data(), text.size());
  file.commit();
}

void list_measures() {
  for (const MeasureRow& row : measure_rows()) {
    fmt::print("{:<24} {:<3} {}\n", row.name, row.unit, row.doc);
  }
}

void add_skeleton_options(CLI::App& command, MeasureCommand& options) {
  const char* const group = "For files of skeletons: .mtg, and tables of cylinders, trees or nodes (.csv, .txt, .tsv)";
  command
      .add_option("--coordinates", options.coordinates,
                  "Features of an .mtg file with the coordinates to the east, to the north and up; by default, "
                  "XX,YY,ZZ")
      ->type_name("X,Y,Z")
      ->group(group);
  command
      .add_option("--diameter", options.diameter,
                  "Feature of an .mtg file with the diameters; by default, TopDia or TopDiameter")
      ->type_name("NAME")
      ->group(group);
  std::vector<std::string> names;
  for (const auto& [name, metres] : units()) names.push_back(name);
  command.add_option("--unit", options.unit, "Unit of coordinates; by default, m")
      ->type_name("UNIT")
      ->check(CLI::IsMember(names))
      ->group(group);
  command.add_option("--diameter-unit", options.diameter_unit, "Unit of diameters; by default, that of --unit")
      ->type_name("UNIT")
      ->check(CLI::IsMember(names))
      ->group(group);
}

}  // namespace

void add_measure(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("measure", "Grow a document, or read a file of skeletons, and measure it");
  auto options = std::make_shared<MeasureCommand>();
  options->document.add_to(*command);
  command->get_option("document")->required(false);
  command->add_option("-o,--output", options->output, "File to write; by default, standard output")->type_name("FILE");
  command->add_flag("--json", options->json, "Write JSON instead of a table");
  command->add_flag("--each", options->report.each,
                    "Also measure each tree by itself. Makes no meshes unless --light, --organs or --only need them");
  command
      ->add_option("--only", options->report.only,
                   "Names of measures to print, such as height,leaf_area. Makes meshes only if a named measure needs "
                   "them")
      ->type_name("NAME,NAME")
      ->delimiter(',');
  command
      ->add_option("--fork-diameter", options->measures.fork_diameter,
                   "Diameter of a fork's parent from which area ratios count the fork; by default, 0.02")
      ->type_name("METRES")
      ->check(CLI::Range(0.0, 1000.0));
  command->add_flag("--light", options->measures.organ_light,
                    "Measure the light on the leaves, which may take seconds");
  command
      ->add_option("--sun", options->sun,
                   "Measure under this sun, which may differ from the sun of growth: {\"day\": 172, \"hour\": 15}, or "
                   "another value of scene.sun")
      ->type_name("JSON");
  command
      ->add_option("--layers", options->measures.layer_height,
                   "Also print the leaf area by height, in layers of this height")
      ->type_name("METRES")
      ->check(CLI::Range(0.001, 1000.0));
  command->add_option("--time", options->time, "Measure the document at this time in seconds, the t of its expressions")
      ->type_name("T");
  command
      ->add_option("--organs", options->organs,
                   "CSV table to write, with the light on every organ; - for standard output")
      ->type_name("FILE");
  command->add_flag("--list", options->list, "List all measures");
  command->add_flag("--markdown", options->markdown, "Print all measures as the table of the manual")
      ->excludes("--list");
  add_skeleton_options(*command, *options);
  command->footer(
      "Example: meristem measure models/oak.json --seed 3 --json -o oak-measures.json\n"
      "         meristem measure avenue --sun '{\"day\": 172, \"hour\": 15}' --organs leaves.csv\n"
      "         meristem measure walnut.mtg --unit cm --diameter-unit mm\n"
      "         meristem measure beech.qsm.csv --each");
  command->callback([options, &run] {
    const bool is_listing = options->list || options->markdown;
    if (!is_listing && options->document.path.empty()) throw CLI::RequiredError("document");
    run = [options] {
      if (options->list) {
        list_measures();
      } else if (options->markdown) {
        fmt::print("{}", measures_reference());
      } else {
        measure(*options);
      }
    };
  });
}

}  // namespace meristem::cli
