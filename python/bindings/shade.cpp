// SPDX-License-Identifier: Apache-2.0
// Shade of facades, panels and ground, as arrays.
#include "meristem/measure/shade.h"

#include <limits>
#include <string>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "call.h"
#include "document.h"
#include "meristem/export/shade/shade_request.h"
#include "meristem/measure/foliage.h"
#include "values.h"

namespace meristem::python {

namespace {

using PlantPointer = std::shared_ptr<PlantInPython>;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Returns days or hours in the form of the command line: one, or several separated by commas.
std::string listed(const py::object& given, const char* name) {
  const auto text_of = [&](const py::handle& one) {
    const bool is_numpys_date = py::hasattr(one, "dtype") && one.attr("dtype").attr("kind").cast<std::string>() == "M";
    if (is_numpys_date) return std::string(py::str(one));
    const bool is_number = py::hasattr(one, "__float__") && !py::isinstance<py::str>(one);
    if (!is_number && !py::isinstance<py::str>(one) && !py::hasattr(one, "isoformat")) {
      throw py::type_error(fmt::format("{} must be numbers, texts or dates", name));
    }
    if (py::hasattr(one, "isoformat")) return one.attr("isoformat")().cast<std::string>();
    if (!is_number) return one.cast<std::string>();
    return fmt::format("{}", one.attr("__float__")().cast<double>());
  };
  if (py::isinstance<py::str>(given) || !py::hasattr(given, "__iter__")) return text_of(given);
  std::string all;
  for (const py::handle one : given) all += (all.empty() ? "" : ",") + text_of(one);
  return all;
}

/// Returns an array (days, hours) of `value(k)` for each moment.
template <class Get>
py::object by_moment(const ShadePlan& plan, Get value) {
  std::vector<double> values;
  for (std::size_t k = 0; k < plan.sun.size(); ++k) values.push_back(value(k));
  return array_of(std::move(values)).attr("reshape")(plan.days.size(), plan.hours.size());
}

py::object days_of(const ShadePlan& plan) {
  if (!plan.days[0].date) {
    std::vector<std::int64_t> numbers;
    for (const ShadeDay& day : plan.days) numbers.push_back(day.day);
    return array_of(std::move(numbers));
  }
  py::list dates;
  for (const ShadeDay& day : plan.days) dates.append(day.text());
  return py::module_::import("numpy").attr("array")(dates, "datetime64[D]");
}

py::object grid_of(const ShadeSurface& surface, const std::vector<double>& of_point) {
  std::vector<double> shares;
  std::size_t next = 0;
  for (const std::uint8_t has_point : surface.has_point) shares.push_back(has_point != 0 ? of_point[next++] : kNone);
  return array_of(std::move(shares)).attr("reshape")(surface.rows, surface.columns);
}

py::dict in_python(ShadePlan plan, ShadeOfSurface shade) {
  const auto moment = [&](double ShadeMoment::*member) {
    return by_moment(plan, [&](std::size_t k) { return plan.sun[k].altitude > 0 ? shade.moments[k].*member : kNone; });
  };
  py::dict result;
  result["days"] = days_of(plan);
  result["hours"] = array_of(plan.hours);
  result["solar_hours"] = by_moment(plan, [&](std::size_t k) { return plan.solar_hours[k]; });
  result["azimuth"] = by_moment(plan, [&](std::size_t k) { return degrees(plan.sun[k].azimuth); });
  result["altitude"] = by_moment(plan, [&](std::size_t k) { return degrees(plan.sun[k].altitude); });
  result["cosine"] = moment(&ShadeMoment::cosine);
  result["direct"] = moment(&ShadeMoment::direct);
  result["shade"] = moment(&ShadeMoment::shade);
  result["shade_without_plants"] = moment(&ShadeMoment::shade_without_plants);
  result["area"] = plan.surface.area;
  if (plan.surface.columns > 0) {
    result["grid"] = grid_of(plan.surface, shade.of_point);
    result["grid_without_plants"] = grid_of(plan.surface, shade.of_point_without_plants);
  }
  const auto positions = std::make_shared<const std::vector<Vec3>>(std::move(plan.surface.positions));
  result["points"] = rows_view<float>(positions, *positions);
  result["point_shade"] = array_of(std::move(shade.of_point));
  result["point_shade_without_plants"] = array_of(std::move(shade.of_point_without_plants));
  return result;
}

py::dict shade(const PlantPointer& plant, const py::object& facade, const py::object& panels, const py::object& ground,
               const py::object& days, const py::object& hours, double spacing, std::optional<double> latitude,
               std::optional<double> longitude, std::optional<double> utc_offset, int threads,
               const py::object& progress) {
  const ShadeRequest request{.facade = to_value(facade),
                             .panels = to_value(panels),
                             .ground = to_value(ground),
                             .spacing = spacing,
                             .days = listed(days, "days"),
                             .hours = listed(hours, "hours"),
                             .latitude = latitude,
                             .longitude = longitude,
                             .utc_offset = utc_offset};
  const Scene& scene = plant->origin->document.scene;
  ShadePlan plan = plan_shade(request, scene);
  ShadeOfSurface result = run_call(progress, threads, [&](Progress& inner) {
    // Light falls through the holes of textures.
    const GrownPart part = has_holes(plant->plant()) ? GrownPart::textures : GrownPart::meshes;
    return measure_shade(plan.surface, plan.sun, plant->up_to(part, inner).meshes, scene.obstacles, inner);
  });
  return in_python(std::move(plan), std::move(result));
}

}  // namespace

void bind_shade(py::module_& module) {
  module.def("shade", &shade, py::arg("plant"), py::kw_only(), py::arg("facade") = py::none(),
             py::arg("panels") = py::none(), py::arg("ground") = py::none(), py::arg("days"),
             py::arg("hours") = "0:23:1", py::arg("spacing") = 0.25, py::arg("latitude") = py::none(),
             py::arg("longitude") = py::none(), py::arg("utc_offset") = py::none(), py::arg("threads") = 0,
             py::arg("progress") = py::none(),
             R"(Returns the shaded share of a surface, by day and hour, with and without the plants: a dict.

Give one surface: `facade`, an obstacle's name or number, or {"obstacle": "house", "side": "south"}; `panels`,
{"position": [0, 3, 5], "width": 4, "length": 2, "tilt": 30, "azimuth": 180}; or `ground`, two corners [[x, z], [x, z]].
The surface is sampled at points `spacing` metres apart. `days` are numbers, dates or texts such as "80:264:14", `hours`
numbers or texts such as "15:30" and "6:20:0.5": true solar time, or clock time if `longitude` (degrees) and
`utc_offset` (hours) are given or the document's sun has them.

"days" (d,) and "hours" (h,); (d, h) "solar_hours", "azimuth", "altitude", and, nan at night, "cosine" (mean, to the
sun), "direct" (this mean with 0 in shade), "shade" and "shade_without_plants" (shares); "area" (m²); "points" (n, 3)
with the share of moments in "point_shade" and "point_shade_without_plants" (n,); for panels and ground "grid" and
"grid_without_plants" (rows, columns) from below and from the south, nan under an obstacle. Raises InputError.)");
}

}  // namespace meristem::python
