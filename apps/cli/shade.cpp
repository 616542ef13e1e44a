// SPDX-License-Identifier: Apache-2.0
// The command `shade`: measures how much of a facade, of panels or of the ground lies in the shade of a document's
// plants, and when. All options are checked before the plants are grown. The results are written as tables or pictures.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "apps/film/frames.h"
#include "commands.h"
#include "documents.h"
#include "meristem/base/atomic_file.h"
#include "meristem/base/parallel.h"
#include "meristem/document/grow.h"
#include "meristem/document/json.h"
#include "meristem/export/output_files.h"
#include "meristem/export/shade/shade_report.h"
#include "meristem/export/shade/shade_request.h"
#include "meristem/measure/foliage.h"
#include "meristem/output/write/names.h"
#include "meristem/output/write/picture_file.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

struct ShadeCommand {
  DocumentOptions document;
  std::string facade;
  std::string panels;
  std::string ground;
  ShadeRequest request;
  double time = 0;
  std::vector<std::string> outputs;
  std::string points;
  bool json = false;
};

bool ends_in(const std::string& path, std::string_view ending) { return lower_case(path).ends_with(ending); }

bool is_picture(const std::string& path) {
  return ends_in(path, ".png") || ends_in(path, ".jpg") || ends_in(path, ".jpeg");
}

void check_ending(const std::string& path) {
  if (path == "-" || ends_in(path, ".csv") || ends_in(path, ".json") || is_picture(path)) return;
  throw InputError(Diagnostic{.message = fmt::format("'{}' has no ending that names a format", path),
                              .expected = "a file that ends in .csv, .json, .png, .jpg or .jpeg"});
}

/// Returns the text as JSON if it is valid JSON, else as text, like --set.
Value value_of(const std::string& text) { return text.empty() ? Value() : parse_override("x=" + text).value; }

void write_text(const std::string& path, const std::string& text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

void write_output(const ShadeCommand& command, const std::string& path, const ShadePlan& plan,
                  const ShadeOfSurface& shade) {
  if (is_picture(path)) {
    write_picture(shade_picture(plan, shade, !command.ground.empty()), path);
  } else if (ends_in(path, ".json") || (path == "-" && command.json)) {
    write_text(path, write_json(shade_value(plan, shade)));
  } else {
    write_text(path, shade_csv(plan, shade));
  }
}

void shade(ShadeCommand command) {
  // All faults of the command line and of the document are reported before any work.
  if (command.outputs.empty()) command.outputs.emplace_back("-");
  for (const std::string& path : command.outputs) check_ending(path);
  const double time = film::checked_time(command.time);
  command.request.facade = value_of(command.facade);
  command.request.panels = value_of(command.panels);
  command.request.ground = value_of(command.ground);
  const Document document = open_document(command.document, time);
  const ShadePlan plan = plan_shade(command.request, document.scene);
  const std::vector<std::string> inputs = input_files(document);
  for (const std::string& path : command.outputs) check_output(path, inputs);
  if (!command.points.empty()) check_output(command.points, inputs);

  const ThreadLimit threads = limited_threads(command.document.threads, command.document.quiet);
  ShadeOfSurface result;
  std::vector<Diagnostic> warnings;
  {
    TerminalProgress terminal(command.document.quiet);
    Progress& progress = terminal.progress();
    GrownDocument grown = grow_document(document, progress, {.time = time, .up_to = GrownPart::meshes});
    // Light passes through the holes of textures.
    if (has_holes(grown.plant)) complete_growth(document, grown, progress, {.time = time});
    warnings = grown.warnings;
    result = measure_shade(plan.surface, plan.sun, grown.meshes, document.scene.obstacles, progress);
  }
  FileSet files;
  for (const std::string& path : command.outputs) write_output(command, path, plan, result);
  if (!command.points.empty()) write_text(command.points, shade_points_csv(plan, result));
  files.commit();
  if (command.document.quiet) return;
  print_diagnostics(warnings);
  print_status(fmt::format("{:.4g} m2 at {} points, {} moments in {} time", plan.surface.area,
                           plan.surface.positions.size(), plan.sun.size(), plan.is_clock_time ? "clock" : "solar"));
}

void add_surfaces(CLI::App& command, ShadeCommand& options) {
  CLI::Option* const facade =
      command
          .add_option(
              "--facade", options.facade,
              "The walls of an obstacle, by its name or number; or {\"obstacle\": \"house\", \"side\": \"south\"}")
          ->type_name("OBSTACLE|JSON");
  CLI::Option* const panels =
      command
          .add_option(
              "--panels", options.panels,
              "A flat field: {\"position\": [0, 3, 5], \"width\": 4, \"length\": 2, \"tilt\": 30, \"azimuth\": 180}")
          ->type_name("JSON");
  command.add_option("--ground", options.ground, "A rectangle of ground: two corners [[x, z], [x, z]]")
      ->type_name("JSON")
      ->excludes(facade)
      ->excludes(panels);
  panels->excludes(facade);
  command
      .add_option("--spacing", options.request.spacing,
                  "Distance between the points of the surface; by default, 0.25. Lower is finer and slower")
      ->type_name("METRES");
}

void add_times(CLI::App& command, ShadeCommand& options) {
  command
      .add_option("--days", options.request.days,
                  "Days of the year or dates, separated by commas: 172, 2026-06-21, or FROM:TO:STEP of either")
      ->required()
      ->type_name("DAYS");
  command
      .add_option("--hours", options.request.hours,
                  "Hours, separated by commas: 15.5, 15:30, or FROM:TO:STEP; by default, 0:23:1. True solar time, or "
                  "clock time if a longitude and an offset are known")
      ->type_name("HOURS");
  command.add_option("--latitude", options.request.latitude, "Latitude of the scene; by default, the document's")
      ->type_name("DEGREES");
  command
      .add_option("--longitude", options.request.longitude,
                  "Longitude of the scene, east positive, for clock time; by default, that of the document's sun")
      ->type_name("DEGREES");
  command
      .add_option("--utc-offset", options.request.utc_offset,
                  "Hours that the clock is ahead of universal time: 1 in central Europe, 2 in its summer")
      ->type_name("HOURS");
}

}  // namespace

void add_shade(CLI::App& app, Run& run) {
  CLI::App* command =
      app.add_subcommand("shade", "Measure how much of a facade, of panels or of the ground lies in shade, and when");
  auto options = std::make_shared<ShadeCommand>();
  options->document.add_to(*command);
  add_surfaces(*command, *options);
  add_times(*command, *options);
  add_time_option(*command, options->time);
  command
      ->add_option("-o,--output", options->outputs,
                   "File to write: a table (.csv, .json) or a picture (.png, .jpg); by default, standard output; may "
                   "be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  command
      ->add_option("--points", options->points,
                   "CSV table to write, with the share of moments in which each point lies in shade")
      ->type_name("FILE");
  command->add_flag("--json", options->json, "Write JSON to standard output instead of CSV");
  command->footer(
      "Example: meristem shade street.json --facade house --days 172 --hours 6:20:1\n"
      "         meristem shade avenue --ground '[[-10, -10], [10, 10]]' --days 80:264:23 -o shade.csv -o shade.png");
  command->callback([options, &run] { run = [options] { shade(*options); }; });
}

}  // namespace meristem::cli
