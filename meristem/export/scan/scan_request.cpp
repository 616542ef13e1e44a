// SPDX-License-Identifier: Apache-2.0
// Reads requests for scans with tables of parameters, which check names, types and ranges.
#include "meristem/export/scan/scan_request.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/limits.h"
#include "meristem/base/seed.h"
#include "meristem/graph/table/reader.h"
#include "meristem/graph/table/table.h"
#include "meristem/output/picture/obstacle_meshes.h"

namespace meristem {

namespace {

const std::vector<std::string>& class_names() {
  static const std::vector<std::string> names{"terrestrial", "phase", "drone", "depth_camera"};
  return names;
}

/// Returns the class that a request names. Its values are the defaults of the instrument.
ScannerClass class_in(const Value& request) {
  const Value* const instrument = request.find("instrument");
  const Value* const kind =
      instrument == nullptr || instrument->text() != nullptr ? instrument : instrument->find("kind");
  if (kind == nullptr || kind->text() == nullptr) return ScannerClass::terrestrial;
  for (std::size_t k = 0; k < class_names().size(); ++k) {
    if (class_names()[k] == *kind->text()) return static_cast<ScannerClass>(k);
  }
  return ScannerClass::terrestrial;  // the table reports the error
}

void check_instrument(const ScanInstrument& instrument, const DocumentPath& path, ParameterReader& reader) {
  if (!(instrument.highest > instrument.lowest)) {
    reader.add_error(DocumentPath(path, "highest"), "the sweeps would have no height",
                     fmt::format("an angle above {:.6g}°", degrees(instrument.lowest)));
  }
  if (!(instrument.farthest > instrument.nearest)) {
    reader.add_error(DocumentPath(path, "farthest"), "no distance would be within the range",
                     fmt::format("metres above {:.6g}", instrument.nearest));
  }
}

const ParameterTable& options_table() {
  constexpr NumberRange kPlace{.unit = Unit::metre, .min = -1e5, .max = 1e5, .usual = {-20, 20}};
  static const ParameterTable table =
      Table<ScanOptions>("a scan", "A scan of the plants by an instrument.")
          .object("instrument", &ScanOptions::instrument, instrument_table,
                  "Class of the scanner by its name, or an object with numbers that differ from those of its class.")
          .positions("stations", &ScanOptions::stations, kPlace,
                     "Positions of the scanner; by default, positions all around the plants.")
          .integer("around", &ScanOptions::around, {.min = 1, .max = 1000, .usual = {1, 8}},
                   "Number of stations all around the plants where no stations are given.")
          .vector("target", &ScanOptions::target, kPlace,
                  "Point that depth cameras look at; by default, the middle of the plants.")
          .boolean("ground", &ScanOptions::ground, "Whether the scanner also sees a flat ground at y = 0.")
          .integer("seed", &ScanOptions::seed, {.min = 0, .max = kLargestSeed, .usual = {0, 100}},
                   "Seed of the noise; by default, the document's seed.");
  return table;
}

}  // namespace

const ParameterTable& instrument_table() {
  constexpr NumberRange kAngle{.unit = Unit::degree, .min = -90, .max = 90};
  static const ParameterTable table =
      Table<ScanInstrument>("an instrument",
                            "A scanner: the ways it looks, the width of its beam, and what it measures.")
          .choice("kind", &ScanInstrument::kind, class_names(),
                  "Class of the scanner, which gives the other parameters their defaults.")
          .number("step", &ScanInstrument::step, {.unit = Unit::degree, .min = 0.001, .max = 45, .usual = {0.01, 1}},
                  "Angle from one pulse to the next; of a drone, across its line. Raised, there are fewer points.")
          .number("lowest", &ScanInstrument::lowest, kAngle, "Lowest angle above the horizon that sweeps reach.")
          .number("highest", &ScanInstrument::highest, kAngle, "Highest angle above the horizon that sweeps reach.")
          .number("field", &ScanInstrument::field, {.unit = Unit::degree, .min = 0.1, .max = 170, .usual = {30, 120}},
                  "Angle across the line of a drone or across the picture of a depth camera.")
          .integer("columns", &ScanInstrument::columns, {.min = 1, .max = 20000, .usual = {160, 1280}},
                   "Number of pixels across the picture of a depth camera.")
          .integer("rows", &ScanInstrument::rows, {.min = 1, .max = 20000, .usual = {120, 800}},
                   "Number of pixels down the picture of a depth camera.")
          .number("altitude", &ScanInstrument::altitude,
                  {.unit = Unit::metre, .min = 0, .max = 10000, .usual = {10, 120}, .above_min = true},
                  "Height of a drone above y = 0.")
          .number("line_spacing", &ScanInstrument::line_spacing,
                  {.unit = Unit::metre, .min = 0.1, .max = 10000, .usual = {5, 50}},
                  "Distance between the parallel lines that a drone flies over the plants.")
          .number("advance", &ScanInstrument::advance,
                  {.unit = Unit::metre, .min = 0.001, .max = 100, .usual = {0.01, 0.5}},
                  "Distance that a drone flies between sweeps across its line. Raised, there are fewer points.")
          .number("heading", &ScanInstrument::heading, {.unit = Unit::degree, .min = -360, .max = 360},
                  "Azimuth of the lines of a drone, from north (0) over east (90).")
          .number("divergence", &ScanInstrument::divergence, {.min = 0, .max = 100, .usual = {0, 3}},
                  "Full angle of the beam in milliradians, at 1/e² of its strength. Raised, edges of twigs and leaves "
                  "mix more.")
          .number("exit_diameter", &ScanInstrument::exit_diameter,
                  {.unit = Unit::metre, .min = 0, .max = 1, .usual = {0, 0.02}},
                  "Diameter of the beam at the instrument, at 1/e² of its strength.")
          .integer("rays", &ScanInstrument::rays, {.min = 1, .max = 200, .usual = {1, 37}},
                   "Number of rays that stand for a beam. Raised, returns are finer and the scan takes longer.")
          .integer("returns", &ScanInstrument::returns, {.min = 1, .max = 15, .usual = {1, 5}},
                   "Largest number of returns per pulse; the nearest ones are kept.")
          .number("resolution", &ScanInstrument::resolution,
                  {.unit = Unit::metre, .min = 0, .max = 1000, .usual = {0, 2}},
                  "Distance along the beam within which surfaces make one return, at their mean distance.")
          .number("threshold", &ScanInstrument::threshold, {.min = 0, .max = 1, .usual = {0, 0.5}},
                  "Least share of the beam that makes a return. Raised, thin twigs vanish.")
          .number("noise", &ScanInstrument::noise, {.unit = Unit::metre, .min = 0, .max = 10, .usual = {0, 0.05}},
                  "Standard deviation of measured distances.")
          .number("noise_growth", &ScanInstrument::noise_growth, {.min = 0, .max = 1, .usual = {0, 0.01}},
                  "Growth of the noise with the square of the distance, in metres per square metre.")
          .number("nearest", &ScanInstrument::nearest, {.unit = Unit::metre, .min = 0, .max = 10000, .usual = {0, 5}},
                  "Least distance that can be measured.")
          .number("farthest", &ScanInstrument::farthest,
                  {.unit = Unit::metre, .min = 0.01, .max = 10000, .usual = {1, 500}},
                  "Greatest distance that can be measured.")
          .only_where({{"kind", {"terrestrial", "phase", "drone"}}}, {"step"})
          .only_where({{"kind", {"terrestrial", "phase"}}}, {"lowest", "highest"})
          .only_where({{"kind", {"drone", "depth_camera"}}}, {"field"})
          .only_where({{"kind", {"depth_camera"}}}, {"columns", "rows"})
          .only_where({{"kind", {"drone"}}}, {"altitude", "line_spacing", "advance", "heading"})
          .check(check_instrument)
          .shorthand("kind");
  return table;
}

const ParameterTable& scan_table() {
  static const ParameterTable table =
      Table<ScanPlan>("a scan", "A scan of the plants by an instrument.")
          .members(&ScanPlan::options, options_table())
          .boolean("obstacles", &ScanPlan::obstacles, "Whether the scanner also sees the scene's visible obstacles.")
          .never_with("stations", {"around"})
          .check([](const ScanPlan& plan, const DocumentPath& path, ParameterReader& reader) {
            const ScannerClass kind = plan.options.instrument.kind;
            if (kind == ScannerClass::drone && !plan.options.stations.empty()) {
              reader.add_error(DocumentPath(path, "stations"),
                               "a drone flies lines over the plants and has no stations",
                               "the instrument's altitude, line_spacing and heading instead");
            }
            if (kind != ScannerClass::depth_camera && plan.options.target) {
              reader.add_error(DocumentPath(path, "target"), "only depth cameras look at a target",
                               "an instrument of the kind depth_camera");
            }
          });
  return table;
}

ScanPlan plan_scan(const Value& request, std::uint64_t seed) {
  ScanPlan plan;
  plan.options.seed = seed;
  plan.options.instrument = instrument_of(class_in(request));
  if (request.is_null()) return plan;
  ParameterReader reader({}, SizeLimits());
  reader.read(scan_table(), &plan, request, DocumentPath());
  if (plan.options.instrument.kind == ScannerClass::drone && request.find("around") != nullptr) {
    const DocumentPath top;
    reader.add_error(DocumentPath(top, "around"), "a drone flies lines over the plants and has no stations around them",
                     "the instrument's altitude, line_spacing and heading instead");
  }
  if (reader.error_count() > 0) throw InputError(reader.take_diagnostics());
  return plan;
}

bool sees_obstacles(const Obstacles& obstacles, const ScanPlan& plan) {
  return plan.obstacles && has_visible(obstacles);
}

MeshScene scanned_meshes(MeshScene meshes, const Obstacles& obstacles, const ScanPlan& plan) {
  return sees_obstacles(obstacles, plan) ? with_obstacles(std::move(meshes), obstacles) : std::move(meshes);
}

}  // namespace meristem
