// SPDX-License-Identifier: Apache-2.0
// Scans of plants, as arrays and files.
#include "meristem/measure/scan/scan.h"

#include <memory>
#include <string>
#include <vector>

#include <pybind11/stl.h>

#include "arrays.h"
#include "call.h"
#include "document.h"
#include "meristem/export/formats.h"
#include "meristem/export/output_files.h"
#include "meristem/export/scan/scan_request.h"
#include "meristem/output/scan/scan_files.h"
#include "values.h"

namespace meristem::python {

namespace {

using PlantPointer = std::shared_ptr<PlantInPython>;

/// The request of a call's arguments.
struct ScanArguments {
  py::object instrument, stations, around, target, ground, obstacles, seed;

  Value request() const {
    Value::Object request;
    const auto add = [&](const char* name, const py::object& given) {
      if (!given.is_none()) request.emplace_back(name, to_value(given));
    };
    add("instrument", instrument);
    add("stations", stations);
    add("around", around);
    add("target", target);
    add("ground", ground);
    add("obstacles", obstacles);
    add("seed", seed);
    return request;
  }
};

/// Calls `use(scanner, progress)` with a scanner of the plant.
template <class Use>
void with_scanner(const PlantPointer& plant, const ScanArguments& arguments, int threads, const py::object& progress,
                  Use use) {
  const Document& document = plant->origin->document;
  const ScanPlan plan = plan_scan(arguments.request(), document.graph.seed);
  watch_of(progress)->run(threads, [&](Progress& inner) {
    const std::shared_ptr<const MeshScene> meshes = plant->ray_meshes(inner);
    MeshScene among_obstacles;
    const bool is_alone = !sees_obstacles(document.scene.obstacles, plan);
    if (!is_alone) among_obstacles = scanned_meshes(*meshes, document.scene.obstacles, plan);
    use(Scanner(plant->unexpanded(), document.graph.limits, is_alone ? *meshes : among_obstacles, plan.options, inner),
        inner);
  });
}

/// Returns a column over the points of a scan.
template <class T, class Part>
py::object column(const std::shared_ptr<const Scan>& scan, Part part, std::vector<py::ssize_t> inner = {}) {
  static const ScanPoint kNone;
  const ScanPoint& first = scan->points.empty() ? kNone : scan->points.front();
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(scan->points.size())};
  std::vector<py::ssize_t> strides{sizeof(ScanPoint)};
  for (const py::ssize_t count : inner) {
    shape.push_back(count);
    strides.push_back(sizeof(T));
  }
  return view(scan, reinterpret_cast<const T*>(part(first)), std::move(shape), std::move(strides));
}

/// Returns numbers, with -1 for missing values.
template <class Get>
py::object numbers(const Scan& scan, Get get) {
  std::vector<std::int64_t> made;
  made.reserve(scan.points.size());
  for (const ScanPoint& point : scan.points) {
    const std::uint32_t number = get(point);
    made.push_back(number == 0xffffffffU ? -1 : static_cast<std::int64_t>(number));
  }
  return array_of(std::move(made));
}

/// Returns the text of each point, by number, as fixed-width texts.
template <class Get>
py::object texts(const Scan& scan, const py::list& of_number, Get get) {
  std::vector<std::int64_t> chosen;
  chosen.reserve(scan.points.size());
  for (const ScanPoint& point : scan.points) chosen.push_back(get(point));
  return py::module_::import("numpy").attr("array")(of_number, "str").attr("take")(array_of(std::move(chosen)));
}

py::object labels_of(const Scan& scan) {
  py::list names;
  names.append("");
  for (const std::string& label : scan.shoot_labels) names.append(label);
  return texts(scan, names, [&](const ScanPoint& point) -> std::int64_t {
    if (point.label.shoot == kNoShoot) return 0;
    return 1 + (std::lower_bound(scan.shoots.begin(), scan.shoots.end(), point.label.shoot) - scan.shoots.begin());
  });
}

py::dict columns_of(const std::shared_ptr<const Scan>& scan) {
  py::list components;
  for (const std::string& component : scan->components) components.append(component);
  py::list kinds;
  for (const std::string_view kind : kSurfaceKindNames) kinds.append(kind);
  py::dict made;
  made["position"] = column<float>(scan, [](const ScanPoint& point) { return &point.position; }, {3});
  made["range"] = column<float>(scan, [](const ScanPoint& point) { return &point.range; });
  made["true_range"] = column<float>(scan, [](const ScanPoint& point) { return &point.true_range; });
  made["intensity"] = column<float>(scan, [](const ScanPoint& point) { return &point.intensity; });
  made["return"] = column<std::uint8_t>(scan, [](const ScanPoint& point) { return &point.number; });
  made["returns"] = column<std::uint8_t>(scan, [](const ScanPoint& point) { return &point.count; });
  made["station"] = column<std::uint32_t>(scan, [](const ScanPoint& point) { return &point.station; });
  made["pulse"] = column<std::uint64_t>(scan, [](const ScanPoint& point) { return &point.pulse; });
  made["kind"] =
      texts(*scan, kinds, [](const ScanPoint& point) { return static_cast<std::int64_t>(point.label.kind); });
  made["tree"] = numbers(*scan, [](const ScanPoint& point) { return point.label.tree; });
  made["component"] =
      texts(*scan, components, [](const ScanPoint& point) { return static_cast<std::int64_t>(point.label.component); });
  made["instance"] = column<std::uint32_t>(scan, [](const ScanPoint& point) { return &point.label.instance; });
  made["shoot"] = numbers(*scan, [](const ScanPoint& point) { return point.label.shoot; });
  made["label"] = labels_of(*scan);
  made["order"] = column<std::uint16_t>(scan, [](const ScanPoint& point) { return &point.label.order; });
  made["stations"] = rows_view<float>(scan, scan->stations);
  return made;
}

py::dict scan_plant(const PlantPointer& plant, const py::object& instrument, const py::object& stations,
                    const py::object& around, const py::object& target, const py::object& ground,
                    const py::object& obstacles, const py::object& seed, int threads, const py::object& progress) {
  auto made = std::make_shared<Scan>();
  with_scanner(plant, {instrument, stations, around, target, ground, obstacles, seed}, threads, progress,
               [&](const Scanner& scanner, Progress& inner) { *made = take_scan(scanner, inner); });
  return columns_of(made);
}

std::uint64_t save_scan(const PlantPointer& plant, const py::object& path, const py::object& instrument,
                        const py::object& stations, const py::object& around, const py::object& target,
                        const py::object& ground, const py::object& obstacles, const py::object& seed, int threads,
                        const py::object& progress) {
  const std::string file = file_of(path);
  scan_format_of(file);
  check_output(file, input_files(plant->origin->document));
  std::uint64_t points = 0;
  with_scanner(plant, {instrument, stations, around, target, ground, obstacles, seed}, threads, progress,
               [&](const Scanner& scanner, Progress& inner) {
                 points = write_scan(scanner, std::span(&file, 1), provenance_of(plant->origin->document), inner);
               });
  return points;
}

/// Adds a method of this file to the class of plants.
template <class Function, class... Extra>
void add_method(const py::object& type, const char* name, Function function, const Extra&... extra) {
  type.attr(name) = py::cpp_function(function, py::name(name), py::is_method(type), extra...);
}

}  // namespace

void bind_scan(py::module_& module) {
  const py::object plant = module.attr("Plant");
  add_method(plant, "scan", &scan_plant, py::kw_only(), py::arg("instrument") = "terrestrial",
             py::arg("stations") = py::none(), py::arg("around") = py::none(), py::arg("target") = py::none(),
             py::arg("ground") = false, py::arg("obstacles") = true, py::arg("seed") = py::none(),
             py::arg("threads") = 0, py::arg("progress") = py::none(),
             R"(Returns what an instrument would see of the plant: a dict of columns, one entry per point.

`instrument` is "terrestrial", "phase", "drone" or "depth_camera", or a dict such as {"kind": "phase", "step": 0.1}.
`stations` (k, 3) are its positions; by default, `around` (4) positions stand all around. Depth cameras look at
`target`. `ground` adds a flat ground at y = 0. The noise has `seed`, by default the document's seed.

"position" (n, 3), m; "range" as measured, "true_range" to the surface of the labels; "intensity", the returned share of
the beam; "return" of "returns" of the "pulse"; "station"; "kind": ground, wood, organ or obstacle; "tree", "component",
"instance", "shoot", "label", "order" as in the tables of skeletons and organs, -1 or empty for none; and "stations" (k,
3). Raises InputError.)");
  add_method(plant, "save_scan", &save_scan, py::arg("path"), py::kw_only(), py::arg("instrument") = "terrestrial",
             py::arg("stations") = py::none(), py::arg("around") = py::none(), py::arg("target") = py::none(),
             py::arg("ground") = false, py::arg("obstacles") = true, py::arg("seed") = py::none(),
             py::arg("threads") = 0, py::arg("progress") = py::none(),
             R"(Writes a scan to a .ply, .las or .csv file of any size. Returns the number of its points.

Arguments as in scan(). The file appears whole or not at all. Raises InputError, MachineError.)");
}

}  // namespace meristem::python
