// SPDX-License-Identifier: Apache-2.0
// The command `scan`: grows a document and simulates a laser scan of it. The options are translated into the JSON of a
// scan plan, so that its tables check them. The points carry the truth of the plant.
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "apps/film/frames.h"
#include "commands.h"
#include "documents.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/limits.h"
#include "meristem/base/parallel.h"
#include "meristem/base/read_file.h"
#include "meristem/document/grow.h"
#include "meristem/document/locate.h"
#include "meristem/export/formats.h"
#include "meristem/export/output_files.h"
#include "meristem/export/scan/scan_request.h"
#include "meristem/measure/foliage.h"
#include "meristem/output/scan/scan_files.h"
#include "meristem/output/write/names.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

constexpr std::string_view kInstrumentPath = "instrument.";

struct ScanCommand {
  DocumentOptions document;
  std::string instrument;
  std::vector<std::string> stations;
  std::optional<int> around;
  std::string target;
  bool ground = false;
  bool no_obstacles = false;
  double time = 0;
  std::vector<std::string> outputs;
};

/// Returns "x,y,z" as a list of numbers. Returns other texts unchanged, and the table reports them.
Value position_of(const std::string& text) {
  const Value list = parse_override("x=[" + text + "]").value;
  return list.list() != nullptr ? list : Value(text);
}

/// The file of an instrument, if one is given.
struct InstrumentFile {
  std::string path;
  std::string text;
};

/// Returns an instrument: a class by its name, JSON, or the content of a JSON file.
Value instrument_value(const std::string& given, const std::string& root, std::optional<InstrumentFile>& file) {
  if (!lower_case(given).ends_with(".json")) return parse_override("x=" + given).value;
  require_within(root, given);
  file = InstrumentFile{given, read_file(given, SizeLimits().file_bytes)};
  return parse_json_of(file->text, given);
}

void set_member(Value& object, const std::string& name, Value value) {
  if (Value* const known = object.find(name)) {
    *known = std::move(value);
  } else {
    object.object()->emplace_back(name, std::move(value));
  }
}

/// Returns the request that the options make. Values set for the instrument are removed from the values for the
/// document.
Value request_of(ScanCommand& command, std::optional<InstrumentFile>& file) {
  Value instrument = command.instrument.empty() ? Value("terrestrial")
                                                : instrument_value(command.instrument, command.document.root, file);
  std::vector<std::string> of_document;
  for (const std::string& set : command.document.sets) {
    if (!set.starts_with(kInstrumentPath)) {
      of_document.push_back(set);
      continue;
    }
    const ValueOverride given = parse_override(set);
    if (instrument.object() == nullptr) instrument = Value::Object{{"kind", instrument}};
    set_member(instrument, given.path.substr(kInstrumentPath.size()), given.value);
  }
  command.document.sets = of_document;
  Value request = Value::Object{{"instrument", instrument}};
  if (!command.stations.empty()) {
    Value::List stations;
    for (const std::string& station : command.stations) stations.push_back(position_of(station));
    set_member(request, "stations", stations);
  }
  if (command.around) set_member(request, "around", *command.around);
  if (!command.target.empty()) set_member(request, "target", position_of(command.target));
  if (command.ground) set_member(request, "ground", true);
  if (command.no_obstacles) set_member(request, "obstacles", false);
  return request;
}

/// Returns a plan. Faults are placed in the instrument's file.
ScanPlan plan_of(const Value& request, std::uint64_t seed, const std::optional<InstrumentFile>& file) {
  try {
    return plan_scan(request, seed);
  } catch (const InputError& error) {
    if (!file) throw;
    std::vector<Diagnostic> errors = error.diagnostics();
    for (Diagnostic& diagnostic : errors) {
      if (!diagnostic.path.starts_with(kInstrumentPath)) continue;
      const std::string whole = diagnostic.path;
      diagnostic.path = diagnostic.path.substr(kInstrumentPath.size());
      locate_diagnostics(file->text, std::span(&diagnostic, 1));
      if (diagnostic.line > 0) diagnostic.file = file->path;
      diagnostic.path = whole;
    }
    throw InputError(std::move(errors));
  }
}

void scan(ScanCommand command) {
  // All faults of the command line and of the document are reported before any work.
  for (const std::string& path : command.outputs) scan_format_of(path);
  const double time = film::checked_time(command.time);
  std::optional<InstrumentFile> file;
  const Value request = request_of(command, file);
  const Document document = open_document(command.document, time);
  const ScanPlan plan = plan_of(request, document.graph.seed, file);
  std::vector<std::string> inputs = input_files(document);
  if (file) inputs.push_back(file->path);
  for (const std::string& path : command.outputs) check_output(path, inputs);

  const ThreadLimit threads = limited_threads(command.document.threads, command.document.quiet);
  std::vector<Diagnostic> warnings;
  std::string summary;
  {
    TerminalProgress terminal(command.document.quiet);
    Progress& progress = terminal.progress();
    GrownDocument grown = grow_document(document, progress, {.time = time, .up_to = GrownPart::plant});
    // Pulses pass through the holes of textures.
    if (has_holes(grown.plant)) paint_plant(document, grown.plant, progress);
    warnings = grown.warnings;
    PlantLabels labels(grown.plant, document.graph.limits, progress);
    const MeshScene meshes =
        scanned_meshes(mesh_for_rays(document, std::move(grown.plant), progress), document.scene.obstacles, plan);
    const Scanner scanner(std::move(labels), meshes, plan.options, progress);
    const std::uint64_t points = write_scan(scanner, command.outputs, provenance_of(document), progress);
    summary = fmt::format("{}: {} points of {} pulses from {} {}", fmt::join(command.outputs, ", "), points,
                          scanner.pulse_count(), scanner.stations().size(),
                          plan.options.instrument.kind == ScannerClass::drone ? "lines" : "stations");
  }
  if (command.document.quiet) return;
  print_diagnostics(warnings);
  print_status(summary);
}

}  // namespace

void add_scan(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("scan", "Grow a document and scan it, as an instrument would see it");
  auto options = std::make_shared<ScanCommand>();
  options->document.add_to(*command);
  add_output_option(*command, options->outputs);
  command
      ->add_option("--instrument", options->instrument,
                   "Instrument: terrestrial, phase, drone or depth_camera; JSON such as {\"kind\": \"phase\", "
                   "\"step\": 0.1}; or a .json file; by default, terrestrial. --set instrument.step=0.1 sets a number")
      ->type_name("NAME|JSON|FILE");
  CLI::Option* const station =
      command
          ->add_option("--station", options->stations,
                       "Position of the scanner, y up; may be repeated; by default, 4 positions all around the plants")
          ->type_name("X,Y,Z")
          ->allow_extra_args(false);
  command->add_option("--around", options->around, "Number of stations all around the plants")
      ->type_name("N")
      ->excludes(station);
  command
      ->add_option("--target", options->target,
                   "Point that depth cameras look at; by default, the middle of the plants")
      ->type_name("X,Y,Z");
  command->add_flag("--ground", options->ground, "Also see a flat ground at y = 0");
  command->add_flag("--no-obstacles", options->no_obstacles, "Do not see the scene's obstacles");
  add_time_option(*command, options->time);
  command->footer(endings_of(scan_formats()) +
                  "Example: meristem scan oak -o oak.ply --set instrument.step=0.1\n"
                  "         meristem scan oak -o oak.las --instrument phase --station 8,1.6,0 --station -4,1.6,7 "
                  "--ground");
  command->callback([options, &run] { run = [options] { scan(*options); }; });
}

}  // namespace meristem::cli
