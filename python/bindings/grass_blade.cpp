// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/grass/grass_blade.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "document.h"
#include "grass.h"
#include "meristem/base/diagnostic.h"
#include "meristem/shape/grass/reduce_leaf.h"

namespace meristem::python {

namespace {

constexpr std::int64_t kMaxAcross = 1000;

using OrderPointer = std::shared_ptr<ReductionOrder>;

OrderPointer order_of(const GrassLeaf& leaf, const std::vector<py::object>& also) {
  std::vector<std::vector<double>> lists;
  for (std::size_t k = 0; k < also.size(); ++k) {
    lists.push_back(numbers_of(also[k], fmt::format("also[{}]", k).c_str(), leaf.point_count()));
  }
  return std::make_shared<ReductionOrder>(reduction_order(leaf, lists));
}

std::vector<std::uint32_t> kept_points(const ReductionOrder& order, int pieces) {
  if (pieces < 1) throw py::value_error("a leaf has at least 1 piece");
  return points_kept(order, static_cast<std::size_t>(pieces));
}

std::vector<std::uint32_t> points_of_error(const ReductionOrder& order, double error) {
  if (!(error >= 0)) throw py::value_error("the error of a reduction is at least 0");
  return points_within(order, error);
}

/// Returns the points chosen by the caller: rising indices that include both ends.
std::vector<std::uint32_t> chosen_points(const GrassLeaf& leaf, const py::object& points) {
  const auto count = static_cast<std::size_t>(py::len(points));
  const auto last = static_cast<std::int64_t>(leaf.point_count()) - 1;
  const std::vector<std::int64_t> given = whole_numbers_of(points, "points", count, 0, last);
  for (std::size_t k = 1; k < given.size(); ++k) {
    if (given[k] <= given[k - 1]) throw py::value_error(fmt::format("points[{}] does not rise", k));
  }
  if (given.empty() || given.front() != 0 || given.back() != last) {
    throw py::value_error(fmt::format("points must begin with 0 and end with {}", last));
  }
  return {given.begin(), given.end()};
}

GrassLeaf reduce(const GrassLeaf& leaf, const std::optional<int>& pieces, const std::optional<double>& error,
                 const py::object& points) {
  if (int{pieces.has_value()} + int{error.has_value()} + int{!points.is_none()} != 1) {
    throw py::type_error("give one of pieces, error and points");
  }
  if (pieces) return reduced(leaf, kept_points(reduction_order(leaf), *pieces));
  if (error) return reduced(leaf, points_of_error(reduction_order(leaf), *error));
  return reduced(leaf, chosen_points(leaf, points));
}

/// Returns a linear curve from (n, 2) numbers.
Curve curve_of(const py::object& object, const char* name) {
  const py::array given = py::array::ensure(object);
  PyErr_Clear();
  if (!given || given.ndim() != 2 || given.shape(1) != 2) {
    throw py::value_error(fmt::format("{} must have shape (n, 2)", name));
  }
  const auto count = static_cast<std::size_t>(given.shape(0));
  const std::vector<double> numbers = numbers_of(given.attr("reshape")(-1), name, 2 * count);
  std::vector<Vec2> points;
  for (std::size_t k = 0; k < count; ++k) points.emplace_back(numbers[2 * k], numbers[2 * k + 1]);
  return Curve(std::move(points), CurveKind::linear);
}

EdgeWaves waves_of(const py::dict& given) {
  EdgeWaves waves;
  const std::array<std::pair<std::string, double EdgeWaves::*>, 4> members{{{"number", &EdgeWaves::number},
                                                                            {"depth", &EdgeWaves::depth},
                                                                            {"left", &EdgeWaves::left},
                                                                            {"right", &EdgeWaves::right}}};
  std::vector<std::string> names;
  for (const auto& [name, member] : members) names.push_back(name);
  for (const auto& [key, value] : given) {
    const std::string name = py::str(key);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      throw InputError(Diagnostic{.message = fmt::format("'{}' is not a part of waves", name),
                                  .expected = "number, depth, left or right",
                                  .nearest = nearest_name(name, names)});
    }
    const auto k = static_cast<std::size_t>(found - names.begin());
    waves.*members[k].second = k < 2 ? value.cast<double>() : radians(value.cast<double>());
  }
  return waves;
}

std::function<DVec3(double, double)> displacement_of(const py::object& displace) {
  if (displace.is_none()) return {};
  if (PyCallable_Check(displace.ptr()) == 0) throw py::type_error("displace must be something to call with (s, u)");
  return [displace](double s, double u) {
    const py::object moved = displace(s, u);
    const std::vector<double> numbers = numbers_of(moved, "what displace gives", 3);
    return DVec3(numbers[0], numbers[1], numbers[2]);
  };
}

std::shared_ptr<Mesh> blade_of(const GrassLeaf& leaf, double twist, const py::object& twist_along, double fold,
                               double roll, const py::dict& waves, int across, double clasp, double clasp_radius,
                               const py::object& displace) {
  if (across > kMaxAcross) throw py::value_error(fmt::format("across is at most {}", kMaxAcross));
  GrassBlade blade{.twist = radians(twist),
                   .fold = radians(fold),
                   .roll = radians(roll),
                   .waves = waves_of(waves),
                   .across = across,
                   .clasp = clasp,
                   .clasp_radius = clasp_radius,
                   .displace = displacement_of(displace)};
  if (!twist_along.is_none()) blade.twist_along = curve_of(twist_along, "twist_along");
  return std::make_shared<Mesh>(make_grass_blade(leaf, blade));
}

void bind_reduction(py::module_& module) {
  py::class_<ReductionOrder, OrderPointer>(module, "ReductionOrder",
                                           R"(The order in which the inner points of a leaf can be removed.

One order gives all levels of detail, so the points of a coarser level are also points of the finer levels.)")
      .def_property_readonly(
          "points", [](const OrderPointer& o) { return column_view(o, o->points); },
          "(n - 2,) uint32: all points except both ends, in the order of their removal.")
      .def_property_readonly(
          "errors", [](const OrderPointer& o) { return column_view(o, o->errors); },
          "(n - 2,) float64: largest error up to each removal, as a share of the length or width.")
      .def("__len__", [](const ReductionOrder& o) { return o.points.size(); })
      .def("__repr__", [](const ReductionOrder& o) {
        return fmt::format("<meristem.grass.ReductionOrder of {} points>", o.points.size());
      });
  refuse_new<ReductionOrder>("reduction_order() makes them");

  module.def("reduction_order", &order_of, py::arg("leaf"), py::arg("also") = py::list(),
             R"(Returns the ReductionOrder of a leaf. The point nearest to the chord between its present neighbours is
removed first.

The error combines the errors of (x, y) and of (s, r). `also` are further lists of a number per point, as shares of the
length, which count in this way too.)");
  module.def(
      "points_kept", [](const ReductionOrder& o, int pieces) { return array_of(kept_points(o, pieces)); },
      py::arg("order"), py::arg("pieces"),
      "Returns (pieces + 1,) uint32: the points that stay for `pieces` pieces, at least 1.");
  module.def(
      "points_within", [](const ReductionOrder& o, double error) { return array_of(points_of_error(o, error)); },
      py::arg("order"), py::arg("error"),
      "Returns the points that stay if no removal may have an error above `error`, uint32.");
  module.def("reduced", &reduce, py::arg("leaf"), py::kw_only(), py::arg("pieces") = py::none(),
             py::arg("error") = py::none(), py::arg("points") = py::none(),
             R"(Returns the leaf with fewer points, widened so that its area stays.

Give one of three arguments: `pieces`, the number of pieces that stay; `error`, the largest allowed error; or `points`,
the indices of the points that stay, including both ends. Raises TypeError and ValueError.)");
}

}  // namespace

void bind_grass_blade(py::module_& module) {
  bind_reduction(module);
  const GrassBlade plain;
  module.def("make_grass_blade", &blade_of, py::arg("leaf"), py::kw_only(), py::arg("twist") = 0.0,
             py::arg("twist_along") = py::none(), py::arg("fold") = 0.0, py::arg("roll") = 0.0,
             py::arg("waves") = py::dict(), py::arg("across") = plain.across, py::arg("clasp") = 0.0,
             py::arg("clasp_radius") = 0.0, py::arg("displace") = py::none(),
             R"(Returns the blade over all points of a leaf as a Mesh with normals and uvs. Its front face is up.

Its collar is at the origin, y along the stem, and the midrib leads away to -z. `twist` is the torsion about the midrib
from base to tip, and `twist_along` (n, 2) is the reached share of it over 0 to 1. `fold` raises each half about the
midrib. `roll` bends the section from edge to edge at the largest width. All three are degrees. `waves` of the edges is
a dict of `number` from base to tip, `depth` as a share of half the width, and the phases `left` and `right`, degrees.
`across` is the number of quads from edge to edge, even. Over the first `clasp` of its length the blade unrolls from a
circle with the radius `clasp_radius` in metres. `displace` is called with (s, u), u from -0.5 to 0.5. It returns three
numbers by which a point moves: away from the stem, along it and across, in widths of the blade.

An end with width 0 is one point: a leaf of n pieces with `across` 2 has 4 n - 2 triangles. Raises TypeError,
ValueError, and InputError for other keys of waves.)");
  module.def(
      "make_sheath", [](double open) { return std::make_shared<Mesh>(make_sheath(radians(open))); }, py::arg("open"),
      "Returns a sheath: an open tube of radius 1 from the collar at the origin down to y = -1, open at +z by `open` "
      "degrees.");
  module.def(
      "make_ligule", [] { return std::make_shared<Mesh>(make_ligule()); },
      "Returns a ligule: a membrane on the upper rim of such a sheath, 1 high in its middle.");
}

}  // namespace meristem::python
