// SPDX-License-Identifier: Apache-2.0
#include "grass.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "document.h"
#include "meristem/base/limits.h"
#include "meristem/base/read_file.h"
#include "meristem/base/vec.h"
#include "meristem/shape/grass/bend_leaf.h"
#include "meristem/shape/grass/fit_leaf.h"
#include "meristem/shape/grass/measured_leaves.h"
#include "values.h"

namespace meristem::python {

namespace {

/// Returns the result of `read(text, limits)` for a file. Its faults name the file.
template <class Read>
auto read_leaves(const py::object& path, Read read) {
  const SizeLimits limits;
  const std::string file = path_of(path);
  const std::string text = read_file(file, limits.file_bytes);
  try {
    return read(text, limits);
  } catch (const InputError& error) {
    std::vector<Diagnostic> diagnostics = error.diagnostics();
    for (Diagnostic& diagnostic : diagnostics) diagnostic.file = file;
    throw InputError(std::move(diagnostics));
  }
}

/// Reads a file with a reader that may warn.
template <class Read>
std::vector<MeasuredCurve> read_warning(const py::object& path, Read read) {
  std::vector<Diagnostic> warnings;
  std::vector<MeasuredCurve> curves = read_leaves(
      path, [&](const std::string& text, const SizeLimits& limits) { return read(text, limits, warnings); });
  for (Diagnostic& warning : warnings) {
    warning.file = path_of(path);
    if (PyErr_WarnEx(PyExc_UserWarning, warning.text().c_str(), 1) != 0) throw py::error_already_set();
  }
  return curves;
}

std::vector<MeasuredCurve> midribs_of(const py::object& path) { return read_warning(path, read_midribs); }

std::vector<MeasuredCurve> widths_of(const py::object& path) { return read_warning(path, read_widths); }

/// Returns points from two columns of equal length.
MeasuredCurve curve_of(const py::object& first, const char* first_name, const py::object& second,
                       const char* second_name) {
  const std::vector<double> a = all_numbers_of(first, first_name);
  const std::vector<double> b = numbers_of(second, second_name, a.size());
  MeasuredCurve curve;
  for (std::size_t k = 0; k < a.size(); ++k) curve.points.emplace_back(a[k], b[k]);
  return curve;
}

FittedLeaf fit(const py::object& x, const py::object& y, const py::object& s, const py::object& r, double smoothing,
               double width_smoothing, int pieces) {
  const MeasuredCurve midrib = curve_of(x, "x", y, "y"), widths = curve_of(s, "s", r, "r");
  const py::gil_scoped_release release;
  return fit_leaf(midrib, widths, {.smoothing = smoothing, .width_smoothing = width_smoothing, .pieces = pieces});
}

GrassLeafPointer make_leaf(double length, double width, const py::object& s, const py::object& x, const py::object& y,
                           const py::object& r) {
  auto leaf = std::make_shared<GrassLeaf>();
  leaf->length = length;
  leaf->width = width;
  leaf->s = all_numbers_of(s, "s");
  leaf->x = numbers_of(x, "x", leaf->s.size());
  leaf->y = numbers_of(y, "y", leaf->s.size());
  leaf->r = numbers_of(r, "r", leaf->s.size());
  check_grass_leaf(*leaf);
  return leaf;
}

bool are_leaves_equal(const GrassLeaf& leaf, const py::object& other) {
  if (!py::isinstance<GrassLeaf>(other)) return false;
  const auto& second = other.cast<const GrassLeaf&>();
  return leaf.length == second.length && leaf.width == second.width && leaf.s == second.s && leaf.x == second.x &&
         leaf.y == second.y && leaf.r == second.r;
}

py::tuple state_of_leaf(const GrassLeaf& leaf) {
  return py::make_tuple(leaf.length, leaf.width, leaf.s, leaf.x, leaf.y, leaf.r);
}

/// Not checked, because a leaf that has not emerged has no length.
GrassLeafPointer leaf_from(const py::tuple& state) {
  if (state.size() != 6) throw py::value_error("not the state of a GrassLeaf");
  using Numbers = std::vector<double>;
  return std::make_shared<GrassLeaf>(GrassLeaf{state[0].cast<double>(), state[1].cast<double>(),
                                               state[2].cast<Numbers>(), state[3].cast<Numbers>(),
                                               state[4].cast<Numbers>(), state[5].cast<Numbers>()});
}

template <std::vector<double> GrassLeaf::*list>
py::array_t<double> list_of(const GrassLeafPointer& leaf) {
  return column_view(leaf, (*leaf).*list);
}

void bind_measured(py::module_& module) {
  using Pointer = std::shared_ptr<MeasuredCurve>;
  py::class_<MeasuredCurve, Pointer>(module, "MeasuredCurve", "A measured midrib, or measured widths along a blade.")
      .def_property_readonly(
          "rank", [](const MeasuredCurve& c) { return c.rank; },
          "Rank of the leaf on its stem, or of a class of ranks; None if the file gives no rank.")
      .def_property_readonly(
          "lindex", [](const MeasuredCurve& c) { return c.lindex; },
          "Number of the leaf within its rank; None if the file gives no number.")
      .def_property_readonly(
          "age", [](const MeasuredCurve& c) { return c.age; }, "Its age; None where the file says none.")
      .def_property_readonly(
          "points", [](const Pointer& c) { return rows_view<double>(c, c->points); },
          "(n, 2) float64: x and y of a midrib, s and r of widths, in the unit of the file.")
      .def_property_readonly(
          "lines", [](const Pointer& c) { return column_view(c, c->lines); },
          "(n,) int32: the line of each point in the file, from 1.")
      .def("__len__", [](const MeasuredCurve& c) { return c.points.size(); })
      .def("__repr__", [](const MeasuredCurve& c) {
        return fmt::format("<meristem.grass.MeasuredCurve of {} points>", c.points.size());
      });
  refuse_new<MeasuredCurve>("read_midribs() and read_widths() make them");

  module.def("read_midribs", &midribs_of, py::arg("path"), R"(Reads digitised midribs. Returns a list of MeasuredCurve.

The file is a table with the columns x and y (away from the stem and up, in any unit). The columns rank, lindex and age
are optional. Consecutive rows with equal rank, lindex and age make one midrib. A point that repeats the previous point
is left out, with a UserWarning that names leaf and line. Raises InputError with all faults, each with its file and
line: missing columns, cells that are not numbers, midribs of fewer than 3 points.)");
  module.def("read_widths", &widths_of, py::arg("path"), R"(Reads widths along blades. Returns a list of MeasuredCurve.

The file is a table with the columns s (distance from the base) and r (width, or share of the largest width). The
columns rank or rankclass, and lindex, are optional. Widths that run from the tip to the base are reversed, and
positions that repeat the previous position are left out, each with a UserWarning. Raises InputError like read_midribs,
and for positions that are not sorted and widths below 0.)");
}

void bind_fit(py::module_& module) {
  py::class_<FittedLeaf, std::shared_ptr<FittedLeaf>>(module, "FittedLeaf",
                                                      "A leaf fitted to measured points, and how well it fits.")
      .def_property_readonly(
          "leaf", [](const std::shared_ptr<FittedLeaf>& f) { return GrassLeafPointer(f, &f->leaf); }, "The GrassLeaf.")
      .def_property_readonly(
          "midrib_length", [](const FittedLeaf& f) { return f.midrib_length; },
          "Length of the fitted midrib, in the unit of its points.")
      .def_property_readonly(
          "polyline_length", [](const FittedLeaf& f) { return f.polyline_length; },
          "Length of the digitised points joined by lines.")
      .def_property_readonly(
          "distance", [](const FittedLeaf& f) { return f.distance; },
          "Root mean square distance of the digitised points from the fitted midrib.")
      .def_property_readonly(
          "was_turned", [](const FittedLeaf& f) { return f.was_turned; },
          "True if the widths ran from the tip to the base, and were reversed.")
      .def("__repr__", [](const FittedLeaf& f) {
        return fmt::format("<meristem.grass.FittedLeaf: length {:.4g}, width {:.4g}>", f.leaf.length, f.leaf.width);
      });
  refuse_new<FittedLeaf>("fit_leaf() makes them");

  const FitOptions plain;
  module.def("fit_leaf", &fit, py::arg("x"), py::arg("y"), py::arg("s"), py::arg("r"), py::kw_only(),
             py::arg("smoothing") = plain.smoothing, py::arg("width_smoothing") = plain.width_smoothing,
             py::arg("pieces") = plain.pieces,
             R"(Fits smoothing splines to a digitised midrib and to the widths along a blade. Returns a FittedLeaf.

`x` and `y` (n,) are the midrib's points, away from the stem and up. The leaf begins at the first point. `s` and `r`
(m,) are distances from the base and the widths there. Midrib and widths are each scaled by their own length. If `s`
ends at 1, it contains shares of the length, and the length comes from the midrib. Otherwise the last `s` is the blade's
length. If `r` contains shares of the largest width, the leaf's width is 1.

`smoothing` is the allowed distance of the midrib from its points, root mean square, as a share of its length (0:
straight lines between the points). `width_smoothing` is the allowed distance of the widths, as a share of the largest
width. The leaf has `pieces` (at least 2) equal pieces. Raises InputError for points that are no midrib or no widths,
with the row, and TypeError and ValueError for wrong arrays and options.)");
}

}  // namespace

std::vector<double> all_numbers_of(const py::object& object, const char* name) {
  const py::array array = py::array::ensure(object);
  PyErr_Clear();  // numbers_of reports the fault
  return numbers_of(object, name, array && array.ndim() > 0 ? static_cast<std::size_t>(array.shape(0)) : 0);
}

std::vector<double> in_degrees(std::vector<double> angles) {
  for (double& angle : angles) angle *= 180 / kPi;
  return angles;
}

void bind_grass(py::module_& module) {
  py::class_<GrassLeaf, GrassLeafPointer>(module, "GrassLeaf",
                                          R"(A grass leaf, seen from its side: its midrib in a plane, and its widths.

`length` is the length of the midrib and `width` the largest width, metres. The four lists have one number per point of
the midrib, at least two points, from the collar at (0, 0) to the tip. `s` is the position along the midrib, from 0 to
1. `x` is the distance away from the stem and `y` along it, in lengths. `r` is the width as a share of the largest
width. Arrays are read-only, and every stage returns a new leaf. Raises TypeError and ValueError.)")
      .def(py::init(&make_leaf), py::arg("length"), py::arg("width"), py::arg("s"), py::arg("x"), py::arg("y"),
           py::arg("r"))
      .def_property_readonly(
          "length", [](const GrassLeaf& l) { return l.length; }, "Length of the midrib, metres.")
      .def_property_readonly(
          "width", [](const GrassLeaf& l) { return l.width; }, "Width at the widest, metres.")
      .def_property_readonly("s", &list_of<&GrassLeaf::s>, "(n,) float64: position along the midrib, from 0 to 1.")
      .def_property_readonly("x", &list_of<&GrassLeaf::x>, "(n,) float64: away from the stem, in lengths.")
      .def_property_readonly("y", &list_of<&GrassLeaf::y>, "(n,) float64: along the stem, in lengths.")
      .def_property_readonly("r", &list_of<&GrassLeaf::r>, "(n,) float64: width as a share of the largest width.")
      .def_property_readonly(
          "area", [](const GrassLeaf& l) { return area(l); },
          "Area of the blade in square metres, by a trapezium for each piece of the midrib.")
      .def_property_readonly(
          "angles", [](const GrassLeaf& l) { return array_of(in_degrees(piece_angles(l))); },
          "(n - 1,) float64: direction of each piece in degrees away from the stem: 0 along the stem, 90 level, 180 "
          "straight down, and larger if a midrib rolls up.")
      .def_property_readonly(
          "inclination", [](const GrassLeaf& l) { return inclination(l) * 180 / kPi; },
          "Degrees at which it leaves the stem.")
      .def("__len__", [](const GrassLeaf& l) { return l.point_count(); })
      .def("__eq__", &are_leaves_equal, py::arg("other"), "Whether both have the same numbers.")
      .def(py::pickle(&state_of_leaf, &leaf_from))
      .def("__repr__", [](const GrassLeaf& l) {
        return fmt::format("<meristem.grass.GrassLeaf of {} points: length {:.4g}, width {:.4g}>", l.point_count(),
                           l.length, l.width);
      });
  module.def(
      "resampled",
      [](const GrassLeaf& leaf, int pieces) {
        if (pieces < 1) throw py::value_error("a leaf has at least 1 piece");
        return resampled(leaf, static_cast<std::size_t>(pieces));
      },
      py::arg("leaf"), py::arg("pieces"), "Returns the leaf with `pieces` pieces of equal length along the midrib.");
  module.def(
      "widths_by_area", [](const GrassLeaf& leaf) { return array_of(widths_by_area(leaf)); }, py::arg("leaf"),
      "Returns (n,) float64: the widths as shares of their mean along the leaf, instead of shares of the largest "
      "width.");
  bind_measured(module);
  bind_fit(module);
}

}  // namespace meristem::python
